// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/triangle_mesh.h"

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

    /// Whether there is anything below the triangle.
    [[nodiscard]] bool solid(Face f) const;

    /// Whether the solid ends at an edge.
    [[nodiscard]] bool outline(Edge e) const;

    /// Puts a point on an edge; heights at it lie between those of the edge's ends, on either side.
    Vertex split(Edge e, const Eigen::Vector2d& p);

    /// The triangles about v in order, counter-clockwise.
    [[nodiscard]] std::vector<Face> fan(Vertex v) const;

private:
    TriangleMesh m_mesh;
    OpenMesh::HPropHandleT<double> m_height;
    OpenMesh::FPropHandleT<int> m_seen;
};

} // namespace moldwright
