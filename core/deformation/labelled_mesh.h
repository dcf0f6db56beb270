// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/triangle_mesh.h"

#include <array>
#include <vector>

namespace moldwright {

/// A closed surface with its parting line inserted, in the plane's frame.
struct LabelledSurface {
    IndexedMesh mesh;
    SideLabels labels;
    std::vector<int> sourceVertex; ///< per point: which point it was before any clean-up
};

/// A labelled surface with topology (OpenMesh), and what may be done to its edges without spoiling the
/// parting line.
class LabelledMesh {
public:
    using Vertex = TriangleMesh::VertexHandle;
    using Face = TriangleMesh::FaceHandle;
    using Edge = TriangleMesh::EdgeHandle;
    using Halfedge = TriangleMesh::HalfedgeHandle;
    using Corners = std::array<Eigen::Vector3d, 3>;

    explicit LabelledMesh(const LabelledSurface& surface);

    /// The surface as it is now. Afterwards the handles are others.
    [[nodiscard]] LabelledSurface surface();

    [[nodiscard]] const TriangleMesh& topology() const { return m_mesh; }
    [[nodiscard]] const Eigen::Vector3d& point(Vertex v) const { return m_mesh.point(v); }
    [[nodiscard]] int label(Face f) const { return m_mesh.property(m_label, f); }
    [[nodiscard]] Corners corners(Face f) const;
    [[nodiscard]] bool onCurve(Edge e) const;
    [[nodiscard]] bool onCurve(Vertex v) const;
    [[nodiscard]] bool onPlane(Vertex v) const { return m_mesh.point(v).z() == 0; }

    /// May the edge be flipped? Not on the line, and not where a face would lie in the plane.
    [[nodiscard]] bool mayFlip(Edge e);

    /// May h's from-vertex move onto its to-vertex? Only along the line when it is on it, and only where the
    /// line stays simple, with more than three points a loop.
    [[nodiscard]] bool mayCollapse(Halfedge h);

    void move(Vertex v, const Eigen::Vector3d& place) { m_mesh.point(v) = place; }
    void flip(Edge e) { m_mesh.flip(e); }
    void collapse(Halfedge h);

private:
    [[nodiscard]] bool lineAllows(Halfedge h) const;
    [[nodiscard]] bool loopIsShort(Vertex p, Vertex q) const;

    TriangleMesh m_mesh;
    OpenMesh::FPropHandleT<std::uint8_t> m_label;
    OpenMesh::VPropHandleT<int> m_source;
    std::vector<Vertex> m_curvePoints;
};

} // namespace moldwright
