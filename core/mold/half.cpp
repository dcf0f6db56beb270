// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/half.h"

#include "mold/cgal/constrained_triangulation.h"

#include <array>

namespace moldwright {

namespace {

using Eigen::RowVector3i;
using Eigen::Vector3d;

/// The block's corner k of four, counter-clockwise seen from side 1, at height z.
Vector3d corner(const Block& block, int k, double z) {
    return {k == 1 || k == 2 ? block.max().x() : block.min().x(), k >= 2 ? block.max().y() : block.min().y(),
            z};
}

/// Collects the faces of one half, renumbering the points of the cast that it uses.
class HalfBuilder {
public:
    HalfBuilder(int side, const IndexedMesh& cast)
        : m_side(side), m_cast(cast), m_numberOf(static_cast<std::size_t>(cast.vertexCount()), -1) {}

    int castPoint(int v) {
        int& number = m_numberOf[static_cast<std::size_t>(v)];
        if (number < 0)
            number = point(m_cast.point(v));
        return number;
    }
    int point(const Vector3d& p) {
        m_points.push_back(p);
        return static_cast<int>(m_points.size()) - 1;
    }
    void face(int a, int b, int c) { m_faces.emplace_back(a, b, c); }
    /// A face given as it would be on half 1; half 2 is its mirror image in the plane.
    void mirroredFace(int a, int b, int c) { m_side == 1 ? face(a, b, c) : face(a, c, b); }

    [[nodiscard]] IndexedMesh mesh() const {
        IndexedMesh mesh;
        mesh.V.resize(static_cast<Eigen::Index>(m_points.size()), 3);
        for (std::size_t v = 0; v < m_points.size(); ++v)
            mesh.V.row(static_cast<Eigen::Index>(v)) = m_points[v].transpose();
        mesh.F.resize(static_cast<Eigen::Index>(m_faces.size()), 3);
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            mesh.F.row(static_cast<Eigen::Index>(f)) = m_faces[f];
        return mesh;
    }

private:
    int m_side;
    const IndexedMesh& m_cast;
    std::vector<int> m_numberOf;
    std::vector<Vector3d> m_points;
    std::vector<RowVector3i> m_faces;
};

void addCavity(HalfBuilder& half, int side, const IndexedMesh& cast, const SideLabels& labels) {
    for (int f = 0; f < cast.faceCount(); ++f)
        if (labels[static_cast<std::size_t>(f)] == side)
            half.face(half.castPoint(cast.F(f, 0)), half.castPoint(cast.F(f, 2)),
                      half.castPoint(cast.F(f, 1)));
}

/// Parting face, walls and top (bottom for half 2).
void addBlock(HalfBuilder& half, int side, const PartingFace& parting, const Block& block) {
    std::vector<int> inPlane;
    inPlane.reserve(parting.castPoints.size() + 4);
    for (const int v : parting.castPoints)
        inPlane.push_back(half.castPoint(v));
    for (int k = 0; k < 4; ++k)
        inPlane.push_back(half.point(corner(block, k, 0)));
    for (const auto& t : parting.faces.rowwise())
        half.mirroredFace(inPlane[static_cast<std::size_t>(t[0])], inPlane[static_cast<std::size_t>(t[2])],
                          inPlane[static_cast<std::size_t>(t[1])]);
    const double end = side == 1 ? block.max().z() : block.min().z();
    const int* foot = &inPlane[parting.castPoints.size()];
    std::array<int, 4> top{};
    for (int k = 0; k < 4; ++k)
        top[static_cast<std::size_t>(k)] = half.point(corner(block, k, end));
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        half.mirroredFace(foot[k], foot[next], top[next]);
        half.mirroredFace(foot[k], top[next], top[k]);
    }
    half.mirroredFace(top[0], top[1], top[2]);
    half.mirroredFace(top[0], top[2], top[3]);
}

} // namespace

std::optional<PartingFace> partingFace(const IndexedMesh& placedCast, const std::vector<PartingCurve>& curves,
                                       const Block& block) {
    PartingFace parting;
    std::vector<Eigen::Vector2d> points;
    std::vector<std::array<int, 2>> segments;
    const auto addOutline = [&](int first, int count) {
        for (int k = 0; k < count; ++k)
            segments.push_back({first + k, first + (k + 1) % count});
    };
    for (const PartingCurve& curve : curves) {
        addOutline(static_cast<int>(points.size()), static_cast<int>(curve.size()));
        for (const int v : curve) {
            parting.castPoints.push_back(v);
            points.emplace_back(placedCast.V(v, 0), placedCast.V(v, 1));
        }
    }
    addOutline(static_cast<int>(points.size()), 4);
    for (int k = 0; k < 4; ++k)
        points.emplace_back(corner(block, k, 0).head<2>());
    const std::optional<Triangles> faces = triangulateRegion(points, segments);
    if (!faces)
        return std::nullopt;
    parting.faces = *faces;
    return parting;
}

IndexedMesh assembleHalf(int side, const IndexedMesh& placedCast, const SideLabels& labels,
                         const PartingFace& parting, const Block& block) {
    HalfBuilder half(side, placedCast);
    addCavity(half, side, placedCast, labels);
    addBlock(half, side, parting, block);
    return half.mesh();
}

} // namespace moldwright
