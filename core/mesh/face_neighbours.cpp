// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/face_neighbours.h"

#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace moldwright {

FaceNeighbours::FaceNeighbours(SharedMesh mesh)
    : m_mesh(std::move(mesh)), m_first(static_cast<std::size_t>(m_mesh->vertexCount()) + 2, 0),
      m_faces(static_cast<std::size_t>(m_mesh->F.size())) {
    // Counted one place too far on, so that filling moves each beginning to where it belongs.
    for (int f = 0; f < m_mesh->faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            ++m_first[static_cast<std::size_t>(m_mesh->F(f, k)) + 2];
    for (std::size_t v = 2; v < m_first.size(); ++v)
        m_first[v] += m_first[v - 1];
    for (int f = 0; f < m_mesh->faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            m_faces[m_first[static_cast<std::size_t>(m_mesh->F(f, k)) + 1]++] = f;
}

int FaceNeighbours::across(int f, int k) const {
    const int a = m_mesh->F(f, k);
    const int b = m_mesh->F(f, (k + 1) % 3);
    for (const int other : around(a))
        if (other != f && (m_mesh->F.row(other).array() == b).any())
            return other;
    return -1;
}

std::vector<int> smoothPatch(const FaceNeighbours& neighbours, int f, double creaseDegrees) {
    const IndexedMesh& mesh = neighbours.mesh();
    const double least = std::cos(creaseDegrees * std::numbers::pi / 180);
    const auto isSmooth = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return creaseDegrees >= 180 || a.dot(b) >= least * a.norm() * b.norm();
    };
    std::vector<char> taken(static_cast<std::size_t>(mesh.faceCount()), 0);
    std::vector<int> patch = {f};
    taken[static_cast<std::size_t>(f)] = 1;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        const Eigen::Vector3d normal = doubleAreaVector(mesh, patch[i]);
        for (int k = 0; k < 3; ++k) {
            const int other = neighbours.across(patch[i], k);
            if (other < 0 || taken[static_cast<std::size_t>(other)] ||
                !isSmooth(normal, doubleAreaVector(mesh, other)))
                continue;
            taken[static_cast<std::size_t>(other)] = 1;
            patch.push_back(other);
        }
    }
    std::ranges::sort(patch);
    return patch;
}

} // namespace moldwright
