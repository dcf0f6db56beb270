// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace moldwright {

/// The commands, by their ids, that the menu of a row of the project tree offers; an empty one parts them.
[[nodiscard]] QStringList commandsOfRow(const QString& row);

} // namespace moldwright
