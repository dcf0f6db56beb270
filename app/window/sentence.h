// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <QString>

namespace moldwright {

/// A core sentence in the user's language.
[[nodiscard]] QString sentence(const Message& message);
[[nodiscard]] QString sentence(const std::string& english);

/// The same where arguments may be words of the program, too: names of features, of materials.
[[nodiscard]] QString sentenceWithWords(Message message);

/// The first sentence of a text, which says what happened, and the rest, which says what to do.
struct HeadAndRest {
    QString headline;
    QString rest;
};
[[nodiscard]] HeadAndRest headAndRest(const QString& text);

} // namespace moldwright
