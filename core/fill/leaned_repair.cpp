// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/leaned_repair.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

using Vertex = HeightField::Vertex;
using Edge = HeightField::Edge;
using Halfedge = HeightField::Halfedge;
using Face = HeightField::Face;

constexpr int kRounds = 20;
constexpr double kApron = 4;   ///< reaches of what a point is lifted by: how far off the ground stays
constexpr double kLift = 0.05; ///< of the shortest edge: how far a touching top is lifted

class LeanedRepair {
public:
    LeanedRepair(HeightField& field, const DraftCone& cone, double near)
        : m_field(field), m_cone(cone), m_near(near) {}

    void digMoat() {
        std::vector<Edge> edges;
        for (const auto e : mesh().edges())
            if (!mesh().is_boundary(e) && (atFrame(from(e)) || atFrame(to(e))) && highest(e) > 0)
                edges.push_back(e);
        for (const Edge e : edges) {
            const auto [inner, outer] =
                atFrame(from(e)) ? std::pair{to(e), from(e)} : std::pair{from(e), to(e)};
            const double distance = std::max(m_cone.reach(highest(e)), m_near);
            setHeight(m_field.split(e, towards(inner, outer, distance)), 0);
        }
    }

    /// Returns whether anything touched.
    bool lift() {
        std::vector<Edge> touching;
        for (const auto e : mesh().edges())
            if (!mesh().is_boundary(e) && highest(e) == 0 && withinSolid(e))
                touching.push_back(e);
        for (const Edge e : touching)
            m_field.split(e, (m_field.point(from(e)) + m_field.point(to(e))) / 2);
        bool any = !touching.empty();
        const std::size_t count = mesh().n_vertices();
        for (std::size_t i = 0; i < count; ++i)
            if (const Vertex v(static_cast<int>(i)); !atFrame(v) && touches(v)) {
                const double height = liftOf(v);
                keepGround(v, std::max(kApron * m_cone.reach(height), m_near));
                setHeight(v, height);
                any = true;
            }
        return any;
    }

private:
    [[nodiscard]] const TriangleMesh& mesh() const { return m_field.mesh(); }
    [[nodiscard]] Vertex from(Edge e) const {
        return mesh().from_vertex_handle(mesh().halfedge_handle(e, 0));
    }
    [[nodiscard]] Vertex to(Edge e) const { return mesh().to_vertex_handle(mesh().halfedge_handle(e, 0)); }
    [[nodiscard]] bool atFrame(Vertex v) const { return mesh().is_boundary(v); }
    [[nodiscard]] double height(Vertex v) const {
        return atFrame(v) ? 0 : m_field.height(*mesh().cvih_begin(v));
    }
    [[nodiscard]] double highest(Edge e) const { return std::max(height(from(e)), height(to(e))); }

    void setHeight(Vertex v, double height) {
        for (const auto h : mesh().vih_range(v)) {
            m_field.setHeight(h, height);
            m_field.setSeen(mesh().face_handle(h), -1);
        }
    }

    [[nodiscard]] Eigen::Vector2d towards(Vertex start, Vertex end, double distance) const {
        const Eigen::Vector2d p = m_field.point(start);
        return p + distance * (m_field.point(end) - p).normalized();
    }

    [[nodiscard]] bool withinSolid(Edge e) const {
        return m_field.solid(mesh().face_handle(mesh().halfedge_handle(e, 0))) &&
               m_field.solid(mesh().face_handle(mesh().halfedge_handle(e, 1)));
    }

    /// A point in the plane within the solid, or one where its outline meets itself.
    [[nodiscard]] bool touches(Vertex v) const {
        if (height(v) != 0)
            return false;
        const std::vector<Face> fan = m_field.fan(v);
        int changes = 0;
        for (std::size_t i = 0; i < fan.size(); ++i)
            changes += m_field.solid(fan[i]) != m_field.solid(fan[(i + 1) % fan.size()]);
        return changes > 2 || (changes == 0 && m_field.solid(fan.front()));
    }

    [[nodiscard]] double liftOf(Vertex v) const {
        double shortest = std::numeric_limits<double>::infinity();
        for (const auto h : mesh().voh_range(v))
            shortest = std::min(shortest, mesh().calc_edge_length(h));
        return kLift * shortest;
    }

    /// Puts points on v's long edges that lie in the plane, so that what is beyond them stays there.
    void keepGround(Vertex v, double distance) {
        std::vector<Edge> edges;
        for (const auto h : mesh().voh_range(v))
            if (mesh().calc_edge_length(h) > 2 * distance && !withinSolid(mesh().edge_handle(h)))
                edges.push_back(mesh().edge_handle(h));
        for (const Edge e : edges) {
            const Eigen::Vector2d p = towards(v, from(e) == v ? to(e) : from(e), distance);
            if (!mesh().is_boundary(e) && m_field.splitKeepsOrder(e, p))
                m_field.split(e, p);
        }
    }

    HeightField& m_field;
    DraftCone m_cone;
    double m_near;
};

} // namespace

void repairLeaned(HeightField& field, const DraftCone& cone, double near) {
    LeanedRepair repair(field, cone, near);
    repair.digMoat();
    for (int round = 0; round < kRounds && repair.lift(); ++round) {
    }
}

} // namespace moldwright
