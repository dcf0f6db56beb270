// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace moldwright {

/// The lines of a text, one after the other; they may end as on Unix, Windows or old Macs. A byte-order mark
/// at the start is skipped.
class TextLines {
public:
    explicit TextLines(std::string_view text);

    /// Steps to the next line; false at the end.
    bool next();

    [[nodiscard]] std::string_view line() const { return m_line; }
    [[nodiscard]] int number() const { return m_number; } ///< of the line, from 1

    /// What follows the current line.
    [[nodiscard]] std::string_view rest() const { return m_rest; }

private:
    std::string_view m_rest;
    std::string_view m_line;
    int m_number = 0;
};

/// Takes the first word (between blanks) off `line`; empty when there is none.
std::string_view takeWord(std::string_view& line);

/// The number that `word` spells, all of it, with '.' as decimal point; none when it does not, when it is not
/// finite, or beyond the range of T.
[[nodiscard]] std::optional<double> realNumber(std::string_view word);
[[nodiscard]] std::optional<long long> wholeNumber(std::string_view word);

/// `word` in lower case (ASCII).
[[nodiscard]] std::string lowerCase(std::string_view word);

/// The beginning of foreign text, fit to be shown in a sentence.
[[nodiscard]] std::string shown(std::string_view foreign);

/// True when `bytes` could be text: they hold no zero byte at the start.
[[nodiscard]] bool looksLikeText(std::string_view bytes);

} // namespace moldwright
