// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <vector>

namespace moldwright {

/// A simple polygon in the parting plane, counter-clockwise seen from side 1; mm, mold's frame.
using PlanShape = std::vector<Eigen::Vector2d>;

/// The convex outline of points seen along z; no three of its points lie on one line. O(n log n).
[[nodiscard]] PlanShape planHull(const Points& V);

/// Least distance between the areas of two polygons, mm; 0 where they meet.
[[nodiscard]] double planDistance(const PlanShape& a, const PlanShape& b);

/// The same of a place from the area of a polygon.
[[nodiscard]] double planDistanceTo(const PlanShape& shape, const Eigen::Vector2d& p);

/// Whether they are at least `distance` apart; quick where their boxes are.
[[nodiscard]] bool planKeepsClear(const PlanShape& a, const PlanShape& b, double distance);

/// Whether p lies inside.
[[nodiscard]] bool insidePlan(const PlanShape& shape, const Eigen::Vector2d& p);

[[nodiscard]] PlanShape movedPlan(PlanShape shape, const Eigen::Vector2d& by);

/// A regular polygon of `corners` whose corners lie on the circle.
[[nodiscard]] PlanShape planCircle(const Eigen::Vector2d& centre, double radius, int corners);

/// The rectangle between two corners.
[[nodiscard]] PlanShape planRectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high);

/// Unit vector that points out of the shape across an edge; edge k runs from corner k to the next.
[[nodiscard]] Eigen::Vector2d outwardNormal(const PlanShape& shape, std::size_t edge);

/// A shape with each edge moved inwards by its inset, mm, outwards where that is below 0; corners stand where
/// the moved edges meet.
[[nodiscard]] PlanShape insetShape(const PlanShape& shape, const std::vector<double>& insets);

} // namespace moldwright
