// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace moldwright {

/// A language the window speaks: its code as in the names of the translations, its name in itself.
struct Language {
    QString code;
    QString name;
};

/// English first, then all that there is a translation for.
[[nodiscard]] inline std::vector<Language> languages() {
    return {{QStringLiteral("en"), QStringLiteral("English")},
            {QStringLiteral("de"), QStringLiteral("Deutsch")},
            {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
}

} // namespace moldwright
