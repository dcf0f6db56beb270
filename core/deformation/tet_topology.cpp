// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/tet_topology.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace moldwright {

namespace {

/// A face of a tetrahedron by its sorted corners, so that the two that share it meet when sorted.
struct TetFace {
    std::array<int, 3> corners;
    int tet;
    int opposite;

    bool operator<(const TetFace& o) const { return corners < o.corners; }
};

std::array<int, 3> sorted(int a, int b, int c) {
    std::array<int, 3> corners{a, b, c};
    std::sort(corners.begin(), corners.end());
    return corners;
}

std::vector<TetFace> sortedFaces(const Tetrahedra& T) {
    std::vector<TetFace> faces;
    faces.reserve(static_cast<std::size_t>(T.rows()) * 4);
    for (int t = 0; t < static_cast<int>(T.rows()); ++t)
        for (int k = 0; k < 4; ++k)
            faces.push_back({sorted(T(t, (k + 1) % 4), T(t, (k + 2) % 4), T(t, (k + 3) % 4)), t, k});
    std::sort(faces.begin(), faces.end());
    return faces;
}

} // namespace

std::vector<std::array<int, 4>> tetNeighbours(const Tetrahedra& T) {
    std::vector<std::array<int, 4>> neighbours(static_cast<std::size_t>(T.rows()), {-1, -1, -1, -1});
    const std::vector<TetFace> faces = sortedFaces(T);
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        if (faces[i].corners != faces[i + 1].corners)
            continue;
        const TetFace& a = faces[i];
        const TetFace& b = faces[i + 1];
        neighbours[static_cast<std::size_t>(a.tet)][static_cast<std::size_t>(a.opposite)] = b.tet;
        neighbours[static_cast<std::size_t>(b.tet)][static_cast<std::size_t>(b.opposite)] = a.tet;
    }
    return neighbours;
}

std::vector<int> tetsBehindFaces(const Tetrahedra& T, const Triangles& F) {
    const std::vector<TetFace> faces = sortedFaces(T);
    std::vector<int> behind(static_cast<std::size_t>(F.rows()), -1);
    for (int f = 0; f < static_cast<int>(F.rows()); ++f) {
        const TetFace wanted{sorted(F(f, 0), F(f, 1), F(f, 2)), 0, 0};
        const auto found = std::lower_bound(faces.begin(), faces.end(), wanted);
        if (found != faces.end() && found->corners == wanted.corners)
            behind[static_cast<std::size_t>(f)] = found->tet;
    }
    return behind;
}

std::vector<double> tetWeights(const Tetrahedra& T, const Triangles& F,
                               const std::vector<double>& faceWeights) {
    std::vector<double> weights(static_cast<std::size_t>(T.rows()), 1);
    const std::vector<int> behind = tetsBehindFaces(T, F);
    for (std::size_t f = 0; f < faceWeights.size(); ++f)
        if (behind[f] >= 0) {
            double& tet = weights[static_cast<std::size_t>(behind[f])];
            tet = std::max(tet, faceWeights[f]);
        }
    return weights;
}

int invertedCount(const Tetrahedra& T, const Eigen::Ref<const Eigen::MatrixXd>& V) {
    int inverted = 0;
    for (Eigen::Index t = 0; t < T.rows(); ++t) {
        const Eigen::Vector3d a = V.row(T(t, 0)).transpose();
        const Eigen::Vector3d b = V.row(T(t, 1)).transpose();
        const Eigen::Vector3d c = V.row(T(t, 2)).transpose();
        const Eigen::Vector3d d = V.row(T(t, 3)).transpose();
        inverted += (b - a).dot((c - a).cross(d - a)) <= 0;
    }
    return inverted;
}

} // namespace moldwright
