// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "features/drafted_prism.h"
#include "mold/mold_settings.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace moldwright {

/// What both halves are cut from, mold's frame, mm: a drafted prism on a convex outline of the parting plane
/// with a flat back on either side. Its walls are upright, or have a draft of their own.
struct Block {
    DraftedPrism body; ///< all coordinates on the grid

    [[nodiscard]] bool empty() const { return body.base.empty(); }
    /// z of the back of half `side`.
    [[nodiscard]] double end(int side) const { return side == 1 ? body.height[0] : -body.height[1]; }
    /// Round the outline in the parting plane.
    [[nodiscard]] Eigen::AlignedBox2d plan() const;
    /// Round all of it.
    [[nodiscard]] Eigen::AlignedBox3d box() const;
    [[nodiscard]] double volume() const;
    /// Distance of a point inside from the nearest outer face, mm; below 0 outside.
    [[nodiscard]] double depthOf(const Eigen::Vector3d& p) const;
    /// The least of all places in a box; none in it has less, to the bit.
    [[nodiscard]] double depthOf(const Eigen::AlignedBox3d& box) const;
    /// The same of a place in the plane from the walls, where they come nearest at any height.
    [[nodiscard]] double depthOf(const Eigen::Vector2d& p) const;
    /// The wall (edge of the outline) that all three points lie on but for `tolerance` mm, if one does.
    [[nodiscard]] std::optional<std::size_t> wallWith(const std::array<Eigen::Vector3d, 3>& points,
                                                      double tolerance) const;
    /// How much the wall whose foot looks most along m goes outwards, mm per mm of height, on side 1 and 2.
    [[nodiscard]] std::array<double, 2> flare(const Eigen::Vector2d& m) const;
};

/// How much an outer wall whose foot looks along m goes outwards, mm per mm of height, on side 1 and 2.
/// Errors: Impossible, where it would have to lie flat.
[[nodiscard]] Result<std::array<double, 2>> outerFlare(const Eigen::Vector2d& m, const MoldSettings& settings,
                                                       const Directions& directions);

/// A box about the origin's plane, its walls upright, its points as they are.
[[nodiscard]] Block uprightBlock(const Eigen::AlignedBox3d& box);

/// What the block must hold.
struct BlockContent {
    Eigen::AlignedBox3d cavities;         ///< of all copies
    std::array<double, 2> channels{0, 0}; ///< how far those in the plane reach into each half, mm
    double wallX = 5;                     ///< steel at the faces left and right
    double wallY = 5;                     ///< at the face below, and above without a spout
    double spoutTop = 0;                  ///< y that the upper face must reach; below the wall's: none
    Eigen::AlignedBox2d byHand;           ///< what stands where a hand put it, with the steel to its outside
};

/// What a block is held to besides.
struct BlockRules {
    Directions directions;
    double grid = 0;
};

/// Walls, floor and ceiling at least, the least steel behind channels; sizes in the parting plane rounded up
/// to the settings' step; length and width to the next of the stock, if there is one. The outline is a
/// rectangle, centred in x over the origin. Errors: Impossible where the stock is too small, or a wall cannot
/// have the draft.
[[nodiscard]] Result<Block> blockAround(const BlockContent& content, const MoldSettings& settings,
                                        const BlockRules& rules);

/// Steel that a shape in the plane keeps to the block's walls, mm.
struct KeptInside {
    PlanShape shape;
    double steel = 0;
};

/// The block cut down to what it holds: of its outline only what lies within walls in 32 directions that keep
/// their steel to all of `content`. Convex; the middle half of its lower edge stays, for it to stand on.
/// Errors: Impossible.
[[nodiscard]] Result<Block> shellOf(const Block& block, const std::vector<KeptInside>& content,
                                    const MoldSettings& settings, const BlockRules& rules);

} // namespace moldwright
