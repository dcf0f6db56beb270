// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <vector>

namespace moldwright {

/// A round hole through one mold half from the cavity outwards, along the half's removal direction. What
/// stands in it, an ejector pin or a sprue that breaks off, does not leave with the cast: only the half is
/// cut by it.
struct HalfBore {
    /// One section: across the direction it is a circle.
    struct Station {
        double height = 0; ///< mm from the parting plane, ascending; the first lies inside the cast
        double radius = 0; ///< mm
    };
    /// What stands in it while the mold is closed.
    enum class Use {
        Pin,  ///< an ejector pin: nothing fills the hole
        Spout ///< what is poured: it solidifies, breaks off and is pushed out outwards
    };
    Use use = Use::Pin;
    int side = 1;
    Eigen::Vector2d axis = Eigen::Vector2d::Zero(); ///< where its axis meets the parting plane, mm
    std::vector<Station> stations;
    double flare = 0; ///< how much wider the last section is than the one before, mm per mm of height
    double tip = 0;   ///< mm: height of the cavity over the plane at its axis
    int number = 0;   ///< among those of its name, from 0

    /// Where the axis is at a height over the plane, mm; d: the half's removal direction, unit.
    [[nodiscard]] Eigen::Vector3d at(double height, const Eigen::Vector3d& d) const;

    /// The hole closed, all points on the grid, the last section in the block's face exactly. Its polygons
    /// lie round the circles, so that a pin of that diameter fits.
    [[nodiscard]] IndexedMesh solid(const Eigen::Vector3d& d, double grid) const;
};

} // namespace moldwright
