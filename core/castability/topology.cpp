// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/topology.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace moldwright {

namespace {

using DirectedEdges = std::map<std::pair<int, int>, int>; ///< a→b to the face that has it

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

int genusOf(const IndexedMesh& mesh, const std::vector<int>& faces, std::size_t loops) {
    std::set<int> vertices;
    std::set<std::pair<int, int>> edges;
    for (const int f : faces)
        for (int k = 0; k < 3; ++k) {
            vertices.insert(mesh.F(f, k));
            edges.insert(std::minmax(mesh.F(f, k), mesh.F(f, (k + 1) % 3)));
        }
    const int euler =
        static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(faces.size());
    return (2 - static_cast<int>(loops) - euler) / 2;
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
    DirectedEdges faceAt;
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            faceAt[{mesh.F(f, k), mesh.F(f, (k + 1) % 3)}] = f;
    std::vector<char> seen(labels.size(), 0);
    std::vector<SidePiece> pieces;
    for (int seed = 0; seed < mesh.faceCount(); ++seed) {
        if (seen[static_cast<std::size_t>(seed)])
            continue;
        SidePiece piece;
        piece.side = labels[static_cast<std::size_t>(seed)];
        piece.faces = {seed};
        seen[static_cast<std::size_t>(seed)] = 1;
        std::vector<std::array<int, 2>> boundary;
        for (std::size_t i = 0; i < piece.faces.size(); ++i) {
            const int f = piece.faces[i];
            for (int k = 0; k < 3; ++k) {
                const int a = mesh.F(f, k);
                const int b = mesh.F(f, (k + 1) % 3);
                const auto across = faceAt.find({b, a});
                if (across == faceAt.end() ||
                    labels[static_cast<std::size_t>(across->second)] != piece.side) {
                    boundary.push_back({a, b});
                } else if (!seen[static_cast<std::size_t>(across->second)]) {
                    seen[static_cast<std::size_t>(across->second)] = 1;
                    piece.faces.push_back(across->second);
                }
            }
        }
        std::sort(boundary.begin(), boundary.end());
        piece.loops = chainLoops(mesh, boundary, piece.side);
        piece.genus = genusOf(mesh, piece.faces, piece.loops.size());
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
