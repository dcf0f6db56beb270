// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold_settings.h"

#include <Eigen/Geometry>

#include <optional>

namespace moldwright {

/// The box that both halves are cut from, mold's frame, mm; on the grid, centred in x over the origin.
using Block = Eigen::AlignedBox3d;

/// What the block must hold.
struct BlockContent {
    Eigen::AlignedBox3d cavities; ///< of all copies
    double wallX = 5;             ///< steel at the faces left and right
    double wallY = 5;             ///< at the face below, and above without a spout
    double spoutTop = 0;          ///< y that the upper face must reach; below the wall's: none
    Eigen::AlignedBox2d byHand;   ///< what stands where a hand put it, with the steel to its outside
};

/// Walls, floor and ceiling at least, sizes rounded up to the settings' step; length and width to the next of
/// the stock, if there is one. None where the stock is too small.
[[nodiscard]] std::optional<Block> blockAround(const BlockContent& content, const MoldSettings& settings,
                                               double grid);

} // namespace moldwright
