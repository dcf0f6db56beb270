// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/triangle_mesh.h"

#include <functional>
#include <vector>

namespace moldwright {

/// A filled half as seen along its direction: a triangulation of the plane in which every triangle has a
/// height of its own at each of its corners. Solid is what lies below; where heights differ across an edge
/// stands a wall. Whatever the heights, that is a body whose faces all look along the direction or square to
/// it, and any height may be raised. Lengths in steps of the ShadowGrid.
class HeightField {
public:
    using Vertex = TriangleMesh::VertexHandle;
    using Edge = TriangleMesh::EdgeHandle;
    using Halfedge = TriangleMesh::HalfedgeHandle;
    using Face = TriangleMesh::FaceHandle;

    /// Triangles over points, counter-clockwise, all heights 0.
    HeightField(const std::vector<Eigen::Vector2d>& points, const std::vector<std::array<int, 3>>& triangles);

    [[nodiscard]] const TriangleMesh& mesh() const { return m_mesh; }
    [[nodiscard]] Eigen::Vector2d point(Vertex v) const { return m_mesh.point(v).head<2>(); }

    /// Height at the point that a halfedge leads to, in the halfedge's triangle; 0 outside.
    [[nodiscard]] double height(Halfedge h) const { return m_mesh.property(m_height, h); }
    void setHeight(Halfedge h, double height) { m_mesh.property(m_height, h) = height; }

    /// The halfedge of a triangle that leads to v.
    [[nodiscard]] Halfedge corner(Face f, Vertex v) const;

    /// The face of the part that is seen there, −1 for none.
    [[nodiscard]] int seen(Face f) const { return m_mesh.property(m_seen, f); }
    void setSeen(Face f, int face) { m_mesh.property(m_seen, f) = face; }

    /// What tidying may do with a point.
    enum class Origin : std::uint8_t {
        New,  ///< filling made it
        Part, ///< a point of the part is seen there
        Fixed ///< on the parting line, which both halves share
    };
    [[nodiscard]] Origin origin(Vertex v) const { return m_mesh.property(m_origin, v); }
    void setOrigin(Vertex v, Origin origin) { m_mesh.property(m_origin, v) = origin; }

    /// Whether there is anything below the triangle.
    [[nodiscard]] bool solid(Face f) const;

    /// Whether the solid ends at an edge.
    [[nodiscard]] bool outline(Edge e) const;

    /// Twice the area of a triangle in the plane; positive.
    [[nodiscard]] double area(Face f) const;

    /// Whether all triangles run counter-clockwise still when an edge is split at p, which may lie beside it.
    [[nodiscard]] bool splitKeepsOrder(Edge e, const Eigen::Vector2d& p) const;

    /// Puts a point on an edge; heights at it lie between those of the edge's ends, on either side.
    Vertex split(Edge e, const Eigen::Vector2d& p);

    /// Whether a wall stands on an edge, or the solid ends there.
    [[nodiscard]] bool wall(Edge e) const;

    [[nodiscard]] bool collapsible(Halfedge h) { return m_mesh.is_collapse_ok(h); }

    /// Takes the halfedge's first point to its last; `heightThere` says which height there a height here
    /// becomes. Precondition: collapsible.
    void collapse(Halfedge h, const std::function<double(double)>& heightThere);

    /// Turns an edge to join the far corners of its triangles. The new triangles have the heights of `keep`;
    /// at the far corner of the other one that one's, or with `extend` those of the plane of `keep`.
    void flip(Edge e, Face keep, bool extend);

    /// Moves a point; heights stay.
    void move(Vertex v, const Eigen::Vector2d& p) { m_mesh.point(v).head<2>() = p; }

    /// Drops what was collapsed: handles change.
    void compact() { m_mesh.garbage_collection(); }

    /// The height of a triangle's plane at p.
    [[nodiscard]] double planeAt(Face f, const Eigen::Vector2d& p) const;

    /// The triangles about v in order, counter-clockwise.
    [[nodiscard]] std::vector<Face> fan(Vertex v) const;

private:
    TriangleMesh m_mesh;
    OpenMesh::HPropHandleT<double> m_height;
    OpenMesh::FPropHandleT<int> m_seen;
    OpenMesh::VPropHandleT<Origin> m_origin;
};

} // namespace moldwright
