// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

namespace moldwright {

/// The number in the id of a row or property that begins with `before`; −1 where it begins otherwise.
[[nodiscard]] inline int numberAfter(const QString& before, const QString& id) {
    return id.startsWith(before) ? id.mid(before.size()).toInt() : -1;
}

} // namespace moldwright
