// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/surgery.h"

#include "deformation/best_place.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>

namespace moldwright {

namespace {

using Vertex = LabelledMesh::Vertex;
using Face = LabelledMesh::Face;
using Halfedge = LabelledMesh::Halfedge;
using Corners = LabelledMesh::Corners;

constexpr double kGain = 1e-6;   ///< a change must raise the worst N·d by this much
constexpr double kTurn = 0.3;    ///< no face may turn further than the angle of this cosine in a collapse
constexpr double kLowest = 0.15; ///< share of its height that a point placed anew keeps
constexpr double kHighest = 1.5; ///< times its height: slopes grow with the height
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

PlaceBounds boundsAt(const Eigen::Vector3d& place, const std::vector<FaceToPlace>& faces) {
    PlaceBounds bounds{0, kLowest * place.z(), kHighest * place.z()};
    if (place.z() < 0)
        std::swap(bounds.low, bounds.high);
    for (const FaceToPlace& face : faces)
        bounds.reach = std::max(bounds.reach, (face.a - place).norm());
    return bounds;
}

double worst(const std::vector<FaceToPlace>& faces, const Eigen::Vector3d& place) {
    double least = 1;
    for (const FaceToPlace& face : faces)
        least = std::min(least, normalOf({place, face.a, face.b}).dot(face.direction));
    return least;
}

} // namespace

double Surgery::draft(const Corners& x, int label) const {
    return normalOf(x).dot(m_goal.directions.of(label));
}

bool Surgery::tooThin(Face f) const {
    const Corners x = m_mesh.corners(f);
    const double shortest = std::min({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
    return shortest < m_goal.shortestEdge || altitude(x) < m_goal.smallestAltitude;
}

std::vector<Face> Surgery::allFaces() const {
    std::vector<Face> faces;
    for (const auto f : topology().faces())
        faces.push_back(f);
    return faces;
}

int Surgery::countStuck() const {
    const std::vector<Face> faces = allFaces();
    return static_cast<int>(std::ranges::count_if(faces, [this](Face f) { return isStuck(f); }));
}

// Worst first, so that what hurts most has the first choice.
std::vector<Face> Surgery::facesToMend(const std::vector<Face>& among) const {
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

void Surgery::mend(const std::function<std::vector<Face>()>& faces) {
    for (int round = 0; round < kRounds; ++round) {
        const std::size_t before = m_steps.size();
        for (const Face f : facesToMend(faces()))
            if (!topology().status(f).deleted() && needsMending(f))
                mend(f);
        if (m_steps.size() == before)
            break;
    }
}

void Surgery::apply(const Step& step) {
    m_steps.push_back(step);
    if (step.kind == Step::Kind::Move)
        return m_mesh.move(step.a, step.place);
    const Halfedge h = topology().find_halfedge(step.a, step.b);
    if (step.kind == Step::Kind::Flip)
        m_mesh.flip(topology().edge_handle(h));
    else
        m_mesh.collapse(h);
}

void Surgery::mend(Face f) {
    std::optional<Change> best;
    const auto consider = [&](std::optional<Change> change) {
        if (change && (!best || change->after.worst > best->after.worst))
            best = change;
    };
    for (const auto h : topology().fh_range(f)) {
        consider(tryFlip(h));
        consider(tryCollapse(h));
        consider(tryCollapse(topology().opposite_halfedge_handle(h)));
    }
    if (best)
        apply({best->flip ? Step::Kind::Flip : Step::Kind::Collapse,
               topology().from_vertex_handle(best->halfedge),
               topology().to_vertex_handle(best->halfedge),
               {}});
    else if (isShort(f))
        placeCorners(f);
}

/// Moves a free corner of f to its best place; only if the worst draft about it rises.
void Surgery::placeCorners(Face f) {
    for (const auto v : topology().fv_range(f))
        if (!m_mesh.onPlane(v) && !m_mesh.onRim(v) && placeAnew(v))
            return;
}

bool Surgery::placeAnew(Vertex v) {
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
    apply({Step::Kind::Move, v, Vertex(), place});
    return true;
}

void Surgery::count(Standing& standing, const Corners& x, int label) const {
    const double drafted = draft(x, label);
    standing.worst = std::min(standing.worst, drafted);
    standing.shortOnes += drafted < m_goal.tau;
    standing.thinnest = std::min(standing.thinnest, altitude(x));
}

/// Is it worth it? Mended draft must rise, or fewer faces miss theirs: a fin along the line, whose faces
/// stand back to back, goes face by face. A thin face may go as long as draft stays at τ or where it was.
bool Surgery::pays(const Standing& before, const Standing& after) const {
    const bool rises = before.worst < m_goal.tau && after.worst > before.worst + kGain;
    const bool fewer = after.shortOnes < before.shortOnes && after.worst >= before.worst;
    if (rises || fewer)
        return after.thinnest > std::min(before.thinnest, m_goal.smallestAltitude);
    return after.thinnest > 2 * before.thinnest && after.worst >= std::min(before.worst, m_goal.tau);
}

std::optional<Surgery::Change> Surgery::tryFlip(Halfedge h) {
    const Edge e = topology().edge_handle(h);
    if (!m_mesh.mayFlip(e))
        return std::nullopt;
    const Halfedge o = topology().opposite_halfedge_handle(h);
    const Face f = topology().face_handle(h);
    const Face g = topology().face_handle(o);
    const int label = m_mesh.label(f);
    const Eigen::Vector3d& a = m_mesh.point(topology().from_vertex_handle(h));
    const Eigen::Vector3d& b = m_mesh.point(topology().to_vertex_handle(h));
    const Eigen::Vector3d& c = m_mesh.point(topology().to_vertex_handle(topology().next_halfedge_handle(h)));
    const Eigen::Vector3d& d = m_mesh.point(topology().to_vertex_handle(topology().next_halfedge_handle(o)));
    Standing before;
    count(before, m_mesh.corners(f), label);
    count(before, m_mesh.corners(g), label);
    Standing after;
    count(after, {c, d, b}, label);
    count(after, {d, c, a}, label);
    return pays(before, after) ? std::optional(Change{h, true, after}) : std::nullopt;
}

/// The collapse of h: its from-vertex moves onto its to-vertex.
std::optional<Surgery::Change> Surgery::tryCollapse(Halfedge h) {
    if (!m_mesh.mayCollapse(h))
        return std::nullopt;
    const Vertex gone = topology().from_vertex_handle(h);
    const Vertex kept = topology().to_vertex_handle(h);
    Standing before;
    Standing after;
    const Face left = topology().face_handle(h);
    const Face right = topology().face_handle(topology().opposite_halfedge_handle(h));
    for (const auto f : topology().vf_range(gone)) {
        const Corners old = m_mesh.corners(f);
        count(before, old, m_mesh.label(f));
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
        count(after, moved, m_mesh.label(f));
    }
    return pays(before, after) ? std::optional(Change{h, false, after}) : std::nullopt;
}

} // namespace moldwright
