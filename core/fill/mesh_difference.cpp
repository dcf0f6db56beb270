// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/mesh_difference.h"

#include "mesh/union_find.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace moldwright {

namespace {

/// Numbers the points of both meshes; equal ones alike, in the order of their coordinates.
void mergePoints(const std::array<const IndexedMesh*, 2>& meshes, MeshDifference& difference) {
    std::vector<std::pair<std::size_t, int>> order;
    for (std::size_t m = 0; m < 2; ++m)
        for (int v = 0; v < meshes[m]->vertexCount(); ++v)
            order.emplace_back(m, v);
    const auto place = [&](const std::pair<std::size_t, int>& p) {
        const Eigen::Vector3d x = meshes[p.first]->point(p.second);
        return std::tuple(x.x(), x.y(), x.z());
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
    std::array<std::vector<int>, 2> number;
    for (std::size_t m = 0; m < 2; ++m)
        number[m].resize(static_cast<std::size_t>(meshes[m]->vertexCount()));
    difference.points.resize(static_cast<Eigen::Index>(order.size()), 3);
    int count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || place(order[i - 1]) != place(order[i]))
            difference.points.row(count++) = meshes[order[i].first]->V.row(order[i].second);
        number[order[i].first][static_cast<std::size_t>(order[i].second)] = count - 1;
    }
    difference.points.conservativeResize(count, 3);
    for (std::size_t m = 0; m < 2; ++m)
        difference.faces[m] =
            meshes[m]->F.unaryExpr([&](int v) { return number[m][static_cast<std::size_t>(v)]; });
}

/// A face in a form that tells equal ones: lowest point first, then its label.
using FaceKey = std::array<int, 4>;

FaceKey keyOf(const Triangles& F, int f, int label) {
    std::array<int, 3> c = {F(f, 0), F(f, 1), F(f, 2)};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    return {c[0], c[1], c[2], label};
}

/// Marks with −1 the faces that both meshes have, with 0 all others.
void findCommon(const std::array<const PartedMesh*, 2>& meshes, MeshDifference& difference) {
    std::array<std::vector<std::pair<FaceKey, int>>, 2> keys;
    for (std::size_t m = 0; m < 2; ++m) {
        const auto count = static_cast<int>(difference.faces[m].rows());
        difference.patchOf[m].assign(static_cast<std::size_t>(count), 0);
        for (int f = 0; f < count; ++f)
            keys[m].emplace_back(
                keyOf(difference.faces[m], f, meshes[m]->labels[static_cast<std::size_t>(f)]), f);
        std::sort(keys[m].begin(), keys[m].end());
    }
    std::size_t other = 0;
    for (const auto& [key, f] : keys[0]) {
        while (other < keys[1].size() && keys[1][other].first < key)
            ++other;
        if (other < keys[1].size() && keys[1][other].first == key) {
            difference.patchOf[0][static_cast<std::size_t>(f)] = -1;
            difference.patchOf[1][static_cast<std::size_t>(keys[1][other].second)] = -1;
        }
    }
}

} // namespace

MeshDifference meshDifference(const PartedMesh& first, const PartedMesh& second) {
    MeshDifference difference;
    mergePoints({&first.mesh, &second.mesh}, difference);
    findCommon({&first, &second}, difference);

    // Faces that differ hang together where they share an edge, whichever mesh they belong to.
    const auto firstCount = static_cast<int>(difference.faces[0].rows());
    UnionFind groups(firstCount + static_cast<int>(difference.faces[1].rows()));
    std::vector<std::array<int, 3>> sides; ///< an edge's points, a face at it
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t f = 0; f < difference.patchOf[m].size(); ++f)
            for (int k = 0; difference.patchOf[m][f] == 0 && k < 3; ++k) {
                const auto [a, b] =
                    std::minmax(difference.faces[m](static_cast<Eigen::Index>(f), k),
                                difference.faces[m](static_cast<Eigen::Index>(f), (k + 1) % 3));
                sides.push_back({a, b, static_cast<int>(f) + (m == 0 ? 0 : firstCount)});
            }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i)
        if (sides[i][0] == sides[i - 1][0] && sides[i][1] == sides[i - 1][1])
            groups.unite(sides[i][2], sides[i - 1][2]);

    std::vector<int> patchOfRoot(difference.patchOf[0].size() + difference.patchOf[1].size(), -1);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t f = 0; f < difference.patchOf[m].size(); ++f) {
            if (difference.patchOf[m][f] < 0)
                continue;
            int& patch = patchOfRoot[static_cast<std::size_t>(
                groups.rootOf(static_cast<int>(f) + (m == 0 ? 0 : firstCount)))];
            if (patch < 0)
                patch = difference.patches++;
            difference.patchOf[m][f] = patch;
        }
    return difference;
}

} // namespace moldwright
