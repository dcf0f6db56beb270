// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace moldwright::test {

/// What stops a piece of a side's surface from ever being a graph over the plane.
enum class PieceVerdict { Free, Closed, Handle, Arch, Pocket };

/// A connected piece of one side, judged from the labelled faces alone: Euler characteristic, boundary walks,
/// their turning numbers and how they lie in one another.
struct LabelledPiece {
    int side = 0;
    int faces = 0;
    int euler = 0;          ///< of the piece as a surface with boundary
    std::vector<int> turns; ///< per boundary walk, seen from the side; 1: counter-clockwise once
    int wound = 0;          ///< how many clockwise walks the only counter-clockwise one winds round
    Eigen::AlignedBox3d box;

    [[nodiscard]] int genus() const { return (2 - static_cast<int>(turns.size()) - euler) / 2; }
    [[nodiscard]] PieceVerdict verdict() const;
};

/// The pieces of a closed mesh in the plane's frame. It shares no code with what it judges: edges are found
/// by sorting, pieces grow by faces joined across them, walks turn about the points that they pass.
std::vector<LabelledPiece> labelledPieces(const IndexedMesh& mesh, const std::vector<std::uint8_t>& labels);

} // namespace moldwright::test
