// SPDX-License-Identifier: AGPL-3.0-or-later
#include "filled_checks.h"

#include "castability/topology.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace moldwright::test {

void expectSound(const FilledPart& filled, const Directions& directions) {
    const PartedMesh& surface = filled.surface;
    const MeshDiagnosis found = diagnose(surface.mesh);
    EXPECT_TRUE(found.closed);
    EXPECT_TRUE(found.manifold);
    EXPECT_TRUE(found.oriented);
    EXPECT_TRUE(found.selfIntersections.empty());
    ASSERT_EQ(surface.labels.size(), static_cast<std::size_t>(surface.mesh.faceCount()));
    ASSERT_EQ(surface.sourceFace.size(), surface.labels.size());
    ASSERT_EQ(filled.sourceVertex.size(), static_cast<std::size_t>(surface.mesh.vertexCount()));
    const double size = diagonal(surface.mesh);
    for (int f = 0; f < surface.mesh.faceCount(); ++f) {
        const int side = surface.labels[static_cast<std::size_t>(f)];
        // Twice the area as seen along d: a thin face's normal may be off, but not what it hides.
        EXPECT_GE(doubleAreaVector(surface.mesh, f).dot(directions.of(side)), -1e-14 * size * size);
        for (int k = 0; k < 3; ++k)
            EXPECT_GE(surface.mesh.corner(f, k).z() * (side == 1 ? 1 : -1), 0);
    }
    for (const auto& [a, b] : partingEdges(surface.mesh, surface.labels))
        EXPECT_EQ(surface.mesh.V(a, 2), 0);
    EXPECT_TRUE(topologyAllowsCasting(surface.mesh, surface.labels));
}

int facesShort(const FilledPart& filled, const Directions& directions, double degrees) {
    int count = 0;
    for (int f = 0; f < filled.surface.mesh.faceCount(); ++f) {
        const Eigen::Vector3d normal = doubleAreaVector(filled.surface.mesh, f).normalized();
        const int side = filled.surface.labels[static_cast<std::size_t>(f)];
        count += draftDegrees(normal.dot(directions.of(side))) < degrees ? 1 : 0;
    }
    return count;
}

std::vector<double> crossings(const IndexedMesh& mesh, const Eigen::Vector2d& foot,
                              const Eigen::Vector3d& d) {
    std::vector<double> heights;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        std::array<Eigen::Vector2d, 3> p;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d x = mesh.corner(f, k);
            p[static_cast<std::size_t>(k)] = x.head<2>() - x.z() / d.z() * d.head<2>() - foot;
        }
        const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
            return a.x() * b.y() - a.y() * b.x();
        };
        const double a = cross(p[1], p[2]);
        const double b = cross(p[2], p[0]);
        const double c = cross(p[0], p[1]);
        if (std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0)
            continue;
        if (a + b + c != 0)
            heights.push_back(
                (a * mesh.corner(f, 0).z() + b * mesh.corner(f, 1).z() + c * mesh.corner(f, 2).z()) /
                (a + b + c));
    }
    std::sort(heights.begin(), heights.end());
    return heights;
}

} // namespace moldwright::test
