// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/parting_line.h"

#include "mesh/measures.h"
#include "mesh/triangle_mesh.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace moldwright {

namespace {

constexpr double kClearlyOther = 0.5; ///< sine of the angle at which a point's faces look at the other side
constexpr double kCrossed = 0.15;     ///< of the shortest edge: how far beyond the plane a point is put
constexpr int kCrossingRounds = 5;
constexpr double kExactlyFlat = 1e-9; ///< of the diagonal: points this near lie in the plane on purpose

double height(const TriangleMesh& mesh, TriangleMesh::VertexHandle v) {
    return mesh.point(v).z();
}

void setHeight(TriangleMesh& mesh, TriangleMesh::VertexHandle v, double z) {
    mesh.point(v).z() = z;
}

double shortestEdge(const TriangleMesh& mesh, TriangleMesh::VertexHandle v) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto w : mesh.vv_range(v))
        shortest = std::min(shortest, (mesh.point(w) - mesh.point(v)).norm());
    return shortest;
}

bool onPlane(const TriangleMesh& mesh, TriangleMesh::VertexHandle v) {
    return height(mesh, v) == 0;
}

/// Would moving v onto the plane lay a whole face flat that was not made flat?
bool wouldFlatten(const TriangleMesh& mesh, TriangleMesh::VertexHandle v, double flat,
                  const std::vector<double>& z) {
    for (const auto f : mesh.vf_range(v)) {
        bool othersOnPlane = true;
        bool meantFlat = std::abs(z[static_cast<std::size_t>(v.idx())]) <= flat;
        for (const auto w : mesh.fv_range(f)) {
            othersOnPlane = othersOnPlane && (w == v || onPlane(mesh, w));
            meantFlat = meantFlat && std::abs(z[static_cast<std::size_t>(w.idx())]) <= flat;
        }
        if (othersOnPlane && !meantFlat)
            return true;
    }
    return false;
}

void snapToPlane(TriangleMesh& mesh, double snap, double flat) {
    std::vector<double> z(mesh.n_vertices());
    for (const auto v : mesh.vertices())
        z[static_cast<std::size_t>(v.idx())] = height(mesh, v);
    std::vector<int> order(z.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return std::abs(z[static_cast<std::size_t>(a)]) < std::abs(z[static_cast<std::size_t>(b)]);
    });
    for (const int i : order) {
        const TriangleMesh::VertexHandle v(i);
        const double distance = std::abs(height(mesh, v));
        if (distance <= flat || (distance < snap * shortestEdge(mesh, v) && !wouldFlatten(mesh, v, flat, z)))
            setHeight(mesh, v, 0);
    }
}

/// +1 or −1 for a face on one side (one in the plane: by its normal), 0 for one that crosses.
int sideOf(const TriangleMesh& mesh, TriangleMesh::FaceHandle f) {
    double low = 0;
    double high = 0;
    std::array<Eigen::Vector3d, 3> x;
    std::size_t k = 0;
    for (const auto v : mesh.fv_range(f)) {
        x[k++] = mesh.point(v);
        low = std::min(low, height(mesh, v));
        high = std::max(high, height(mesh, v));
    }
    if (low < 0 && high > 0)
        return 0;
    if (low == 0 && high == 0)
        return (x[1] - x[0]).cross(x[2] - x[0]).z() > 0 ? 1 : -1;
    return high > 0 ? 1 : -1;
}

/// The sides met in one turn about a point on the plane; a crossing face adds both in the order met.
std::vector<int> sidesAround(const TriangleMesh& mesh, TriangleMesh::VertexHandle v) {
    std::vector<int> sides;
    for (const auto h : mesh.voh_range(v)) {
        const int side = sideOf(mesh, mesh.face_handle(h));
        if (side != 0) {
            sides.push_back(side);
            continue;
        }
        // Outgoing halfedges are met clockwise: the face's far corner first, then the near one.
        const double far = height(mesh, mesh.to_vertex_handle(mesh.next_halfedge_handle(h)));
        sides.push_back(far > 0 ? 1 : -1);
        sides.push_back(far > 0 ? -1 : 1);
    }
    return sides;
}

/// Pushes points off the plane where the parting line would only touch it or meet itself. Returns whether any
/// moved.
bool loosenTouches(TriangleMesh& mesh) {
    bool moved = false;
    for (const auto v : mesh.vertices()) {
        if (!onPlane(mesh, v))
            continue;
        const std::vector<int> sides = sidesAround(mesh, v);
        int changes = 0;
        for (std::size_t i = 0; i < sides.size(); ++i)
            changes += sides[i] != sides[(i + 1) % sides.size()];
        const bool touches = changes == 0;
        const bool inFlatFace = std::any_of(mesh.cvf_begin(v), mesh.cvf_end(v), [&](auto f) {
            return std::all_of(mesh.cfv_begin(f), mesh.cfv_end(f), [&](auto w) { return onPlane(mesh, w); });
        });
        if (changes == 2 || (touches && inFlatFace))
            continue;
        const int sum = std::accumulate(sides.begin(), sides.end(), 0);
        setHeight(mesh, v, (sum >= 0 ? 0.15 : -0.15) * shortestEdge(mesh, v));
        moved = true;
    }
    return moved;
}

void splitCrossingEdges(TriangleMesh& mesh) {
    const std::size_t edges = mesh.n_edges();
    for (std::size_t e = 0; e < edges; ++e) {
        const TriangleMesh::EdgeHandle edge(static_cast<int>(e));
        const auto h = mesh.halfedge_handle(edge, 0);
        const Eigen::Vector3d a = mesh.point(mesh.from_vertex_handle(h));
        const Eigen::Vector3d b = mesh.point(mesh.to_vertex_handle(h));
        if (!(a.z() * b.z() < 0))
            continue;
        Eigen::Vector3d crossing = a + a.z() / (a.z() - b.z()) * (b - a);
        crossing.z() = 0;
        mesh.split_copy(edge, mesh.add_vertex(crossing));
    }
}

} // namespace

PartedMesh insertPartingLine(const IndexedMesh& input, double snap) {
    TriangleMesh mesh = toTriangleMesh(input);
    OpenMesh::FPropHandleT<int> source;
    mesh.add_property(source);
    for (const auto f : mesh.faces())
        mesh.property(source, f) = f.idx();

    snapToPlane(mesh, snap, kExactlyFlat * diagonal(input));
    // Loosening one point can make its neighbour touch; a few rounds settle it.
    for (int round = 0; round < 10 && loosenTouches(mesh); ++round) {
    }
    splitCrossingEdges(mesh);

    PartedMesh result;
    result.mesh = toIndexedMesh(mesh);
    for (const auto f : mesh.faces()) {
        result.labels.push_back(sideOf(mesh, f) > 0 ? 1 : 2);
        result.sourceFace.push_back(mesh.property(source, f));
    }
    return result;
}

IndexedMesh crossNearPoints(const IndexedMesh& input, double reach) {
    IndexedMesh mesh = input;
    const double flat = kExactlyFlat * diagonal(input);
    const TriangleMesh topology = toTriangleMesh(input);
    // One point's crossing may turn its neighbours' faces: a few rounds, each judged on the shape it finds.
    for (int round = 0; round < kCrossingRounds; ++round) {
        Points looks = Points::Zero(mesh.V.rows(), 3);
        for (int f = 0; f < mesh.faceCount(); ++f)
            for (int k = 0; k < 3; ++k)
                looks.row(mesh.F(f, k)) += doubleAreaVector(mesh, f).transpose();
        bool moved = false;
        for (const auto v : topology.vertices()) {
            const double z = mesh.V(v.idx(), 2);
            const double up = looks(v.idx(), 2) / std::max(looks.row(v.idx()).norm(), 1e-300);
            if (std::abs(z) <= flat || std::abs(z) > reach || up * z > -kClearlyOther * std::abs(z))
                continue;
            mesh.V(v.idx(), 2) = (z > 0 ? -kCrossed : kCrossed) * shortestEdge(topology, v);
            moved = true;
        }
        if (!moved)
            break;
    }
    return mesh;
}

std::vector<std::array<int, 2>> partingEdges(const IndexedMesh& mesh, const SideLabels& labels) {
    std::map<std::pair<int, int>, int> faceAt;
    for (int f = 0; f < mesh.faceCount(); ++f)
        if (labels[static_cast<std::size_t>(f)] == 2)
            for (int k = 0; k < 3; ++k)
                faceAt[{mesh.F(f, k), mesh.F(f, (k + 1) % 3)}] = f;
    std::vector<std::array<int, 2>> edges;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (labels[static_cast<std::size_t>(f)] != 1)
            continue;
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.F(f, k);
            const int b = mesh.F(f, (k + 1) % 3);
            if (faceAt.contains({b, a}))
                edges.push_back({a, b});
        }
    }
    return edges;
}

} // namespace moldwright
