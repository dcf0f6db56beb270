// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QStringList>

#include <string>

namespace moldwright {

/// The contexts that core's MW_TEXT sentences are marked with.
[[nodiscard]] const QStringList& sentenceContexts();

/// A sentence or word of the core in the language that is spoken; as it is where it is none, or has no
/// translation.
[[nodiscard]] std::string inSpokenLanguage(const std::string& english);

} // namespace moldwright
