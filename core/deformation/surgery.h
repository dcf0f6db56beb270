// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/clean_up.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace moldwright {

/// The surface under repair, and the questions that decide on a change. A copy is another surface.
class Surgery {
public:
    using Vertex = LabelledMesh::Vertex;
    using Face = LabelledMesh::Face;
    using Halfedge = LabelledMesh::Halfedge;

    /// A change made, told by points, which keep their handles: so it can be made again on a surface that has
    /// them under other handles.
    struct Step {
        enum class Kind { Flip, Collapse, Move };
        Kind kind;
        Vertex a, b;           ///< the edge flipped; a collapsed onto b; a moved
        Eigen::Vector3d place; ///< where to, of a move
    };

    Surgery(LabelledMesh mesh, const CleanUpGoal& goal) : m_goal(goal), m_mesh(std::move(mesh)) {}

    /// Mends the faces given anew before each round that need it, worst first, until a round changes nothing.
    void mend(const std::function<std::vector<Face>()>& faces);

    [[nodiscard]] std::vector<Face> allFaces() const;
    /// Those that miss their draft, are folded or too thin, worst first.
    [[nodiscard]] std::vector<Face> facesToMend(const std::vector<Face>& among) const;
    /// Whether it is there, and misses its draft or is folded.
    [[nodiscard]] bool isStuck(Face f) const {
        return !topology().status(f).deleted() && (isShort(f) || m_mesh.isFolded(f));
    }
    [[nodiscard]] int countStuck() const;

    /// Makes a change whether it pays or not.
    void apply(const Step& step);

    [[nodiscard]] const LabelledMesh& mesh() const { return m_mesh; }
    [[nodiscard]] LabelledMesh& mesh() { return m_mesh; }
    /// All changes since it was made.
    [[nodiscard]] const std::vector<Step>& steps() const { return m_steps; }

private:
    using Edge = LabelledMesh::Edge;
    using Corners = LabelledMesh::Corners;

    /// How faces stand: the worst draft, how many miss theirs, and how thin the thinnest is.
    struct Standing {
        double worst = 2;
        int shortOnes = 0;
        double thinnest = 1e300;
    };
    /// A change considered, and how the faces around it would stand.
    struct Change {
        Halfedge halfedge;
        bool flip;
        Standing after;
    };

    [[nodiscard]] const TriangleMesh& topology() const { return m_mesh.topology(); }
    [[nodiscard]] double draft(const Corners& x, int label) const;
    [[nodiscard]] double draft(Face f) const { return draft(m_mesh.corners(f), m_mesh.label(f)); }
    [[nodiscard]] bool isShort(Face f) const { return draft(f) < m_goal.tau; }
    [[nodiscard]] bool tooThin(Face f) const;
    [[nodiscard]] bool needsMending(Face f) const { return isShort(f) || tooThin(f) || m_mesh.isFolded(f); }
    void count(Standing& standing, const Corners& x, int label) const;
    [[nodiscard]] bool pays(const Standing& before, const Standing& after) const;
    [[nodiscard]] std::optional<Change> tryFlip(Halfedge h);
    [[nodiscard]] std::optional<Change> tryCollapse(Halfedge h);
    void mend(Face f);
    void placeCorners(Face f);
    bool placeAnew(Vertex v);

    CleanUpGoal m_goal;
    LabelledMesh m_mesh;
    std::vector<Step> m_steps;
};

} // namespace moldwright
