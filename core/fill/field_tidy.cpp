// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/field_tidy.h"

#include "fill/projected_half.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldwright {

namespace {

using Vertex = HeightField::Vertex;
using Edge = HeightField::Edge;
using Halfedge = HeightField::Halfedge;
using Face = HeightField::Face;
using Origin = HeightField::Origin;

constexpr int kRounds = 6;
constexpr double kThin = 0.3;           ///< of the short edge: a triangle is thin below this altitude
constexpr double kNextToNothing = 0.01; ///< of `flat`
constexpr double kRounder = 1.5; ///< a turned edge must make the thinner triangle rounder by this factor

double altitude(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return doubleArea(a, b, c) / std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

class Tidying {
public:
    Tidying(HeightField& field, const TidyGoal& goal) : m_field(field), m_goal(goal) {}

    bool collapseAll(Origin which) {
        bool changed = false;
        const std::size_t count = mesh().n_vertices();
        for (std::size_t i = 0; i < count; ++i) {
            const Vertex v(static_cast<int>(i));
            if (!mesh().status(v).deleted() && m_field.origin(v) == which && touched(v))
                changed = collapseAway(v) || changed;
        }
        return changed;
    }

    bool turnThin() {
        bool changed = false;
        const std::size_t count = mesh().n_faces();
        for (std::size_t i = 0; i < count; ++i) {
            const Face f(static_cast<int>(i));
            if (!mesh().status(f).deleted() && altitudeOf(f) < thin() && turnLongest(f))
                changed = true;
        }
        return changed;
    }

private:
    [[nodiscard]] const TriangleMesh& mesh() const { return m_field.mesh(); }
    [[nodiscard]] double thin() const { return kThin * m_goal.shortEdge; }

    /// Points that filling made, and those where a wall stands.
    [[nodiscard]] bool touched(Vertex v) const {
        const auto edges = mesh().ve_range(v);
        return m_field.origin(v) == Origin::New ||
               std::any_of(edges.begin(), edges.end(), [&](auto e) { return m_field.wall(e); });
    }

    [[nodiscard]] double altitudeOf(Face f) const {
        const Halfedge h = mesh().halfedge_handle(f);
        return altitude(m_field.point(mesh().from_vertex_handle(h)),
                        m_field.point(mesh().to_vertex_handle(h)),
                        m_field.point(mesh().to_vertex_handle(mesh().next_halfedge_handle(h))));
    }

    /// Collapses v to its nearest neighbour that allows it.
    bool collapseAway(Vertex v) {
        std::vector<std::pair<double, Halfedge>> ways;
        for (const auto h : mesh().voh_range(v))
            ways.emplace_back((m_field.point(mesh().to_vertex_handle(h)) - m_field.point(v)).norm(), h);
        std::stable_sort(ways.begin(), ways.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [length, h] : ways)
            if (keepsOutline(h) && keepsRound(h) && m_field.collapsible(h) &&
                (collapseAlong(h) || collapseAcross(h)))
                return true;
        return false;
    }

    /// Where all heights at the point that goes go on to the other end: along a wall, or on one surface.
    bool collapseAlong(Halfedge h) {
        if (!keepsWalls(h) || (!isShort(h) && !isFlat(h)))
            return false;
        const double left = heightsFrom(h)[0];
        const auto to = heightsTo(h);
        m_field.collapse(h, [&](double height) { return height == left ? to[0] : to[1]; });
        return true;
    }

    /// Where points are so near that only their heights tell them apart: each height becomes the nearest
    /// there, or stays as one more.
    bool collapseAcross(Halfedge h) {
        const Vertex kept = mesh().to_vertex_handle(h);
        if ((m_field.point(kept) - m_field.point(mesh().from_vertex_handle(h))).norm() > m_goal.flat)
            return false;
        std::vector<double> levels;
        for (const auto in : mesh().vih_range(kept))
            levels.push_back(m_field.height(in));
        m_field.collapse(h, [&](double height) {
            const double nearest = *std::min_element(levels.begin(), levels.end(), [&](double a, double b) {
                return std::abs(a - height) < std::abs(b - height);
            });
            return std::abs(nearest - height) < m_goal.shortEdge ? nearest : height;
        });
        return true;
    }

    /// An outline may shorten only along itself.
    [[nodiscard]] bool keepsOutline(Halfedge h) const {
        const auto edges = mesh().ve_range(mesh().from_vertex_handle(h));
        return m_field.outline(mesh().edge_handle(h)) ||
               std::none_of(edges.begin(), edges.end(), [&](auto e) { return m_field.outline(e); });
    }

    /// Whether every height at the point that goes has one at the other end that goes on from it.
    [[nodiscard]] bool keepsWalls(Halfedge h) const {
        const Vertex gone = mesh().from_vertex_handle(h);
        const auto [left, right] = heightsFrom(h);
        const auto [leftTo, rightTo] = heightsTo(h);
        if (left == right && leftTo != rightTo)
            return false;
        const auto corners = mesh().vih_range(gone);
        return std::all_of(corners.begin(), corners.end(), [&, left = left, right = right](auto in) {
            return m_field.height(in) == left || m_field.height(in) == right;
        });
    }

    /// Heights left and right of a halfedge at its first and its last point.
    [[nodiscard]] std::array<double, 2> heightsFrom(Halfedge h) const {
        return {m_field.height(mesh().prev_halfedge_handle(h)),
                m_field.height(mesh().opposite_halfedge_handle(h))};
    }
    [[nodiscard]] std::array<double, 2> heightsTo(Halfedge h) const {
        return {m_field.height(h),
                m_field.height(mesh().prev_halfedge_handle(mesh().opposite_halfedge_handle(h)))};
    }

    [[nodiscard]] bool isShort(Halfedge h) const {
        const auto [left, right] = heightsFrom(h);
        const auto [leftTo, rightTo] = heightsTo(h);
        const double run =
            (m_field.point(mesh().to_vertex_handle(h)) - m_field.point(mesh().from_vertex_handle(h))).norm();
        return std::hypot(run, std::max(std::abs(left - leftTo), std::abs(right - rightTo))) <
               m_goal.shortEdge;
    }

    /// Would the surfaces over the point that goes, a new one, stay where they are, and the walls there too?
    [[nodiscard]] bool isFlat(Halfedge h) const {
        const Vertex gone = mesh().from_vertex_handle(h);
        const Vertex kept = mesh().to_vertex_handle(h);
        if (m_field.origin(gone) != Origin::New)
            return false;
        for (const auto out : mesh().voh_range(gone))
            if (out != h && m_field.wall(mesh().edge_handle(out))) {
                const Eigen::Vector2d before = m_field.point(mesh().to_vertex_handle(out));
                const Eigen::Vector2d after = m_field.point(kept);
                const double off = std::abs(doubleArea(before, after, m_field.point(gone)));
                if (!m_field.wall(mesh().edge_handle(h)) || off > m_goal.flat * (after - before).norm())
                    return false;
            }
        const auto [left, right] = heightsFrom(h);
        const auto [leftTo, rightTo] = heightsTo(h);
        for (const double level : {left, right}) {
            if (!staysAt(h, level, level == left ? leftTo : rightTo))
                return false;
        }
        return true;
    }

    /// Whether the surface that has `level` at the point that goes, and will have `to` at the point kept,
    /// still passes there.
    [[nodiscard]] bool staysAt(Halfedge h, double level, double to) const {
        const Vertex gone = mesh().from_vertex_handle(h);
        const Eigen::Vector2d p = m_field.point(gone);
        double nearest = -std::numeric_limits<double>::infinity();
        double error = std::numeric_limits<double>::infinity();
        for (const auto in : mesh().vih_range(gone)) {
            const Face f = mesh().face_handle(in);
            if (m_field.height(in) != level || f == mesh().face_handle(h) ||
                f == mesh().face_handle(mesh().opposite_halfedge_handle(h)))
                continue;
            const Halfedge next = mesh().next_halfedge_handle(in);
            const Halfedge last = mesh().next_halfedge_handle(next);
            const Eigen::Vector2d a = m_field.point(mesh().to_vertex_handle(h));
            const Eigen::Vector2d b = m_field.point(mesh().to_vertex_handle(next));
            const Eigen::Vector2d c = m_field.point(mesh().to_vertex_handle(last));
            const double area = doubleArea(a, b, c);
            const Eigen::Vector3d share =
                Eigen::Vector3d(doubleArea(b, c, p), doubleArea(c, a, p), doubleArea(a, b, p)) / area;
            if (!(area > 0) || share.minCoeff() <= nearest)
                continue;
            nearest = share.minCoeff();
            error = std::abs(share[0] * to + share[1] * m_field.height(next) +
                             share[2] * m_field.height(last) - level);
        }
        return error <= m_goal.flat;
    }

    /// No triangle may turn over, nor become thin that was not.
    [[nodiscard]] bool keepsRound(Halfedge h) const {
        const Vertex gone = mesh().from_vertex_handle(h);
        double before = thin();
        double after = std::numeric_limits<double>::infinity();
        for (const auto in : mesh().vih_range(gone)) {
            const Face f = mesh().face_handle(in);
            before = std::min(before, altitudeOf(f));
            if (f == mesh().face_handle(h) || f == mesh().face_handle(mesh().opposite_halfedge_handle(h)))
                continue;
            const Halfedge next = mesh().next_halfedge_handle(in);
            after = std::min(after, altitude(m_field.point(mesh().to_vertex_handle(h)),
                                             m_field.point(mesh().to_vertex_handle(next)),
                                             m_field.point(mesh().from_vertex_handle(in))));
        }
        return after > 0 && after >= before;
    }

    bool turnLongest(Face f) {
        Halfedge longest = mesh().halfedge_handle(f);
        const auto length = [&](Halfedge h) { return mesh().calc_edge_length(h); };
        for (const auto h : mesh().fh_range(f))
            if (length(h) > length(longest))
                longest = h;
        const Edge e = mesh().edge_handle(longest);
        if (mesh().is_boundary(e) || !mesh().is_flip_ok(e))
            return false;
        const Vertex a = mesh().from_vertex_handle(longest);
        const Vertex b = mesh().to_vertex_handle(longest);
        const Vertex c = mesh().to_vertex_handle(mesh().next_halfedge_handle(longest));
        const Vertex d =
            mesh().to_vertex_handle(mesh().next_halfedge_handle(mesh().opposite_halfedge_handle(longest)));
        if (!touched(a) && !touched(b) && !touched(c) && !touched(d))
            return false;
        const Face other = mesh().face_handle(mesh().opposite_halfedge_handle(longest));
        const double before = std::min(altitudeOf(f), altitudeOf(other));
        const double after = std::min(altitude(m_field.point(c), m_field.point(d), m_field.point(b)),
                                      altitude(m_field.point(d), m_field.point(c), m_field.point(a)));
        if (!(after > kRounder * before))
            return false;
        const bool goesOn = !m_field.wall(e) && std::abs(m_field.planeAt(other, m_field.point(c)) -
                                                         m_field.height(m_field.corner(f, c))) <= m_goal.flat;
        if (!goesOn && !wallMayMove(e, f))
            return false;
        m_field.flip(e, other, !goesOn);
        settle(e, c);
        return true;
    }

    /// A wall may move across a triangle that is thin enough; off the parting line only by next to nothing.
    /// So thin and steep a triangle becomes a wall itself.
    [[nodiscard]] bool wallMayMove(Edge e, Face thinOne) const {
        const Halfedge h = mesh().halfedge_handle(e, 0);
        const bool fixed = m_field.origin(mesh().from_vertex_handle(h)) == Origin::Fixed &&
                           m_field.origin(mesh().to_vertex_handle(h)) == Origin::Fixed;
        return altitudeOf(thinOne) <= (fixed || !m_field.wall(e) ? kNextToNothing : 1) * m_goal.flat;
    }

    /// Heights that the plane of a neighbour gave v in the triangles at a turned edge become those of a
    /// surface already there, where one is near.
    void settle(Edge turned, Vertex v) {
        const Face first = mesh().face_handle(mesh().halfedge_handle(turned, 0));
        const Face second = mesh().face_handle(mesh().halfedge_handle(turned, 1));
        const double given = m_field.height(m_field.corner(first, v));
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto in : mesh().vih_range(v))
            if (const Face f = mesh().face_handle(in);
                f != first && f != second && std::abs(m_field.height(in) - given) < std::abs(nearest - given))
                nearest = m_field.height(in);
        const double level = std::abs(nearest - given) <= m_goal.flat ? nearest : std::max(given, 0.0);
        for (const Face f : {first, second})
            m_field.setHeight(m_field.corner(f, v), level);
    }

    HeightField& m_field;
    TidyGoal m_goal;
};

} // namespace

void tidy(HeightField& field, const TidyGoal& goal) {
    Tidying tidying(field, goal);
    for (int round = 0; round < kRounds; ++round) {
        bool changed = tidying.collapseAll(Origin::New);
        changed = tidying.collapseAll(Origin::Part) || changed;
        changed = tidying.turnThin() || changed;
        if (!changed)
            break;
    }
    field.compact();
}

} // namespace moldwright
