// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/closest_point.h"
#include "mesh/indexed_mesh.h"
#include "mesh/point_groups.h"
#include "mold/block.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace moldwright {

/// One hollow of the mold, for measuring the steel about it. Hollows that share a joint are one another's
/// neighbours by design and are not compared.
struct Hollow {
    std::string name;
    SharedMesh mesh;                                  ///< in coordinates of its own
    Eigen::Vector2d offset = Eigen::Vector2d::Zero(); ///< where it stands, mm
    std::vector<int> joints;                          ///< numbers of the joints it takes part in
    bool opensOutside = false;                        ///< its distance from the block's faces means nothing
    int number = 0;                                   ///< among those of its name, from 1
    bool each = false;   ///< its steel is told of for itself, not together with all of its name
    bool byHand = false; ///< a hand put it here: it may stand in the way of others
};

/// Whether they share a joint, so that no steel is between them.
[[nodiscard]] bool areJoined(const Hollow& a, const Hollow& b);

/// Steel at its thinnest, mm, between two hollows or one and the outside of the block.
struct ThinSteel {
    double thickness = 0;                            ///< 0 where they meet
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< mm, mold's frame: on the first hollow
    std::string first;
    std::string second; ///< "outside" for the block's faces
    int firstNumber = 0;
    int secondNumber = 0; ///< 0: the outside

    bool operator==(const ThinSteel&) const = default;
};

/// Trees of boxes about the faces of hollows and groups of their points, kept for the next measuring of the
/// same meshes.
class SteelTrees {
public:
    SteelTrees();
    ~SteelTrees();
    SteelTrees(SteelTrees&&) noexcept;
    SteelTrees& operator=(SteelTrees&&) noexcept;

    /// Makes what is missing of those about these hollows, side by side; the others are forgotten.
    void prepare(const std::vector<Hollow>& hollows);
    /// Precondition: prepared.
    [[nodiscard]] const ClosestPoint& of(const SharedMesh& mesh) const { return m_known.at(mesh)->faces; }
    [[nodiscard]] const std::vector<PointGroup>& groupsOf(const SharedMesh& mesh) const {
        return m_known.at(mesh)->points;
    }

private:
    struct Known {
        ClosestPoint faces;
        std::vector<PointGroup> points;
    };
    std::map<SharedMesh, std::unique_ptr<Known>> m_known;
};

/// The thinnest steel of each pair of hollows, thinnest first; those that are not told of each for itself
/// count as one of their name. Distances from the points of each hollow to the faces of the other, both ways:
/// exact where one of the nearest two places is a point of its mesh, as it is unless two edges pass each
/// other askew; then it is too large by less than their faces are wide. Pairs further apart than `furthest`
/// mm are left out.
[[nodiscard]] std::vector<ThinSteel> thinnestSteel(const std::vector<Hollow>& hollows, const Block& block,
                                                   double furthest, SteelTrees& trees);

/// Of each pair of names the thinnest; thinnest first, as `steel` is.
[[nodiscard]] std::vector<ThinSteel> byNames(const std::vector<ThinSteel>& steel);

} // namespace moldwright
