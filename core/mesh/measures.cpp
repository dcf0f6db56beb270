// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/measures.h"

#include "base/stop_point.h"

#include <numeric>

namespace moldwright {

namespace {

int findRoot(std::vector<int>& parent, int v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
        parent[static_cast<std::size_t>(v)] =
            parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(v)])];
        v = parent[static_cast<std::size_t>(v)];
    }
    return v;
}

} // namespace

double volume(const IndexedMesh& mesh) {
    if (mesh.faceCount() == 0)
        return 0;
    // Relative to one of the points: far from the origin the products would cancel.
    const Eigen::Vector3d origin = mesh.corner(0, 0);
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        sum +=
            (mesh.corner(f, 0) - origin).dot((mesh.corner(f, 1) - origin).cross(mesh.corner(f, 2) - origin));
    }
    return sum / 6;
}

double surfaceArea(const IndexedMesh& mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
        sum += doubleAreaVector(mesh, f).norm();
    return sum / 2;
}

Eigen::AlignedBox3d boundingBox(const IndexedMesh& mesh) {
    // Points are met once each, in their order: going by faces costs ten times as much in a large mesh.
    std::vector<char> used(static_cast<std::size_t>(mesh.vertexCount()), 0);
    for (Eigen::Index i = 0; i < mesh.F.size(); ++i)
        used[static_cast<std::size_t>(mesh.F.data()[i])] = 1;
    Eigen::AlignedBox3d box;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (used[static_cast<std::size_t>(v)])
            box.extend(mesh.point(v));
    return box;
}

double diagonal(const IndexedMesh& mesh) {
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

Eigen::Vector3d centroid(const IndexedMesh& mesh) {
    const Eigen::Vector3d origin = mesh.corner(0, 0);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const Eigen::Vector3d a = mesh.corner(f, 0) - origin;
        const Eigen::Vector3d b = mesh.corner(f, 1) - origin;
        const Eigen::Vector3d c = mesh.corner(f, 2) - origin;
        const double sixfold = a.dot(b.cross(c));
        moment += sixfold * (a + b + c) / 4;
        sum += sixfold;
    }
    return origin + moment / sum;
}

Components connectedComponents(const IndexedMesh& mesh) {
    std::vector<int> parent(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(parent.begin(), parent.end(), 0);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        for (int k = 1; k < 3; ++k)
            parent[static_cast<std::size_t>(findRoot(parent, mesh.F(f, k)))] = findRoot(parent, mesh.F(f, 0));
    }
    Components result;
    result.ofFace.resize(static_cast<std::size_t>(mesh.faceCount()));
    std::vector<int> number(parent.size(), -1);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        int& n = number[static_cast<std::size_t>(findRoot(parent, mesh.F(f, 0)))];
        if (n < 0)
            n = result.count++;
        result.ofFace[static_cast<std::size_t>(f)] = n;
    }
    return result;
}

} // namespace moldwright
