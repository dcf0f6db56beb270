// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"
#include "castability/mold_state.h"
#include "features/plan_shape.h"
#include "mesh/indexed_mesh.h"

#include <array>
#include <optional>
#include <vector>

namespace moldwright {

/// What every feature of a mold is made from: a body on a polygon of the parting plane, with walls that lean
/// inwards as far as the removal directions ask, and a flat lid. A spout or runner stands on both sides of
/// the plane, a key and its socket on one. Where it opens into the block's face or into a wider channel it
/// has no wall: its section ends there, and both sides of the joint have the same points, to the bit.
struct DraftedPrism {
    /// A foot without a wall, and the plane that the section ends in: vertical, or the other channel's wall,
    /// whose slope is given for side 1 and 2 as the inset of *that* wall.
    struct Opening {
        std::size_t edge = 0;
        std::array<double, 2> slope{0, 0};
    };

    PlanShape base; ///< on the plane
    std::vector<Opening> openings;
    std::array<double, 2> height{0, 0}; ///< mm on side 1 and 2; 0: nothing there
    std::array<PlanShape, 2> lid;       ///< per side: the lid's corner over each of the base; empty without
    std::array<std::vector<double>, 2> slope; ///< per side and edge: inset over height
    double grid = 0;                          ///< mm that all coordinates are multiples of

    [[nodiscard]] Eigen::Vector3d foot(std::size_t k) const { return {base[k].x(), base[k].y(), 0}; }
    [[nodiscard]] Eigen::Vector3d top(int side, std::size_t k) const;
    [[nodiscard]] bool stands(int side) const { return !lid[side == 1 ? 0 : 1].empty(); }
};

/// The prism elsewhere in the plane; `by` in mm, a multiple of its grid.
[[nodiscard]] DraftedPrism movedPrism(DraftedPrism prism, const Eigen::Vector2d& by);

/// What is asked of a prism.
struct PrismRequest {
    PlanShape base;
    std::vector<DraftedPrism::Opening> openings;
    std::array<double, 2> height{0, 0};
    /// Per side: the directions that its walls must leave along.
    std::array<std::vector<Eigen::Vector3d>, 2> directions;
    double draftDegrees = 5;
    /// Per side, where they are known: how far each wall leans, inset over height; the directions are not
    /// asked.
    std::array<std::vector<double>, 2> slopes;
    double leastSlope = -1e3; ///< walls lean at least this much, even where a tilted direction asks for less
    double grid = 0;          ///< mm, a power of two; all points are rounded to multiples of it
    Message closed;           ///< told of a lid that closes too early; by itself it speaks of a channel
};

/// The prism, or why there is none: walls that would have to lie flat (Impossible), or a lid that closes
/// before the height is reached because the base is too narrow (Impossible).
[[nodiscard]] Result<DraftedPrism> draftedPrism(const PrismRequest& request);

/// The same with the greatest height at which a lid remains whose width is at least a fifth of the base's, if
/// the height asked for is too much. Errors: Impossible.
[[nodiscard]] Result<DraftedPrism> prismAsHighAsFits(PrismRequest request);

/// A prism that opens into a wall of another.
struct Guest {
    std::size_t edge = 0;                            ///< of the host's base
    const DraftedPrism* prism = nullptr;             ///< opens by its first opening
    Eigen::Vector2d moved = Eigen::Vector2d::Zero(); ///< where it stands, mm from its own coordinates
};

/// Walls and lid on one side, looking outwards; open at the plane and at the opening, and where guests open
/// into a wall. None where guests overlap or reach beyond the wall.
[[nodiscard]] std::optional<IndexedMesh> prismSurface(const DraftedPrism& prism, int side,
                                                      const std::vector<Guest>& guests = {});

/// The whole body closed: both sides, its flat foot where it stands on one side only, and the section at its
/// opening.
[[nodiscard]] std::optional<IndexedMesh> prismSolid(const DraftedPrism& prism);

/// The sections' borders at the openings: foot and top at either end, on both sides. Faces with all corners
/// among these close a solid there.
[[nodiscard]] std::vector<Eigen::Vector3d> openingPoints(const DraftedPrism& prism);

/// `value` as the nearest multiple of the grid.
[[nodiscard]] double onGrid(double value, double grid);

} // namespace moldwright
