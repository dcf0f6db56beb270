// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// Marks a sentence for people so that the translation tools find it: context, then English text.
#define MW_TEXT(context, text) text

namespace moldwright {

/// A sentence for people: an English template with places {0}, {1}, … and what stands in them.
/// Core never shows text; the window translates the template first and fills the places afterwards.
struct Message {
    std::string text;
    std::vector<std::string> arguments;

    /// The sentence in English.
    [[nodiscard]] std::string english() const { return fill(text); }

    /// `translated` (a translation of `text`) with its places filled.
    [[nodiscard]] std::string fill(const std::string& translated) const;

    bool operator==(const Message&) const = default;
};

/// A number as people read it: at most `digits` significant digits, no trailing zeros, '.' as decimal point.
[[nodiscard]] std::string readable(double value, int digits = 4);

} // namespace moldwright
