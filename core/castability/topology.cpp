// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/topology.h"

#include "mesh/opposite_sides.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace moldwright {

namespace {

/// Chains the directed boundary edges of a piece into loops. At a vertex with several ways out the lowest is
/// taken: loops may then touch, which the curve check of the certificate judges.
std::vector<PartingLoop> chainLoops(const IndexedMesh& mesh, const std::vector<std::array<int, 2>>& boundary,
                                    int side) {
    std::multimap<int, int> next;
    for (const auto& [a, b] : boundary)
        next.emplace(a, b);
    std::vector<PartingLoop> loops;
    while (!next.empty()) {
        PartingLoop loop;
        int v = next.begin()->first;
        for (auto way = next.find(v); way != next.end(); way = next.find(v)) {
            loop.vertices.push_back(v);
            v = way->second;
            next.erase(way);
        }
        for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
            const Eigen::Vector3d p = mesh.point(loop.vertices[i]);
            const Eigen::Vector3d q = mesh.point(loop.vertices[(i + 1) % loop.vertices.size()]);
            loop.signedArea += (p.x() * q.y() - p.y() * q.x()) / 2 * (side == 1 ? 1 : -1);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

bool inside(const IndexedMesh& mesh, const PartingLoop& loop, const Eigen::Vector3d& p) {
    bool in = false;
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const Eigen::Vector3d a = mesh.point(loop.vertices[i]);
        const Eigen::Vector3d b = mesh.point(loop.vertices[(i + 1) % loop.vertices.size()]);
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            in = !in;
    }
    return in;
}

} // namespace

std::vector<SidePiece> sidePieces(const IndexedMesh& mesh, const SideLabels& labels) {
    const OppositeSides opposite = oppositeSides(mesh.F, mesh.vertexCount());
    std::vector<char> seen(labels.size(), 0);
    std::vector<int> countedFor(static_cast<std::size_t>(mesh.vertexCount()), -1);
    std::vector<SidePiece> pieces;
    for (int seed = 0; seed < mesh.faceCount(); ++seed) {
        if (seen[static_cast<std::size_t>(seed)])
            continue;
        SidePiece piece;
        piece.side = labels[static_cast<std::size_t>(seed)];
        piece.faces = {seed};
        seen[static_cast<std::size_t>(seed)] = 1;
        std::vector<std::array<int, 2>> boundary;
        int points = 0;
        for (std::size_t i = 0; i < piece.faces.size(); ++i) {
            const int f = piece.faces[i];
            for (int k = 0; k < 3; ++k) {
                int& counted = countedFor[static_cast<std::size_t>(mesh.F(f, k))];
                points += std::exchange(counted, seed) == seed ? 0 : 1;
                const int side = 3 * f + k;
                const int back = opposite.of[static_cast<std::size_t>(side)];
                const int across = back / 3;
                if (back < 0 || labels[static_cast<std::size_t>(across)] != piece.side)
                    boundary.push_back({mesh.F(f, k), mesh.F(f, (k + 1) % 3)});
                else if (!std::exchange(seen[static_cast<std::size_t>(across)], 1))
                    piece.faces.push_back(across);
            }
        }
        std::sort(boundary.begin(), boundary.end());
        piece.loops = chainLoops(mesh, boundary, piece.side);
        const auto faces = static_cast<int>(piece.faces.size());
        const int euler = points - (3 * faces + static_cast<int>(boundary.size())) / 2 + faces;
        piece.genus = (2 - static_cast<int>(piece.loops.size()) - euler) / 2;
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

PieceFault pieceFault(const IndexedMesh& mesh, const SidePiece& piece) {
    if (piece.loops.empty())
        return PieceFault::Closed;
    if (piece.genus > 0)
        return PieceFault::Handle;
    const auto outer = std::count_if(piece.loops.begin(), piece.loops.end(),
                                     [](const PartingLoop& loop) { return loop.signedArea > 0; });
    if (outer == 0)
        return PieceFault::Pocket;
    if (outer > 1)
        return PieceFault::Arch;
    const PartingLoop& rim = *std::find_if(piece.loops.begin(), piece.loops.end(),
                                           [](const PartingLoop& loop) { return loop.signedArea > 0; });
    for (const PartingLoop& loop : piece.loops)
        if (&loop != &rim && !inside(mesh, rim, mesh.point(loop.vertices.front())))
            return PieceFault::Arch;
    return PieceFault::None;
}

bool topologyAllowsCasting(const IndexedMesh& mesh, const SideLabels& labels) {
    const std::vector<SidePiece> pieces = sidePieces(mesh, labels);
    return std::all_of(pieces.begin(), pieces.end(),
                       [&](const SidePiece& piece) { return pieceFault(mesh, piece) == PieceFault::None; });
}

} // namespace moldwright
