// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/fault_places.h"

#include "mesh/edge_table.h"
#include "mesh/measures.h"
#include "mesh/nesting.h"
#include "mesh/orient.h"
#include "mesh/union_find.h"

#include <algorithm>
#include <map>

namespace moldwright {

namespace {

/// Finds the places of one mesh, kind by kind.
class Search {
public:
    explicit Search(const Examination& part) : m_mesh(part.mesh), m_found(part.diagnosis) {}

    /// Edges with so many faces as `isAtFault` tells, in groups that hang together.
    void addEdges(FaultKind kind, const auto& isAtFault) {
        const EdgeTable edges(m_mesh.F);
        UnionFind groups(m_mesh.vertexCount());
        std::vector<int> atFault;
        for (int e = 0; e < edges.edgeCount(); ++e)
            if (isAtFault(edges.sidesAt(e).size())) {
                groups.unite(edges.sidesAt(e)[0].low, edges.sidesAt(e)[0].high);
                atFault.push_back(e);
            }
        std::map<int, FaultPlace> places;
        for (const int e : atFault) {
            const auto sides = edges.sidesAt(e);
            FaultPlace& place = places[groups.rootOf(sides[0].low)];
            place.edges.push_back({sides[0].low, sides[0].high});
            for (const FaceSide& side : sides)
                place.faces.push_back(side.face);
        }
        add(kind, std::move(places));
    }

    void addPinched() {
        std::map<int, FaultPlace> places;
        for (const int v : m_found.pinchedPoints)
            places[v] = {};
        for (int f = 0; f < m_mesh.faceCount(); ++f)
            for (int k = 0; k < 3; ++k)
                if (const auto at = places.find(m_mesh.F(f, k)); at != places.end())
                    at->second.faces.push_back(f);
        add(FaultKind::PinchedPoint, std::move(places));
    }

    void addOneSided() {
        if (!m_found.closed || !m_found.manifold)
            return;
        IndexedMesh turned = m_mesh;
        if (std::vector<int> faces = orientOutward(turned).contradiction; !faces.empty())
            add(FaultKind::OneSided, {{0, {FaultKind::OneSided, std::move(faces), {}, {}}}});
    }

    /// Faces in groups that share a point, or that are paired.
    void addFaces(FaultKind kind, const std::vector<int>& faces,
                  const std::vector<std::pair<int, int>>& pairs = {}) {
        UnionFind groups(m_mesh.faceCount());
        std::map<int, int> firstAt; // of a point: the first of these faces
        for (const int f : faces)
            for (int k = 0; k < 3; ++k)
                groups.unite(f, firstAt.try_emplace(m_mesh.F(f, k), f).first->second);
        for (const auto& [f, g] : pairs)
            groups.unite(f, g);
        std::map<int, FaultPlace> places;
        for (const int f : faces)
            places[groups.rootOf(f)].faces.push_back(f);
        if (kind == FaultKind::FaceWithoutArea)
            for (auto& [root, place] : places)
                place.edges = sidesOf(place.faces);
        add(kind, std::move(places));
    }

    void addCrossings() {
        std::vector<int> faces;
        for (const auto& [f, g] : m_found.selfIntersections)
            faces.insert(faces.end(), {f, g});
        addFaces(FaultKind::Crossing, faces, m_found.selfIntersections);
    }

    void addEnclosed() {
        if (m_found.nested == 0)
            return;
        const Components components = connectedComponents(m_mesh);
        std::map<int, FaultPlace> places;
        for (const int component : componentsInsideOthers(m_mesh, components))
            places[component] = {};
        for (int f = 0; f < m_mesh.faceCount(); ++f)
            if (const auto at = places.find(components.ofFace[static_cast<std::size_t>(f)]);
                at != places.end())
                at->second.faces.push_back(f);
        add(FaultKind::Enclosed, std::move(places));
    }

    [[nodiscard]] std::vector<FaultPlace> done() { return std::move(m_places); }

private:
    void add(FaultKind kind, std::map<int, FaultPlace> places) {
        const auto first = static_cast<std::ptrdiff_t>(m_places.size());
        for (auto& [number, place] : places) {
            place.kind = kind;
            std::ranges::sort(place.faces);
            const auto twice = std::ranges::unique(place.faces);
            place.faces.erase(twice.begin(), twice.end());
            place.box = boxOf(place);
            m_places.push_back(std::move(place));
        }
        std::stable_sort(m_places.begin() + first, m_places.end(),
                         [](const FaultPlace& a, const FaultPlace& b) {
                             return a.box.diagonal().norm() > b.box.diagonal().norm();
                         });
    }

    [[nodiscard]] std::vector<std::array<int, 2>> sidesOf(const std::vector<int>& faces) const {
        std::vector<std::array<int, 2>> sides;
        for (const int f : faces)
            for (int k = 0; k < 3; ++k)
                sides.push_back({m_mesh.F(f, k), m_mesh.F(f, (k + 1) % 3)});
        return sides;
    }

    [[nodiscard]] Eigen::AlignedBox3d boxOf(const FaultPlace& place) const {
        Eigen::AlignedBox3d box;
        for (const auto& edge : place.edges)
            for (const int v : edge)
                box.extend(m_mesh.point(v));
        if (place.edges.empty())
            for (const int f : place.faces)
                for (int k = 0; k < 3; ++k)
                    box.extend(m_mesh.corner(f, k));
        return box;
    }

    const IndexedMesh& m_mesh;
    const MeshDiagnosis& m_found;
    std::vector<FaultPlace> m_places;
};

} // namespace

std::vector<FaultPlace> faultPlaces(const Examination& part) {
    // What was refused for its size alone may hold anything; nothing was looked for in it.
    if (part.diagnosis.components == 0)
        return {};
    Search search(part);
    search.addEdges(FaultKind::Hole, [](std::size_t faces) { return faces == 1; });
    search.addEdges(FaultKind::CrowdedEdge, [](std::size_t faces) { return faces > 2; });
    search.addPinched();
    search.addOneSided();
    search.addFaces(FaultKind::FaceWithoutArea, part.diagnosis.degenerateFaces);
    search.addCrossings();
    search.addEnclosed();
    return search.done();
}

} // namespace moldwright
