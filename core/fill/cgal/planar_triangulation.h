// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace moldwright {

/// A triangulation of the convex hull of points in which given segments are edges, or chains of edges where
/// they cross others or pass through points. Triangles run counter-clockwise, exactly.
struct PlanarTriangulation {
    std::vector<Eigen::Vector2d> points; ///< those given, then those where segments cross, rounded to doubles
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 3>> neighbours; ///< across the edge from corner k to k+1; −1 outside the hull
    std::vector<std::array<char, 3>> onSegment; ///< whether that edge lies on a segment
};

/// The constrained Delaunay triangulation (CGAL, exact predicates) of points and segments between them.
/// Precondition: no two points coincide.
[[nodiscard]] PlanarTriangulation triangulatePlane(const std::vector<Eigen::Vector2d>& points,
                                                   const std::vector<std::array<int, 2>>& segments);

/// The same, and for each segment the points along it, its ends included.
struct CrossedSegments {
    PlanarTriangulation triangulation;
    std::vector<std::vector<int>> chains;
};
[[nodiscard]] CrossedSegments crossSegments(const std::vector<Eigen::Vector2d>& points,
                                            const std::vector<std::array<int, 2>>& segments);

} // namespace moldwright
