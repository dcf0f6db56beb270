// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "features/plan_shape.h"

namespace moldwright::test {

/// Area of a polygon, mm²; negative where it runs clockwise.
inline double planArea(const PlanShape& shape) {
    double doubled = 0;
    for (std::size_t k = 0; k < shape.size(); ++k) {
        const Eigen::Vector2d& a = shape[k];
        const Eigen::Vector2d& b = shape[(k + 1) % shape.size()];
        doubled += a.x() * b.y() - a.y() * b.x();
    }
    return doubled / 2;
}

} // namespace moldwright::test
