// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/clean_up.h"

#include "deformation/curve_barrier.h"
#include "mesh/triangle_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace moldwright {

namespace {

using Vertex = TriangleMesh::VertexHandle;
using Face = TriangleMesh::FaceHandle;
using Edge = TriangleMesh::EdgeHandle;
using Halfedge = TriangleMesh::HalfedgeHandle;
using Corners = std::array<Eigen::Vector3d, 3>;

constexpr double kGain = 1e-6; ///< a change must raise the worst N·d by this much
constexpr double kTurn = 0.3;  ///< no face may turn further than the angle of this cosine in a collapse
constexpr int kRounds = 4;

double altitude(const Corners& x) {
    const double longest = std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
    return longest > 0 ? (x[1] - x[0]).cross(x[2] - x[0]).norm() / longest : 0;
}

Eigen::Vector3d normalOf(const Corners& x) {
    const Eigen::Vector3d c = (x[1] - x[0]).cross(x[2] - x[0]);
    const double length = c.norm();
    return length > 0 ? Eigen::Vector3d(c / length) : Eigen::Vector3d::Zero();
}

/// The surface under repair: OpenMesh with labels, and the questions that decide on a change.
class Surgery {
public:
    Surgery(const LabelledSurface& surface, const CleanUpGoal& goal)
        : m_goal(goal), m_mesh(toTriangleMesh(surface.mesh)) {
        m_mesh.add_property(m_label);
        for (const auto f : m_mesh.faces())
            m_mesh.property(m_label, f) = surface.labels[static_cast<std::size_t>(f.idx())];
        m_mesh.add_property(m_source);
        for (const auto v : m_mesh.vertices())
            m_mesh.property(m_source, v) = surface.sourceVertex[static_cast<std::size_t>(v.idx())];
        gatherCurve();
    }

    int run() {
        int changes = 0;
        for (int round = 0; round < kRounds; ++round) {
            const int before = changes;
            for (const Face f : facesToMend())
                if (!m_mesh.status(f).deleted() && needsMending(f))
                    changes += mend(f);
            if (changes == before)
                break;
        }
        return changes;
    }

    LabelledSurface result() {
        m_mesh.garbage_collection();
        LabelledSurface surface{toIndexedMesh(m_mesh), {}, {}};
        for (const auto f : m_mesh.faces())
            surface.labels.push_back(m_mesh.property(m_label, f));
        for (const auto v : m_mesh.vertices())
            surface.sourceVertex.push_back(m_mesh.property(m_source, v));
        return surface;
    }

private:
    /// A change considered: how the worst draft around it would be, and how thin its thinnest face.
    struct Change {
        Halfedge halfedge;
        bool flip = false;
        double worst = -2;
        double thinnest = 0;
    };

    [[nodiscard]] Corners cornersOf(Face f) const {
        Corners x;
        std::size_t k = 0;
        for (const auto v : m_mesh.fv_range(f))
            x[k++] = m_mesh.point(v);
        return x;
    }

    [[nodiscard]] double draft(const Corners& x, int label) const {
        return normalOf(x).dot(m_goal.directions.of(label));
    }
    [[nodiscard]] double draft(Face f) const { return draft(cornersOf(f), m_mesh.property(m_label, f)); }

    [[nodiscard]] bool tooThin(Face f) const {
        const Corners x = cornersOf(f);
        const double shortest = std::min({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
        return shortest < m_goal.shortestEdge || altitude(x) < m_goal.smallestAltitude;
    }

    [[nodiscard]] bool needsMending(Face f) const { return draft(f) < m_goal.tau || tooThin(f); }

    /// Worst first, so that what hurts most has the first choice.
    [[nodiscard]] std::vector<Face> facesToMend() const {
        std::vector<std::pair<double, Face>> found;
        for (const auto f : m_mesh.faces())
            if (needsMending(f))
                found.emplace_back(draft(f), f);
        std::stable_sort(found.begin(), found.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Face> faces;
        for (const auto& [worst, f] : found)
            faces.push_back(f);
        return faces;
    }

    [[nodiscard]] bool onCurve(Edge e) const {
        const auto h = m_mesh.halfedge_handle(e, 0);
        const auto o = m_mesh.halfedge_handle(e, 1);
        return m_mesh.property(m_label, m_mesh.face_handle(h)) !=
               m_mesh.property(m_label, m_mesh.face_handle(o));
    }

    [[nodiscard]] bool onCurve(Vertex v) const {
        const auto edges = m_mesh.ve_range(v);
        return std::any_of(edges.begin(), edges.end(), [&](auto e) { return onCurve(e); });
    }

    void gatherCurve() {
        m_curvePoints.clear();
        for (const auto v : m_mesh.vertices())
            if (onCurve(v))
                m_curvePoints.push_back(v);
    }

    bool mend(Face f) {
        std::optional<Change> best;
        const auto consider = [&](std::optional<Change> change) {
            if (change && (!best || change->worst > best->worst))
                best = change;
        };
        for (const auto h : m_mesh.fh_range(f)) {
            consider(tryFlip(h));
            consider(tryCollapse(h));
            consider(tryCollapse(m_mesh.opposite_halfedge_handle(h)));
        }
        if (!best)
            return relocateCorners(f);
        if (best->flip) {
            m_mesh.flip(m_mesh.edge_handle(best->halfedge));
            return true;
        }
        const bool curve = onCurve(m_mesh.edge_handle(best->halfedge));
        m_mesh.collapse(best->halfedge);
        if (curve)
            std::erase_if(m_curvePoints, [&](Vertex v) { return m_mesh.status(v).deleted(); });
        return true;
    }

    /// Moves a free corner of f to the best of a few places about its neighbours' middle, at its height or
    /// nearer to the plane (slopes fall with the height); only if the worst draft about it rises.
    bool relocateCorners(Face f) {
        for (const auto v : m_mesh.fv_range(f))
            if (!onPlane(v) && relocate(v))
                return true;
        return false;
    }

    bool relocate(Vertex v) {
        const Eigen::Vector3d old = m_mesh.point(v);
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        int around = 0;
        for (const auto w : m_mesh.vv_range(v)) {
            middle += m_mesh.point(w);
            ++around;
        }
        middle /= around;
        double best = worstAround(v);
        if (best >= m_goal.tau)
            return false;
        Eigen::Vector3d chosen = old;
        for (const double inward : {0.0, 0.25, 0.5, 1.0})
            for (const double lowered : {1.0, 0.7, 0.4, 0.15}) {
                m_mesh.point(v) << (1 - inward) * old.head<2>() + inward * middle.head<2>(),
                    lowered * old.z();
                const double worst = worstAround(v);
                if (worst > best + kGain) {
                    best = worst;
                    chosen = m_mesh.point(v);
                }
            }
        m_mesh.point(v) = chosen;
        return chosen != old;
    }

    [[nodiscard]] double worstAround(Vertex v) const {
        double worst = 1;
        for (const auto f : m_mesh.vf_range(v))
            worst = std::min(worst, draft(f));
        return worst;
    }

    /// Is it worth it? Mended draft must rise; a thin face may go as long as draft stays at τ or where it
    /// was.
    [[nodiscard]] bool pays(const Change& change, double worstBefore, double thinnestBefore) const {
        if (change.worst > worstBefore + kGain && worstBefore < m_goal.tau)
            return change.thinnest > std::min(thinnestBefore, m_goal.smallestAltitude);
        return change.thinnest > 2 * thinnestBefore && change.worst >= std::min(worstBefore, m_goal.tau);
    }

    [[nodiscard]] std::optional<Change> tryFlip(Halfedge h) const {
        const Edge e = m_mesh.edge_handle(h);
        if (onCurve(e) || !m_mesh.is_flip_ok(e))
            return std::nullopt;
        const Halfedge o = m_mesh.opposite_halfedge_handle(h);
        const int label = m_mesh.property(m_label, m_mesh.face_handle(h));
        const Vertex a = m_mesh.from_vertex_handle(h);
        const Vertex b = m_mesh.to_vertex_handle(h);
        const Vertex c = m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(h));
        const Vertex d = m_mesh.to_vertex_handle(m_mesh.next_halfedge_handle(o));
        const bool laysFlat = (onPlane(c) && onPlane(d)) && (onPlane(a) || onPlane(b));
        if (laysFlat)
            return std::nullopt;
        const Corners first{m_mesh.point(c), m_mesh.point(d), m_mesh.point(b)};
        const Corners second{m_mesh.point(d), m_mesh.point(c), m_mesh.point(a)};
        const Face f = m_mesh.face_handle(h);
        const Face g = m_mesh.face_handle(o);
        const double before = std::min(draft(f), draft(g));
        const double thin = std::min(altitude(cornersOf(f)), altitude(cornersOf(g)));
        const Change change{h, true, std::min(draft(first, label), draft(second, label)),
                            std::min(altitude(first), altitude(second))};
        return pays(change, before, thin) ? std::optional(change) : std::nullopt;
    }

    [[nodiscard]] bool onPlane(Vertex v) const { return m_mesh.point(v).z() == 0; }

    /// The collapse of h: its from-vertex moves onto its to-vertex.
    [[nodiscard]] std::optional<Change> tryCollapse(Halfedge h) {
        const Vertex gone = m_mesh.from_vertex_handle(h);
        const Vertex kept = m_mesh.to_vertex_handle(h);
        const bool curve = onCurve(m_mesh.edge_handle(h));
        if ((onCurve(gone) && !curve) || !m_mesh.is_collapse_ok(h) || (curve && !curveAllows(h)))
            return std::nullopt;
        Change change{h, false, 2, 1e300};
        double before = 2;
        double thin = 1e300;
        const Face left = m_mesh.face_handle(h);
        const Face right = m_mesh.face_handle(m_mesh.opposite_halfedge_handle(h));
        for (const auto f : m_mesh.vf_range(gone)) {
            const Corners old = cornersOf(f);
            before = std::min(before, draft(f));
            thin = std::min(thin, altitude(old));
            if (f == left || f == right)
                continue;
            Corners moved;
            std::size_t k = 0;
            int flat = 0;
            for (const auto v : m_mesh.fv_range(f)) {
                moved[k++] = m_mesh.point(v == gone ? kept : Vertex(v));
                flat += moved[k - 1].z() == 0;
            }
            const bool wasFlat = old[0].z() == 0 && old[1].z() == 0 && old[2].z() == 0;
            const double turn = normalOf(moved).dot(normalOf(old));
            const bool oldMeansSomething = altitude(old) > m_goal.smallestAltitude;
            if ((flat == 3 && !wasFlat) || (oldMeansSomething && draft(f) >= m_goal.tau && turn < kTurn))
                return std::nullopt;
            change.worst = std::min(change.worst, draft(moved, m_mesh.property(m_label, f)));
            change.thinnest = std::min(change.thinnest, altitude(moved));
        }
        return pays(change, before, thin) ? std::optional(change) : std::nullopt;
    }

    /// May the curve lose `gone`? Its neighbours on the curve are then joined: p–gone–kept becomes p–kept.
    /// The curve stays simple exactly when no other of its points lies in that triangle; a loop keeps more
    /// than three points.
    [[nodiscard]] bool curveAllows(Halfedge h) const {
        const Vertex gone = m_mesh.from_vertex_handle(h);
        const Vertex kept = m_mesh.to_vertex_handle(h);
        std::vector<Vertex> neighbours;
        for (const auto w : m_mesh.voh_range(gone))
            if (onCurve(m_mesh.edge_handle(w)))
                neighbours.push_back(m_mesh.to_vertex_handle(w));
        if (neighbours.size() != 2)
            return false;
        const Vertex p = neighbours[0] == kept ? neighbours[1] : neighbours[0];
        for (const auto w : m_mesh.voh_range(kept)) {
            const Vertex q = m_mesh.to_vertex_handle(w);
            if (q != gone && onCurve(m_mesh.edge_handle(w)) && loopIsShort(p, q))
                return false;
        }
        const auto at = [&](Vertex v) -> Eigen::Vector2d { return m_mesh.point(v).head<2>(); };
        const double margin = 0.01 * (at(gone) - at(kept)).norm();
        return std::none_of(m_curvePoints.begin(), m_curvePoints.end(), [&](Vertex v) {
            return v != p && v != gone && v != kept && nearTriangle(at(v), at(p), at(gone), at(kept), margin);
        });
    }

    /// After a collapse the loop would be p – kept – q: too short when p and q are joined by the curve or the
    /// same.
    [[nodiscard]] bool loopIsShort(Vertex p, Vertex q) const {
        if (p == q)
            return true;
        const Halfedge h = m_mesh.find_halfedge(p, q);
        return h.is_valid() && onCurve(m_mesh.edge_handle(h));
    }

    /// Inside the triangle, or within `margin` of it. By distances: a point far along a straight curve is
    /// near the lines of all three sides, not near the triangle.
    static bool nearTriangle(const Eigen::Vector2d& q, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                             const Eigen::Vector2d& c, double margin) {
        const auto turn = [&](const Eigen::Vector2d& s, const Eigen::Vector2d& t) {
            return (t - s).x() * (q - s).y() - (t - s).y() * (q - s).x();
        };
        const double t0 = turn(a, b);
        const double t1 = turn(b, c);
        const double t2 = turn(c, a);
        const bool inside = (t0 > 0 && t1 > 0 && t2 > 0) || (t0 < 0 && t1 < 0 && t2 < 0);
        return inside || std::min({segmentDistance(q, a, b).distance, segmentDistance(q, b, c).distance,
                                   segmentDistance(q, c, a).distance}) <= margin;
    }

    CleanUpGoal m_goal;
    TriangleMesh m_mesh;
    OpenMesh::FPropHandleT<std::uint8_t> m_label;
    OpenMesh::VPropHandleT<int> m_source;
    std::vector<Vertex> m_curvePoints;
};

} // namespace

int cleanUp(LabelledSurface& surface, const CleanUpGoal& goal) {
    Surgery surgery(surface, goal);
    const int changes = surgery.run();
    if (changes > 0)
        surface = surgery.result();
    return changes;
}

} // namespace moldwright
