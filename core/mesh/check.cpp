// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/check.h"

#include "base/stop_point.h"
#include "mesh/edge_table.h"
#include "mesh/measures.h"
#include "mesh/nesting.h"
#include "mesh/union_find.h"
#include "mesh/weld.h"

#include <algorithm>

namespace moldwright {

namespace {

void sortUnique(std::vector<int>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Judges edges by how many faces share them and whether these agree; counts the boundary's groups.
void judgeEdges(const IndexedMesh& mesh, const EdgeTable& edges, MeshDiagnosis& found) {
    UnionFind boundary(mesh.vertexCount());
    std::vector<int> boundaryPoints;
    found.oriented = true;
    for (int e = 0; e < edges.edgeCount(); ++e) {
        stopPointAt(e);
        const auto sides = edges.sidesAt(e);
        if (sides.size() == 2)
            found.oriented = found.oriented && sides[0].upward != sides[1].upward;
        else if (sides.size() == 1) {
            boundary.unite(sides[0].low, sides[0].high);
            boundaryPoints.push_back(sides[0].low);
        }
        auto& faces = sides.size() == 1 ? found.openFaces : found.crowdedFaces;
        for (const FaceSide& side : sides)
            if (sides.size() != 2)
                faces.push_back(side.face);
    }
    sortUnique(found.openFaces);
    sortUnique(found.crowdedFaces);
    for (int& v : boundaryPoints)
        v = boundary.rootOf(v);
    sortUnique(boundaryPoints);
    found.boundaryLoops = static_cast<int>(boundaryPoints.size());
}

/// Points whose faces form more than one fan, walking from face to face across shared edges.
std::vector<int> pinchedPoints(const IndexedMesh& mesh, const EdgeTable& edges) {
    UnionFind corners(3 * mesh.faceCount());
    const auto cornerAt = [&](int f, int v) {
        return 3 * f + (mesh.F(f, 0) == v ? 0 : mesh.F(f, 1) == v ? 1 : 2);
    };
    for (int e = 0; e < edges.edgeCount(); ++e) {
        stopPointAt(e);
        const auto sides = edges.sidesAt(e);
        for (std::size_t i = 1; i < sides.size(); ++i)
            for (const int v : {sides[0].low, sides[0].high})
                corners.unite(cornerAt(sides[0].face, v), cornerAt(sides[i].face, v));
    }
    std::vector<int> fanOf(static_cast<std::size_t>(mesh.vertexCount()), -1);
    std::vector<int> pinched;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        for (int k = 0; k < 3; ++k) {
            const int fan = corners.rootOf(3 * f + k);
            int& known = fanOf[static_cast<std::size_t>(mesh.F(f, k))];
            if (known >= 0 && known != fan)
                pinched.push_back(mesh.F(f, k));
            known = fan;
        }
    }
    sortUnique(pinched);
    return pinched;
}

bool everyComponentLooksOutward(const IndexedMesh& mesh) {
    const std::vector<double> volumes = componentVolumes(mesh, connectedComponents(mesh));
    return std::all_of(volumes.begin(), volumes.end(), [](double v) { return v > 0; });
}

int usedPoints(const IndexedMesh& mesh) {
    std::vector<char> used(static_cast<std::size_t>(mesh.vertexCount()), 0);
    for (const int v : mesh.F.reshaped())
        used[static_cast<std::size_t>(v)] = 1;
    return static_cast<int>(std::count(used.begin(), used.end(), 1));
}

/// The faces that have three corners, and which faces of `mesh` they were.
IndexedMesh properFaces(const IndexedMesh& mesh, std::vector<int>& origin) {
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        if (!usesAPointTwice(mesh, f))
            origin.push_back(f);
    }
    return {mesh.V, mesh.F(origin, Eigen::all)};
}

void toOriginal(std::vector<int>& faces, const std::vector<int>& origin) {
    for (int& f : faces)
        f = origin[static_cast<std::size_t>(f)];
}

} // namespace

bool MeshDiagnosis::usable() const {
    return closed && manifold && oriented && volume > 0 && nested == 0 && degenerateFaces.empty() &&
           selfIntersections.empty();
}

MeshDiagnosis diagnose(const IndexedMesh& given) {
    std::vector<int> origin;
    const IndexedMesh mesh = properFaces(given, origin);
    const EdgeTable edges(mesh.F);
    MeshDiagnosis found;
    judgeEdges(mesh, edges, found);
    found.pinchedPoints = pinchedPoints(mesh, edges);
    found.closed = mesh.faceCount() > 0 && found.openFaces.empty();
    found.manifold = found.crowdedFaces.empty() && found.pinchedPoints.empty();
    const Components components = connectedComponents(mesh);
    found.components = components.count;
    found.volume = volume(mesh);
    found.selfIntersections = selfIntersections(mesh);
    if (found.closed && found.manifold) {
        found.genus = components.count - (usedPoints(mesh) - edges.edgeCount() + mesh.faceCount()) / 2;
        found.oriented = found.oriented && everyComponentLooksOutward(mesh);
        if (found.selfIntersections.empty())
            found.nested = static_cast<int>(componentsInsideOthers(mesh, components).size());
    } else
        found.oriented = found.oriented && found.volume > 0;
    found.degenerateFaces = flatFaces(given);
    toOriginal(found.openFaces, origin);
    toOriginal(found.crowdedFaces, origin);
    for (auto& [f, g] : found.selfIntersections) {
        f = origin[static_cast<std::size_t>(f)];
        g = origin[static_cast<std::size_t>(g)];
    }
    return found;
}

} // namespace moldwright
