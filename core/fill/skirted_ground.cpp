// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/skirted_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

using Vertex = HeightField::Vertex;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kFan = 0.5;    ///< radians between the lines about a convex corner
constexpr double kHollow = 2.6; ///< radians: corners that are narrower get a line along their middle
constexpr int kSteps = 40;      ///< towards a foot
constexpr double kFarther = 3;  ///< times its own foot: a line that is still under a skirt there has none
constexpr double kOthers = 0.1; ///< of the height: by how much another skirt may lie above a point's own

ProjectedHalf asHalf(const HeightField& field) {
    ProjectedHalf half;
    for (const auto v : field.mesh().vertices())
        half.nodes.push_back(field.point(v));
    for (const auto f : field.mesh().faces()) {
        ShadowFace face;
        face.source = field.seen(f);
        std::size_t k = 0;
        for (const auto h : field.mesh().fh_range(f)) {
            face.node[k] = field.mesh().to_vertex_handle(h).idx();
            face.height[k++] = field.height(h);
        }
        half.faces.push_back(face);
    }
    return half;
}

double angleOf(const Eigen::Vector2d& v) {
    return std::atan2(v.y(), v.x());
}

/// A wall at a point, by its angle.
struct Wall {
    double angle;
    int falls; ///< 1: to its left, −1: to its right, 0: to neither
};

/// The walls at v in order, counter-clockwise.
std::vector<Wall> wallsAt(const HeightField& field, Vertex v) {
    const TriangleMesh& mesh = field.mesh();
    std::vector<Wall> walls;
    for (auto it = mesh.cvoh_ccwbegin(v); it != mesh.cvoh_ccwend(v); ++it) {
        if (!field.wall(mesh.edge_handle(*it)))
            continue;
        const auto back = mesh.opposite_halfedge_handle(*it);
        const double left = field.height(mesh.prev_halfedge_handle(*it)) + field.height(*it);
        const double right = field.height(back) + field.height(mesh.prev_halfedge_handle(back));
        walls.push_back({angleOf(field.point(mesh.to_vertex_handle(*it)) - field.point(v)), left < right ? 1
                                                                                            : right < left
                                                                                                ? -1
                                                                                                : 0});
    }
    return walls;
}

/// The lines from a point of a rim.
class Lines {
public:
    Lines(const SkirtedGround& ground, Vertex v, double nearest)
        : m_ground(ground), m_from(ground.field().point(v)), m_nearest(nearest) {
        for (const auto h : ground.field().mesh().vih_range(v))
            m_top = std::max(m_top, ground.field().height(h));
    }

    /// Goes along a line until no skirt is left above the ground. `own`: only where it is the point's own
    /// skirt that ends there.
    void follow(double angle, bool own) {
        const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
        const double fall = m_ground.cone().fall(along);
        double far = kFirst;
        double farthest = 0;
        for (int step = 0; step < kSteps && (step < 2 || far <= farthest); ++step) {
            const Eigen::Vector2d p = (m_from + far * along).array().round();
            const double ground = m_ground.groundAt(p);
            const double skirt = m_ground.skirts().heightAt(p);
            const double mine = m_top - m_ground.cone().fall(p - m_from);
            if (step == 0) {
                if (!(mine > ground + SkirtedGround::sameHeight))
                    return;
                farthest = kFarther * (m_top - ground) / fall + kFirst;
            } else if (own && skirt > mine + SkirtedGround::sameHeight + kOthers * (m_top - ground))
                return;
            if (skirt <= ground + SkirtedGround::sameHeight) {
                m_feet.emplace_back((m_from + std::max(far, m_nearest) * along).array().round());
                return;
            }
            far = std::max(far, kFirst) + (skirt - ground) / fall + 1;
        }
    }

    /// About a corner between two walls, the ground between them.
    void followCorner(const Wall& wall, const Wall& next) {
        double sector = std::fmod(next.angle - wall.angle + 2 * kTurn, kTurn);
        if (sector == 0)
            sector = kTurn;
        if (sector < kHollow)
            follow(wall.angle + sector / 2, false);
        const double fan = sector - kTurn / 2;
        const int lines = static_cast<int>(std::ceil(fan / kFan));
        for (int k = 1; k < lines; ++k)
            follow(wall.angle + kTurn / 4 + k * fan / lines, true);
    }

    std::vector<Eigen::Vector2d> take() { return std::move(m_feet); }

private:
    static constexpr double kFirst = 2; ///< grid steps: where a line begins

    const SkirtedGround& m_ground;
    Eigen::Vector2d m_from;
    double m_nearest;
    double m_top = 0;
    std::vector<Eigen::Vector2d> m_feet;
};

} // namespace

SkirtedGround::SkirtedGround(const HeightField& field, const DraftCone& cone, const DraftCone& limit)
    : m_field(field), m_cone(cone), m_half(asHalf(field)), m_grid(m_half), m_skirts(field, cone, limit) {}

double SkirtedGround::groundAt(const Eigen::Vector2d& p) const {
    const int top = m_grid.topAt(p);
    return top < 0 ? 0 : std::max(heightAt(m_half, m_half.faces[static_cast<std::size_t>(top)], p), 0.0);
}

double SkirtedGround::leanedAt(const Eigen::Vector2d& p, double ground) const {
    const double skirt = m_skirts.heightAt(p);
    return skirt > ground + sameHeight ? skirt : ground;
}

int SkirtedGround::seenAt(const Eigen::Vector2d& p, double height) const {
    const int top = m_grid.topAt(p);
    if (top < 0)
        return -1;
    const ShadowFace& face = m_half.faces[static_cast<std::size_t>(top)];
    return std::abs(heightAt(m_half, face, p) - height) <= sameHeight ? face.source : -1;
}

std::vector<Eigen::Vector2d> feetOf(const SkirtedGround& ground, Vertex v, double nearest) {
    const HeightField& field = ground.field();
    Lines lines(ground, v, nearest);
    for (const auto f : field.mesh().vf_range(v))
        if (tooSteep(field, f, ground.cone()))
            lines.follow(angleOf(-gradientOf(field, f)), false);
    const std::vector<Wall> walls = wallsAt(field, v);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const Wall& wall = walls[i];
        const Wall& next = walls[(i + 1) % walls.size()];
        if (wall.falls != 0)
            lines.follow(wall.angle + wall.falls * kTurn / 4, false);
        if (wall.falls == 1 && next.falls == -1)
            lines.followCorner(wall, next);
    }
    return lines.take();
}

} // namespace moldwright
