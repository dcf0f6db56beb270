// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "mold/mold.h"

#include <array>
#include <vector>

namespace moldwright {

/// Seven classes of steel for showing it: what is below the limit, then in steps of half of it.
struct SteelScale {
    static constexpr int classes = 7;
    double limit = 2; ///< mm; 0: none is asked for, and nothing is below it

    [[nodiscard]] double step() const { return limit > 0 ? limit / 2 : 1; }
    /// mm, where a class begins.
    [[nodiscard]] double from(int c) const { return c == 0 ? 0 : limit + (c - 1) * step(); }
    [[nodiscard]] int classOf(double thickness) const;
};

/// How much steel there is behind the walls of a mold half.
struct SteelMap {
    /// The half in the mold's frame, its walls cut into faces small enough to show it.
    SharedMesh surface;
    /// mm, per face, at the thinnest of its corners: to the nearest hollow that the face's own is not joined
    /// with, or to the outside; `beyond` where there is more. Below 0: the face is no wall of a hollow.
    std::vector<double> thickness;
    SteelScale scale;
    std::array<double, SteelScale::classes> areas{}; ///< mm²
    double least = 0;                                ///< mm
    Eigen::Vector3d leastPlace = Eigen::Vector3d::Zero();

    /// More is not measured, mm.
    [[nodiscard]] double beyond() const { return scale.from(SteelScale::classes - 1) + scale.step(); }
};

/// The map of half 1 or 2. Each face belongs to the hollow that it lies nearest to, and the steel is measured
/// as thinnestSteel() does between hollows, but from everywhere on the wall. Errors: Cancelled.
[[nodiscard]] Result<SteelMap> steelMap(const Mold& mold, int side, const Task& task = {});

} // namespace moldwright
