// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/orient.h"

#include "mesh/edge_table.h"
#include "mesh/measures.h"
#include "mesh/nesting.h"

#include <array>
#include <utility>

namespace moldwright {

namespace {

struct Neighbour {
    int face = 0;
    bool agrees = true;
};

std::vector<std::array<Neighbour, 3>> neighboursOf(const IndexedMesh& mesh) {
    std::vector<std::array<Neighbour, 3>> neighbours(static_cast<std::size_t>(mesh.faceCount()));
    const EdgeTable edges(mesh.F);
    for (int e = 0; e < edges.edgeCount(); ++e) {
        const auto sides = edges.sidesAt(e);
        const bool agree = sides[0].upward != sides[1].upward;
        for (std::size_t i = 0; i < 2; ++i)
            neighbours[static_cast<std::size_t>(sides[i].face)][static_cast<std::size_t>(sides[i].corner)] = {
                sides[1 - i].face, agree};
    }
    return neighbours;
}

/// Which faces to reverse so that all agree with the first face of their piece; −1 means not reached yet.
/// Two faces that cannot agree end up in `contradiction`.
std::vector<int> facesToTurn(const IndexedMesh& mesh, std::vector<int>& contradiction) {
    const auto neighbours = neighboursOf(mesh);
    std::vector<int> turn(static_cast<std::size_t>(mesh.faceCount()), -1);
    std::vector<int> waiting;
    for (int start = 0; start < mesh.faceCount(); ++start) {
        if (turn[static_cast<std::size_t>(start)] >= 0)
            continue;
        turn[static_cast<std::size_t>(start)] = 0;
        waiting.push_back(start);
        while (!waiting.empty()) {
            const int f = waiting.back();
            waiting.pop_back();
            for (const Neighbour& next : neighbours[static_cast<std::size_t>(f)]) {
                const int wanted = turn[static_cast<std::size_t>(f)] ^ static_cast<int>(!next.agrees);
                int& known = turn[static_cast<std::size_t>(next.face)];
                if (known < 0)
                    waiting.push_back(next.face);
                else if (known != wanted)
                    contradiction = {f, next.face};
                known = known < 0 ? wanted : known;
            }
        }
    }
    return turn;
}

void reverse(IndexedMesh& mesh, int f) {
    std::swap(mesh.F(f, 1), mesh.F(f, 2));
}

} // namespace

Orientation orientOutward(IndexedMesh& mesh) {
    Orientation result;
    std::vector<int> turn = facesToTurn(mesh, result.contradiction);
    if (!result.contradiction.empty())
        return result;
    IndexedMesh agreeing = mesh;
    for (int f = 0; f < mesh.faceCount(); ++f)
        if (turn[static_cast<std::size_t>(f)] == 1)
            reverse(agreeing, f);
    const Components components = connectedComponents(mesh);
    const std::vector<double> volumes = componentVolumes(agreeing, components);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const bool inward =
            volumes[static_cast<std::size_t>(components.ofFace[static_cast<std::size_t>(f)])] < 0;
        if ((turn[static_cast<std::size_t>(f)] == 1) == inward)
            continue;
        reverse(mesh, f);
        result.turned.push_back(f);
    }
    return result;
}

} // namespace moldwright
