// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace moldwright {

/// The reader's language: a text marked by MW_TEXT goes in as it stands in English, and comes out in that
/// language with its places filled. Without a translation it stays English.
class Phrases {
public:
    using Translation = std::function<std::string(const std::string& english)>;

    Phrases() = default;
    explicit Phrases(Translation translation) : m_translation(std::move(translation)) {}

    [[nodiscard]] std::string operator()(const std::string& english,
                                         const std::vector<std::string>& arguments = {}) const {
        return Message{m_translation ? m_translation(english) : english, arguments}.english();
    }

private:
    Translation m_translation;
};

} // namespace moldwright
