// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/parting_line.h"

#include <array>
#include <vector>

namespace moldwright {

/// A face that the surface has or not, by which regions are filled.
struct ChoiceFace {
    std::array<int, 3> corners{};
    std::uint8_t label = 1;
    int source = -1;  ///< face of the part; −1: filling makes it
    int made = -1;    ///< there only where this region is filled; −1: whatever is
    int covered = -1; ///< there only where this region is not filled; −1: whatever is
};

/// All the surfaces that filling some regions and leaving others makes of a part. A face between two regions
/// is there twice, once for either being filled alone.
struct ChoiceMesh {
    std::vector<Eigen::Vector3d> points;
    std::vector<int> partPoint; ///< per point: the point of the part it is, −1 for a new one
    std::vector<ChoiceFace> faces;
    int regions = 0;
};

/// The choice between a part and the part filled, region by region: where the meshes agree there is nothing
/// to choose; faces that differ fall into regions where they hang together. Points are equal where their
/// coordinates are.
[[nodiscard]] ChoiceMesh choicesBetween(const PartedMesh& part, const PartedMesh& filled);

/// Whether a face takes part in the boundary of a region's space, and how: 1 as it is, −1 turned over, 0 not.
[[nodiscard]] inline int bounds(const ChoiceFace& face, int region) {
    return face.made == region ? 1 : face.covered == region && face.made < 0 ? -1 : 0;
}

/// Space between the part and the filled part, per region, in cubed units of the mesh.
[[nodiscard]] std::vector<double> volumesOf(const ChoiceMesh& choices);

/// Gives regions new numbers: `number` says which; −1 leaves a region as the part has it, beyond choice.
void renumber(ChoiceMesh& choices, const std::vector<int>& number);

/// Leaves what fills no more than `nothing` (cubed units) as the part has it, beyond choice; numbers the rest
/// by falling volume. Returns the new numbers, −1 for what is left.
std::vector<int> numberByVolume(ChoiceMesh& choices, double nothing);

/// The same, keeping a mark per region.
void numberByVolume(ChoiceMesh& choices, std::vector<char>& marks, double nothing);

/// Divides a region into spaces that do not hang together. Returns the regions that it has become.
std::vector<int> separateShells(ChoiceMesh& choices, int region);

/// The surface with those regions filled that are marked; its points are all of the choices', sourceFace as
/// there. `choiceOf`: per face of it, the face of the choices.
[[nodiscard]] PartedMesh surfaceWith(const ChoiceMesh& choices, const std::vector<char>& filled,
                                     std::vector<int>& choiceOf);

} // namespace moldwright
