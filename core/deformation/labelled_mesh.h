// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/triangle_mesh.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace moldwright {

/// A closed surface with its parting line inserted, in the plane's frame.
struct LabelledSurface {
    IndexedMesh mesh;
    SideLabels labels;
    std::vector<int> sourceVertex; ///< per point: which point it was before any clean-up
};

struct LabelledPatch;

/// Edges of the parting line at which the surface is folded: LabelledMesh::isFolded().
[[nodiscard]] int countFolds(const LabelledSurface& surface);

/// A labelled surface with topology (OpenMesh), and what may be done to its edges without spoiling the
/// parting line. It is closed, or a patch of a closed one, whose rim stays as it is.
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
    [[nodiscard]] bool onRim(Vertex v) const { return m_mesh.is_boundary(v); }
    /// Whether f and its neighbour across the parting line both lie in the plane: facing opposite ways, they
    /// lie one upon the other, and the part between them has no thickness.
    [[nodiscard]] bool isFolded(Face f) const;

    /// The faces within `rings` rings of v, ascending.
    [[nodiscard]] std::vector<Face> facesAbout(Vertex v, int rings) const;

    /// A copy of these faces alone, to try changes on; none where they do not hang together as a surface.
    [[nodiscard]] std::optional<LabelledPatch> patchAbout(Vertex v, int rings) const;

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
    [[nodiscard]] LabelledSurface surfaceOf(const std::vector<Face>& faces, const std::vector<Vertex>& points,
                                            const std::map<Vertex, Vertex>& copy) const;
    [[nodiscard]] std::vector<Eigen::Vector2d> lineBeyond(const LabelledPatch& patch) const;

    TriangleMesh m_mesh;
    OpenMesh::FPropHandleT<std::uint8_t> m_label;
    OpenMesh::VPropHandleT<int> m_source;
    std::vector<Vertex> m_curvePoints;
    std::shared_ptr<const std::vector<Eigen::Vector2d>> m_lineBeyond; ///< of a patch: the line's other points
};

/// A part of a surface, copied, and where its points come from.
struct LabelledPatch {
    LabelledMesh mesh;
    std::vector<LabelledMesh::Vertex> origin;                  ///< per point of the patch
    std::map<LabelledMesh::Vertex, LabelledMesh::Vertex> copy; ///< of each point that it has

    /// The copy of v; invalid where v is beyond the patch.
    [[nodiscard]] LabelledMesh::Vertex at(LabelledMesh::Vertex v) const;
};

} // namespace moldwright
