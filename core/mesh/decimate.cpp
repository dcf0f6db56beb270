// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/decimate.h"

#include "mesh/triangle_mesh.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <numeric>

namespace moldwright {

namespace {

constexpr double kSlimmest = 12; ///< longest edge over height: slimmer faces may not be made

double slimness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest / std::max((b - a).cross(c - a).norm(), 1e-300);
}

/// Forbids collapses that make a face slim, or a slim one slimmer, or a face wholly of locked points.
template <class MeshT>
class FaceGuard : public OpenMesh::Decimater::ModBaseT<MeshT> {
public:
    DECIMATING_MODULE(FaceGuard, MeshT, FaceGuard)

    explicit FaceGuard(MeshT& mesh) : Base(mesh, true) {}

    float collapse_priority(const CollapseInfo& collapse) override {
        MeshT& mesh = Base::mesh();
        for (const auto h : mesh.voh_range(collapse.v0)) {
            const auto a = mesh.to_vertex_handle(h);
            const auto b = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
            if (a == collapse.v1 || b == collapse.v1)
                continue;
            if (locked(collapse.v1) && locked(a) && locked(b))
                return Base::ILLEGAL_COLLAPSE;
            const double now = slimness(collapse.p1, mesh.point(a), mesh.point(b));
            if (now > kSlimmest && now > slimness(collapse.p0, mesh.point(a), mesh.point(b)))
                return Base::ILLEGAL_COLLAPSE;
        }
        return Base::LEGAL_COLLAPSE;
    }

private:
    [[nodiscard]] bool locked(typename MeshT::VertexHandle v) { return Base::mesh().status(v).locked(); }
};

/// Notes each collapse: the point removed goes where the one that is left goes.
template <class MeshT>
class CollapseRecord : public OpenMesh::Decimater::ModBaseT<MeshT> {
public:
    DECIMATING_MODULE(CollapseRecord, MeshT, CollapseRecord)

    explicit CollapseRecord(MeshT& mesh) : Base(mesh, true), m_into(mesh.n_vertices()) {
        std::iota(m_into.begin(), m_into.end(), 0);
    }

    void postprocess_collapse(const CollapseInfo& collapse) override {
        m_into[static_cast<std::size_t>(collapse.v0.idx())] = collapse.v1.idx();
    }

    /// The point that v was merged into at last.
    int at(int v) {
        int last = v;
        while (m_into[static_cast<std::size_t>(last)] != last)
            last = m_into[static_cast<std::size_t>(last)];
        while (m_into[static_cast<std::size_t>(v)] != last)
            v = std::exchange(m_into[static_cast<std::size_t>(v)], last);
        return last;
    }

private:
    std::vector<int> m_into;
};

/// Collapses edges until `targetFaces` are left; which point each was merged into, as they were numbered
/// before.
std::vector<int> collapse(TriangleMesh& mesh, int targetFaces) {
    mesh.request_face_normals();
    mesh.update_face_normals();
    const auto points = static_cast<int>(mesh.n_vertices());
    OpenMesh::Decimater::DecimaterT<TriangleMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<TriangleMesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<TriangleMesh>::Handle flipping;
    FaceGuard<TriangleMesh>::Handle faces;
    CollapseRecord<TriangleMesh>::Handle record;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    decimater.add(flipping);
    decimater.add(faces);
    decimater.add(record);
    decimater.initialize();
    decimater.decimate_to_faces(0, static_cast<std::size_t>(targetFaces));
    mesh.garbage_collection();
    std::vector<int> into;
    into.reserve(static_cast<std::size_t>(points));
    for (int v = 0; v < points; ++v)
        into.push_back(decimater.module(record).at(v));
    return into;
}

} // namespace

IndexedMesh decimate(const IndexedMesh& mesh, int targetFaces) {
    return reduce(mesh, targetFaces).mesh;
}

Reduction reduce(const IndexedMesh& mesh, int targetFaces, const std::vector<char>& kept) {
    std::vector<int> pointNow(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(pointNow.begin(), pointNow.end(), 0);
    if (mesh.faceCount() <= targetFaces)
        return {mesh, std::move(pointNow)};
    TriangleMesh reduced = toTriangleMesh(mesh);
    OpenMesh::VPropHandleT<int> original;
    reduced.add_property(original);
    for (const auto v : reduced.vertices()) {
        reduced.property(original, v) = v.idx();
        reduced.status(v).set_locked(!kept.empty() && kept[static_cast<std::size_t>(v.idx())]);
    }
    const std::vector<int> into = collapse(reduced, targetFaces);
    std::vector<int> placeOf(pointNow.size(), -1);
    for (const auto v : reduced.vertices())
        placeOf[static_cast<std::size_t>(reduced.property(original, v))] = v.idx();
    for (int& v : pointNow)
        v = placeOf[static_cast<std::size_t>(into[static_cast<std::size_t>(v)])];
    return {toIndexedMesh(reduced), std::move(pointNow)};
}

} // namespace moldwright
