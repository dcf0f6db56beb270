// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// Points collected one by one as a mesh has them: n×3.
[[nodiscard]] inline Points pointRows(const std::vector<Eigen::Vector3d>& points) {
    Points rows(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        rows.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
    return rows;
}

} // namespace moldwright
