// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/parting_line.h"

#include <array>

namespace moldwright::scene {

std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> partingSegments(const IndexedMesh& mesh,
                                                                         const PartingPlane& plane) {
    const Eigen::VectorXd height = (mesh.V * plane.normal).array() - plane.offset;
    const double onPlane = 1e-7 * (1 + height.cwiseAbs().maxCoeff());
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> segments;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        // A point on the plane counts as below, so each crossing shows on exactly the faces it passes.
        std::array<Eigen::Vector3d, 2> ends;
        int found = 0;
        for (int k = 0; k < 3 && found < 2; ++k) {
            const int a = mesh.F(f, k);
            const int b = mesh.F(f, (k + 1) % 3);
            const bool aAbove = height[a] > onPlane;
            const bool bAbove = height[b] > onPlane;
            if (aAbove == bAbove)
                continue;
            const double t = height[a] / (height[a] - height[b]);
            ends[found++] = mesh.point(a) + std::clamp(t, 0.0, 1.0) * (mesh.point(b) - mesh.point(a));
        }
        if (found == 2 && (ends[0] - ends[1]).squaredNorm() > 0)
            segments.emplace_back(ends[0], ends[1]);
    }
    return segments;
}

} // namespace moldwright::scene
