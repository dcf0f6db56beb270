// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/parting_line.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace moldwright {

/// How a part is laid on an exact grid, half by half: sheared so that the half's removal direction is square
/// to the plane, side 2 mirrored so that it opens upwards too, and scaled to whole numbers. On the grid sums
/// and products of differences are exact in doubles, so that what lies left of what is never in doubt.
class ShadowGrid {
public:
    /// `mesh` and directions in the plane's frame.
    ShadowGrid(const IndexedMesh& mesh, const Directions& directions);

    /// Where x is seen along the side's direction, rounded to the grid.
    [[nodiscard]] Eigen::Vector2d shadow(const Eigen::Vector3d& x, int side) const;

    /// Height above the plane as the side sees it, in grid steps, not rounded.
    [[nodiscard]] double height(const Eigen::Vector3d& x, int side) const;

    /// The point of the plane's frame at a height above a point of the grid.
    [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector2d& shadow, double height, int side) const;

    [[nodiscard]] double step() const { return m_step; } ///< width of the grid, in the mesh's unit

    /// How the points of a side's half move in the plane per height.
    [[nodiscard]] Eigen::Vector2d run(int side) const {
        return (side == 1 ? 1 : -1) * m_slope[static_cast<std::size_t>(side - 1)];
    }

    /// Shadows lie within ±reach.
    static constexpr double reach = 16777216;

private:
    [[nodiscard]] Eigen::Vector2d sheared(const Eigen::Vector3d& x, int side) const;

    std::array<Eigen::Vector2d, 2> m_slope; ///< run per rise of d1 and d2
    Eigen::Vector2d m_centre = Eigen::Vector2d::Zero();
    double m_step = 1;
};

/// Twice the signed area of the triangle a, b, c: positive when it runs counter-clockwise. Exact on the grid.
[[nodiscard]] inline double doubleArea(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                       const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// A face that looks along the removal direction, as seen along it: its corners counter-clockwise.
struct ShadowFace {
    std::array<int, 3> node{};
    std::array<double, 3> height{};
    int source = 0; ///< face of the parted mesh
};

/// An edge of such faces.
struct ShadowEdge {
    std::array<int, 2> node{};
    std::array<double, 2> height{};
    std::array<int, 2> face = {-1, -1}; ///< which faces it bounds; −1: a face that looks elsewhere

    /// Where the surface turns away from the direction: only such an edge can begin to hide what is below.
    [[nodiscard]] bool silhouette() const { return face[0] < 0 || face[1] < 0; }
};

/// What a half shows to an eye far out along its removal direction, before asking what hides what. Points
/// with the same shadow share a node, so that a wall along the direction is a single line.
struct ProjectedHalf {
    std::vector<Eigen::Vector2d> nodes; ///< on the grid
    std::vector<ShadowFace> faces;
    std::vector<ShadowEdge> edges;
    std::vector<char> inPlane; ///< per node: whether a point of the parting line is seen there
    std::vector<int> nodeOf;   ///< per point of the mesh, −1 for one that belongs to no such face

    [[nodiscard]] const Eigen::Vector2d& corner(const ShadowFace& face, std::size_t k) const {
        return nodes[static_cast<std::size_t>(face.node[k])];
    }
    [[nodiscard]] const Eigen::Vector2d& end(const ShadowEdge& edge, std::size_t k) const {
        return nodes[static_cast<std::size_t>(edge.node[k])];
    }
};

/// The faces of one side of `part` (plane's frame) that look along its direction.
[[nodiscard]] ProjectedHalf projectHalf(const PartedMesh& part, int side, const ShadowGrid& grid);

/// Height of a face above p, by its plane, held between its lowest and highest corner.
[[nodiscard]] double heightAt(const ProjectedHalf& half, const ShadowFace& face, const Eigen::Vector2d& p);

} // namespace moldwright
