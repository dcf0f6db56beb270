// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <span>
#include <vector>

namespace moldwright {

/// Faces with any number of corners over a list of points, as mesh files hold them.
struct PolygonSoup {
    std::vector<Eigen::Vector3d> points;
    std::vector<int> corners;           ///< of all polygons, one after the other
    std::vector<int> firstCorner = {0}; ///< polygon p has the corners firstCorner[p] … firstCorner[p+1]−1

    [[nodiscard]] int polygonCount() const { return static_cast<int>(firstCorner.size()) - 1; }
    [[nodiscard]] std::span<const int> polygon(int p) const {
        const auto at = static_cast<std::size_t>(p);
        return std::span(corners).subspan(static_cast<std::size_t>(firstCorner[at]),
                                          static_cast<std::size_t>(firstCorner[at + 1] - firstCorner[at]));
    }
    /// Ends the polygon whose corners were appended to `corners`.
    void endPolygon() { firstCorner.push_back(static_cast<int>(corners.size())); }
};

/// More corners than this in one face are refused by the readers: their triangulation takes quadratic time.
constexpr int mostCorners = 2048;

/// The soup with each polygon cut into triangles inside it, also where it is concave, by clipping ears in the
/// polygon's own plane (Newell's normal), the best shaped first. Precondition: corners index points, and each
/// polygon has 3 to mostCorners of them.
[[nodiscard]] IndexedMesh triangulated(const PolygonSoup& soup);

} // namespace moldwright
