// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/weld.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace moldwright {

namespace {

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

struct CellHash {
    std::size_t operator()(const Cell& c) const {
        std::uint64_t h = 0;
        for (const std::int64_t value : c) {
            h = (h ^ static_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15ULL;
            h ^= h >> 32;
        }
        return h;
    }
};

/// Moves the faces of `mesh` to new points: point v becomes newIndex[v], and point first[k] stays as number
/// k.
WeldedMesh renumbered(const IndexedMesh& mesh, const std::vector<int>& newIndex,
                      const std::vector<int>& first) {
    WeldedMesh welded;
    welded.mesh.V = mesh.V(first, Eigen::all);
    welded.mesh.F = mesh.F.unaryExpr([&](int v) { return newIndex[static_cast<std::size_t>(v)]; });
    welded.merged = mesh.vertexCount() - static_cast<int>(first.size());
    return welded;
}

} // namespace

WeldedMesh weldEqualPoints(const IndexedMesh& mesh) {
    std::unordered_map<Cell, int, CellHash> indexOf;
    indexOf.reserve(static_cast<std::size_t>(mesh.vertexCount()));
    std::vector<int> newIndex(static_cast<std::size_t>(mesh.vertexCount()));
    std::vector<int> first;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        Cell bits;
        for (int k = 0; k < 3; ++k)
            bits[k] = std::bit_cast<std::int64_t>(mesh.V(v, k) + 0.0); // −0 + 0 is 0
        const auto [entry, added] = indexOf.try_emplace(bits, static_cast<int>(first.size()));
        if (added)
            first.push_back(v);
        newIndex[static_cast<std::size_t>(v)] = entry->second;
    }
    return renumbered(mesh, newIndex, first);
}

WeldedMesh weldNearPoints(const IndexedMesh& mesh, double distance) {
    const Eigen::RowVector3d low = mesh.V.colwise().minCoeff();
    std::unordered_map<Cell, std::vector<int>, CellHash> pointsIn;
    std::vector<int> newIndex(static_cast<std::size_t>(mesh.vertexCount()));
    std::vector<int> first;
    const auto nearby = [&](const Eigen::RowVector3d& p, const Cell& cell) {
        for (std::int64_t i = 0; i < 27; ++i) {
            const auto found = pointsIn.find(cell + Cell(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
            if (found != pointsIn.end())
                for (const int k : found->second)
                    if ((mesh.V.row(first[static_cast<std::size_t>(k)]) - p).norm() <= distance)
                        return k;
        }
        return -1;
    };
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Eigen::RowVector3d p = mesh.V.row(v);
        const Cell cell = ((p - low) / distance).array().floor().cast<std::int64_t>().transpose();
        int k = nearby(p, cell);
        if (k < 0) {
            k = static_cast<int>(first.size());
            first.push_back(v);
            pointsIn[cell].push_back(k);
        }
        newIndex[static_cast<std::size_t>(v)] = k;
    }
    return renumbered(mesh, newIndex, first);
}

WeldedMesh withoutUnusedPoints(const IndexedMesh& mesh) {
    std::vector<int> newIndex(static_cast<std::size_t>(mesh.vertexCount()), -1);
    for (const int v : mesh.F.reshaped())
        newIndex[static_cast<std::size_t>(v)] = 0;
    std::vector<int> first;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (int& index = newIndex[static_cast<std::size_t>(v)]; index == 0) {
            index = static_cast<int>(first.size());
            first.push_back(v);
        }
    return renumbered(mesh, newIndex, first);
}

} // namespace moldwright
