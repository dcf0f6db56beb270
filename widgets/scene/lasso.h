// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "scene/camera.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace moldwright {
class Task;
}

namespace moldwright::scene {

/// A closed line drawn in a view, and what the view looked at.
struct Lasso {
    std::vector<Eigen::Vector2d> line; ///< device pixels, y downwards; its ends are joined
    Camera camera;
    ViewSize view;
    std::optional<PartingPlane> cut; ///< what lies before it is not seen
};

/// Whether a pixel is inside the line, counted by crossings.
[[nodiscard]] bool isInside(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& pixel);

/// The faces whose middle is seen inside the lasso, ascending; none where the task was stopped. About 10 µs a
/// face inside it.
[[nodiscard]] std::vector<int> facesIn(const Lasso& lasso, const SharedMesh& mesh, const Task& task);

} // namespace moldwright::scene
