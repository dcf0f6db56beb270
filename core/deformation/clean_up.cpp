// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/clean_up.h"

#include "deformation/best_place.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

using Vertex = LabelledMesh::Vertex;
using Face = LabelledMesh::Face;
using Edge = LabelledMesh::Edge;
using Halfedge = LabelledMesh::Halfedge;
using Corners = LabelledMesh::Corners;

constexpr double kGain = 1e-6;   ///< a change must raise the worst N·d by this much
constexpr double kTurn = 0.3;    ///< no face may turn further than the angle of this cosine in a collapse
constexpr double kLowest = 0.15; ///< share of its height that a point placed anew keeps
constexpr double kHighest = 1.5; ///< times its height: slopes grow with the height
constexpr int kRounds = 4;
constexpr int kRingsMended = 3;  ///< about a forced collapse
constexpr int kRingsCounted = 6; ///< beyond what mending can reach

double altitude(const Corners& x) {
    const double longest = std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
    return longest > 0 ? (x[1] - x[0]).cross(x[2] - x[0]).norm() / longest : 0;
}

Eigen::Vector3d normalOf(const Corners& x) {
    const Eigen::Vector3d c = (x[1] - x[0]).cross(x[2] - x[0]);
    const double length = c.norm();
    return length > 0 ? Eigen::Vector3d(c / length) : Eigen::Vector3d::Zero();
}

/// The surface under repair, and the questions that decide on a change.
class Surgery {
public:
    Surgery(const LabelledSurface& surface, const CleanUpGoal& goal) : m_goal(goal), m_mesh(surface) {}

    int run() {
        return mendRounds([this] { return allFaces(); });
    }

    /// Forces a collapse at each face that is stuck, where that leaves fewer faces short.
    int dislodge() {
        int changes = 0;
        for (const Face f : facesToMend(allFaces()))
            if (!topology().status(f).deleted() && isShort(f))
                changes += force(f);
        return changes;
    }

    LabelledSurface result() { return m_mesh.surface(); }

private:
    /// A change considered: how the worst draft around it would be, and how thin its thinnest face.
    struct Change {
        Halfedge halfedge;
        bool flip = false;
        double worst = -2;
        double thinnest = 0;
    };

    [[nodiscard]] const TriangleMesh& topology() const { return m_mesh.topology(); }

    [[nodiscard]] double draft(const Corners& x, int label) const {
        return normalOf(x).dot(m_goal.directions.of(label));
    }
    [[nodiscard]] double draft(Face f) const { return draft(m_mesh.corners(f), m_mesh.label(f)); }

    [[nodiscard]] bool tooThin(Face f) const {
        const Corners x = m_mesh.corners(f);
        const double shortest = std::min({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
        return shortest < m_goal.shortestEdge || altitude(x) < m_goal.smallestAltitude;
    }

    [[nodiscard]] bool isShort(Face f) const { return draft(f) < m_goal.tau; }
    [[nodiscard]] bool needsMending(Face f) const { return isShort(f) || tooThin(f); }

    [[nodiscard]] std::vector<Face> allFaces() const {
        std::vector<Face> faces;
        for (const auto f : topology().faces())
            faces.push_back(f);
        return faces;
    }

    /// The faces within `rings` rings of v.
    [[nodiscard]] std::vector<Face> facesAbout(Vertex v, int rings) const {
        std::set<Vertex> seen{v};
        std::set<Face> faces;
        std::vector<Vertex> rim{v};
        for (int ring = 0; ring < rings; ++ring) {
            std::vector<Vertex> next;
            for (const Vertex r : rim) {
                for (const auto f : topology().vf_range(r))
                    faces.insert(f);
                for (const auto w : topology().vv_range(r))
                    if (seen.insert(w).second)
                        next.push_back(w);
            }
            rim = std::move(next);
        }
        return {faces.begin(), faces.end()};
    }

    /// Worst first, so that what hurts most has the first choice.
    [[nodiscard]] std::vector<Face> facesToMend(const std::vector<Face>& among) const {
        std::vector<std::pair<double, Face>> found;
        for (const Face f : among)
            if (!topology().status(f).deleted() && needsMending(f))
                found.emplace_back(draft(f), f);
        std::stable_sort(found.begin(), found.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Face> faces;
        for (const auto& [worst, f] : found)
            faces.push_back(f);
        return faces;
    }

    int mendRounds(const std::function<std::vector<Face>()>& faces) {
        int changes = 0;
        for (int round = 0; round < kRounds; ++round) {
            const int before = changes;
            for (const Face f : facesToMend(faces()))
                if (!topology().status(f).deleted() && needsMending(f))
                    changes += mend(f);
            if (changes == before)
                break;
        }
        return changes;
    }

    /// What a forced collapse and the mending after it come to.
    struct Trial {
        LabelledMesh mesh;
        int freed; ///< faces below τ before, less those after
        int changes;
        bool operator<(const Trial& other) const {
            return std::pair(-freed, changes) < std::pair(-other.freed, other.changes);
        }
    };

    /// Collapses an edge at f although that makes matters worse at first, and mends what comes of it. Of all
    /// such collapses the one that leaves the fewest faces short; none where that is no fewer than now.
    int force(Face f) {
        std::set<Halfedge> edges;
        for (const auto v : topology().fv_range(f))
            for (const auto h : topology().voh_range(v)) {
                edges.insert(h);
                edges.insert(topology().opposite_halfedge_handle(h));
            }
        std::optional<Trial> best;
        for (const Halfedge h : edges)
            if (m_mesh.mayCollapse(h)) {
                Trial trial = tryForcing(h);
                if (trial.freed > 0 && (!best || trial < *best))
                    best.emplace(std::move(trial));
            }
        if (!best)
            return 0;
        m_mesh = std::move(best->mesh);
        return best->changes;
    }

    [[nodiscard]] Trial tryForcing(Halfedge h) const {
        Surgery surgery = *this;
        const Vertex kept = topology().to_vertex_handle(h);
        const std::vector<Face> near = facesAbout(kept, kRingsCounted);
        surgery.m_mesh.collapse(h);
        const int mended = surgery.mendRounds([&] {
            return surgery.topology().status(kept).deleted() ? std::vector<Face>{}
                                                             : surgery.facesAbout(kept, kRingsMended);
        });
        const int fewer = countShort(near) - surgery.countShort(near);
        return {std::move(surgery.m_mesh), fewer, 1 + mended};
    }

    [[nodiscard]] int countShort(const std::vector<Face>& faces) const {
        return static_cast<int>(std::count_if(faces.begin(), faces.end(), [this](Face f) {
            return !topology().status(f).deleted() && isShort(f);
        }));
    }

    bool mend(Face f) {
        std::optional<Change> best;
        const auto consider = [&](std::optional<Change> change) {
            if (change && (!best || change->worst > best->worst))
                best = change;
        };
        for (const auto h : topology().fh_range(f)) {
            consider(tryFlip(h));
            consider(tryCollapse(h));
            consider(tryCollapse(topology().opposite_halfedge_handle(h)));
        }
        if (!best)
            return isShort(f) && placeCorners(f);
        if (best->flip)
            m_mesh.flip(topology().edge_handle(best->halfedge));
        else
            m_mesh.collapse(best->halfedge);
        return true;
    }

    /// Moves a free corner of f to its best place; only if the worst draft about it rises.
    bool placeCorners(Face f) {
        for (const auto v : topology().fv_range(f))
            if (!m_mesh.onPlane(v) && placeAnew(v))
                return true;
        return false;
    }

    bool placeAnew(Vertex v) {
        std::vector<FaceToPlace> faces;
        for (const auto h : topology().voh_range(v)) {
            const Face f = topology().face_handle(h);
            faces.push_back({m_mesh.point(topology().to_vertex_handle(h)),
                             m_mesh.point(topology().to_vertex_handle(topology().next_halfedge_handle(h))),
                             m_goal.directions.of(m_mesh.label(f))});
        }
        const Eigen::Vector3d old = m_mesh.point(v);
        const double before = worst(faces, old);
        if (before >= m_goal.tau)
            return false;
        const Eigen::Vector3d place = bestPlace(faces, old, boundsAt(old, faces), m_goal.tau);
        if (worst(faces, place) <= before + kGain)
            return false;
        m_mesh.move(v, place);
        return true;
    }

    static PlaceBounds boundsAt(const Eigen::Vector3d& place, const std::vector<FaceToPlace>& faces) {
        PlaceBounds bounds{0, kLowest * place.z(), kHighest * place.z()};
        if (place.z() < 0)
            std::swap(bounds.low, bounds.high);
        for (const FaceToPlace& face : faces)
            bounds.reach = std::max(bounds.reach, (face.a - place).norm());
        return bounds;
    }

    static double worst(const std::vector<FaceToPlace>& faces, const Eigen::Vector3d& place) {
        double least = 1;
        for (const FaceToPlace& face : faces)
            least = std::min(least, normalOf({place, face.a, face.b}).dot(face.direction));
        return least;
    }

    /// Is it worth it? Mended draft must rise; a thin face may go as long as draft stays at τ or where it
    /// was.
    [[nodiscard]] bool pays(const Change& change, double worstBefore, double thinnestBefore) const {
        if (change.worst > worstBefore + kGain && worstBefore < m_goal.tau)
            return change.thinnest > std::min(thinnestBefore, m_goal.smallestAltitude);
        return change.thinnest > 2 * thinnestBefore && change.worst >= std::min(worstBefore, m_goal.tau);
    }

    [[nodiscard]] std::optional<Change> tryFlip(Halfedge h) {
        const Edge e = topology().edge_handle(h);
        if (!m_mesh.mayFlip(e))
            return std::nullopt;
        const Halfedge o = topology().opposite_halfedge_handle(h);
        const Face f = topology().face_handle(h);
        const Face g = topology().face_handle(o);
        const int label = m_mesh.label(f);
        const Eigen::Vector3d& a = m_mesh.point(topology().from_vertex_handle(h));
        const Eigen::Vector3d& b = m_mesh.point(topology().to_vertex_handle(h));
        const Eigen::Vector3d& c =
            m_mesh.point(topology().to_vertex_handle(topology().next_halfedge_handle(h)));
        const Eigen::Vector3d& d =
            m_mesh.point(topology().to_vertex_handle(topology().next_halfedge_handle(o)));
        const Corners first{c, d, b};
        const Corners second{d, c, a};
        const double before = std::min(draft(f), draft(g));
        const double thin = std::min(altitude(m_mesh.corners(f)), altitude(m_mesh.corners(g)));
        const Change change{h, true, std::min(draft(first, label), draft(second, label)),
                            std::min(altitude(first), altitude(second))};
        return pays(change, before, thin) ? std::optional(change) : std::nullopt;
    }

    /// The collapse of h: its from-vertex moves onto its to-vertex.
    [[nodiscard]] std::optional<Change> tryCollapse(Halfedge h) {
        if (!m_mesh.mayCollapse(h))
            return std::nullopt;
        const Vertex gone = topology().from_vertex_handle(h);
        const Vertex kept = topology().to_vertex_handle(h);
        Change change{h, false, 2, 1e300};
        double before = 2;
        double thin = 1e300;
        const Face left = topology().face_handle(h);
        const Face right = topology().face_handle(topology().opposite_halfedge_handle(h));
        for (const auto f : topology().vf_range(gone)) {
            const Corners old = m_mesh.corners(f);
            before = std::min(before, draft(f));
            thin = std::min(thin, altitude(old));
            if (f == left || f == right)
                continue;
            Corners moved;
            std::size_t k = 0;
            int flat = 0;
            for (const auto v : topology().fv_range(f)) {
                moved[k++] = m_mesh.point(v == gone ? kept : Vertex(v));
                flat += moved[k - 1].z() == 0;
            }
            const bool wasFlat = old[0].z() == 0 && old[1].z() == 0 && old[2].z() == 0;
            const double turn = normalOf(moved).dot(normalOf(old));
            const bool oldMeansSomething = altitude(old) > m_goal.smallestAltitude;
            if ((flat == 3 && !wasFlat) || (oldMeansSomething && draft(f) >= m_goal.tau && turn < kTurn))
                return std::nullopt;
            change.worst = std::min(change.worst, draft(moved, m_mesh.label(f)));
            change.thinnest = std::min(change.thinnest, altitude(moved));
        }
        return pays(change, before, thin) ? std::optional(change) : std::nullopt;
    }

    CleanUpGoal m_goal;
    LabelledMesh m_mesh;
};

} // namespace

int cleanUp(LabelledSurface& surface, const CleanUpGoal& goal) {
    Surgery surgery(surface, goal);
    const int changes = surgery.run();
    if (changes > 0)
        surface = surgery.result();
    return changes;
}

int dislodge(LabelledSurface& surface, const CleanUpGoal& goal) {
    Surgery surgery(surface, goal);
    const int changes = surgery.dislodge();
    if (changes > 0)
        surface = surgery.result();
    return changes;
}

} // namespace moldwright
