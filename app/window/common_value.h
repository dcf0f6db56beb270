// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QVariant>

#include <algorithm>
#include <vector>

namespace moldwright {

/// What a number field shows for several things: their value where it is the same for all, else none. See
/// PropertyPanel::setValue(). Precondition: `numbers` is not empty.
template <class ValueOf>
[[nodiscard]] QVariant common(const std::vector<int>& numbers, ValueOf valueOf) {
    const double first = valueOf(numbers.front());
    const bool same = std::ranges::all_of(numbers, [&](int number) { return valueOf(number) == first; });
    return same ? QVariant(first) : QVariant();
}

} // namespace moldwright
