// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/start_page.h"
#include "theme/theme.h"

#include <QByteArray>
#include <QKeySequence>
#include <QLocale>
#include <QString>

#include <optional>
#include <vector>

namespace moldwright {

/// What the user likes, kept between sessions.
namespace preferences {

[[nodiscard]] ThemeChoice themeChoice();
void setThemeChoice(ThemeChoice choice);

/// Language as in languages(); empty follows the desktop.
[[nodiscard]] QString language();
void setLanguage(const QString& language);
/// Of that language.
[[nodiscard]] QLocale locale();

/// Id of the navigation scheme.
[[nodiscard]] QString navigation();
void setNavigation(const QString& id);

/// Keys that the user gave a command instead of the table's; nothing: the table's. No keys at all is a choice
/// too.
[[nodiscard]] std::optional<QKeySequence> keysOf(const QString& command);
void setKeysOf(const QString& command, const std::optional<QKeySequence>& keys);

/// What new parts begin with.
struct Defaults {
    double draftDegrees = 1;
    double maxTiltDegrees = 30;
    double wall = 5; ///< mm, of the mold: beside, over and under the cavity
};
[[nodiscard]] Defaults defaults();
void setDefaults(const Defaults& defaults);

[[nodiscard]] std::vector<RecentFile> recentFiles();
void addRecentFile(const QString& file);
void clearRecentFiles();

/// Geometry and docks of the window.
[[nodiscard]] QByteArray layout(const QString& name);
void setLayout(const QString& name, const QByteArray& layout);

/// Where files were opened or written last.
[[nodiscard]] QString folder();
void setFolderOf(const QString& file);

} // namespace preferences
} // namespace moldwright
