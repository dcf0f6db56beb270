// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/start_page.h"
#include "theme/theme.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace moldwright {

/// What the user likes, kept between sessions.
namespace preferences {

[[nodiscard]] ThemeChoice themeChoice();
void setThemeChoice(ThemeChoice choice);

/// Language as "en" or "de"; empty follows the desktop.
[[nodiscard]] QString language();
void setLanguage(const QString& language);

/// Id of the navigation scheme.
[[nodiscard]] QString navigation();
void setNavigation(const QString& id);

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
