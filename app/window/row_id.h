// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <algorithm>
#include <vector>

namespace moldwright {

/// The number in the id of a row or property that begins with `before`; −1 where it begins otherwise, or is
/// that of several (see selection.h).
[[nodiscard]] inline int numberAfter(const QString& before, const QString& id) {
    bool isNumber = false;
    const int number = id.mid(before.size()).toInt(&isNumber);
    return isNumber && id.startsWith(before) ? number : -1;
}

/// The numbers of all ids of that kind among these, which spaces part, ascending.
[[nodiscard]] inline std::vector<int> numbersAfter(const QString& before, const QString& ids) {
    std::vector<int> numbers;
    for (const QString& id : ids.split(u' '))
        if (const int number = numberAfter(before, id); number >= 0)
            numbers.push_back(number);
    std::ranges::sort(numbers);
    return numbers;
}

} // namespace moldwright
