// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/leaned_field.h"

#include "base/parallel.h"
#include "fill/cgal/planar_triangulation.h"
#include "fill/skirted_ground.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace moldwright {

namespace {

using Vertex = HeightField::Vertex;
using Edge = HeightField::Edge;
using Face = HeightField::Face;
using Origin = HeightField::Origin;

constexpr int kRefinements = 4;
constexpr int kHalvings = 30;     ///< towards where an edge leaves a skirt
constexpr double kNearEnd = 0.1;  ///< of an edge
constexpr double kHanging = 0.15; ///< of its fall: how far above a skirt the middle of an edge may lie
constexpr double kApart = 1.1;    ///< of what counts as near: a foot is so far from its rim at least
constexpr double kMargin = 1.25;  ///< the frame about everything, in reaches
constexpr std::size_t kGrain = 64;

/// Points told apart by place, and found by nearness.
class NearPoints {
public:
    explicit NearPoints(double near) : m_near(near) {}

    /// The number of p, a new one if there is no point exactly there.
    int numberOf(const Eigen::Vector2d& p) {
        const auto [place, fresh] =
            m_numbers.emplace(std::pair{p.x(), p.y()}, static_cast<int>(m_points.size()));
        if (fresh) {
            m_cells.emplace(cellOf(p), place->second);
            m_points.push_back(p);
        }
        return place->second;
    }

    [[nodiscard]] bool anyNear(const Eigen::Vector2d& p) const {
        const auto [x, y] = cellOf(p);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j) {
                const auto [from, to] = m_cells.equal_range({i, j});
                if (std::any_of(from, to, [&](const auto& known) {
                        return (m_points[static_cast<std::size_t>(known.second)] - p).norm() < m_near;
                    }))
                    return true;
            }
        return false;
    }

    [[nodiscard]] const std::vector<Eigen::Vector2d>& points() const { return m_points; }

private:
    using Cell = std::pair<std::int64_t, std::int64_t>;

    [[nodiscard]] Cell cellOf(const Eigen::Vector2d& p) const {
        return {static_cast<std::int64_t>(std::floor(p.x() / m_near)),
                static_cast<std::int64_t>(std::floor(p.y() / m_near))};
    }

    double m_near;
    std::map<std::pair<double, double>, int> m_numbers;
    std::multimap<Cell, int> m_cells;
    std::vector<Eigen::Vector2d> m_points;
};

/// The points and lines of the leaned half as they are collected, and their triangulation.
class Leaning {
public:
    Leaning(const HeightField& field, const DraftCone& aim, const DraftCone& limit, double near)
        : m_field(field), m_ground(field, aim, limit), m_limit(limit), m_near(near), m_points(near) {}

    HeightField make() {
        takeFrame();
        takePoints();
        for (const auto e : mesh().edges())
            if (m_field.solid(mesh().face_handle(mesh().halfedge_handle(e, 0))) ||
                m_field.solid(mesh().face_handle(mesh().halfedge_handle(e, 1))))
                takeEdge(e);
        takeFeet();
        triangulate();
        for (int round = 0; round < kRefinements && refine(); ++round)
            triangulate();
        return result();
    }

private:
    /// A point to be put on the edge of a triangle from its corner k to the next.
    struct Split {
        std::size_t k = 0;
        Eigen::Vector2d place;
    };

    /// A place with its height.
    struct Tip {
        Eigen::Vector2d place;
        double height = 0;
    };

    [[nodiscard]] const TriangleMesh& mesh() const { return m_field.mesh(); }

    int add(const Eigen::Vector2d& p, double height, Origin origin) {
        const int number = m_points.numberOf(p);
        if (static_cast<std::size_t>(number) == m_heights.size()) {
            m_heights.push_back(height);
            m_origins.push_back(origin);
        }
        return number;
    }

    int addNew(const Eigen::Vector2d& p) { return add(p, m_ground.leanedAt(p), Origin::New); }

    void takeFrame();
    void takePoints();
    void takeEdge(Edge e);
    void takeFeet();
    void triangulate();
    bool refine();
    [[nodiscard]] std::array<std::optional<Eigen::Vector2d>, 4> missingFeet(std::size_t t) const;
    [[nodiscard]] std::optional<Eigen::Vector2d> missingFoot(const Tip& a, const Tip& b) const;
    [[nodiscard]] std::optional<Split> belowSkirt(std::size_t t) const;
    void split(std::size_t t, const Split& split);
    [[nodiscard]] HeightField result() const;
    void nameFaces(HeightField& field) const;

    const HeightField& m_field;
    SkirtedGround m_ground;
    DraftCone m_limit;
    double m_near;
    std::vector<double> m_top; ///< per point of the field: its highest height
    std::vector<int> m_number; ///< per point of the field: its number, −1 where it lies under a skirt
    NearPoints m_points;
    std::vector<double> m_heights;
    std::vector<Origin> m_origins;
    std::vector<std::array<int, 2>> m_segments;
    PlanarTriangulation m_plane;
    std::vector<double> m_all; ///< heights of its points
};

void Leaning::takeFrame() {
    double highest = 0;
    for (const auto h : mesh().halfedges())
        highest = std::max(highest, m_field.height(h));
    const double far = std::round(kMargin * (ShadowGrid::reach + 2 * m_limit.reach(highest)));
    for (const auto& [x, y] : {std::pair{-far, -far}, {far, -far}, {far, far}, {-far, far}})
        add({x, y}, 0, Origin::Fixed);
}

void Leaning::takePoints() {
    const std::size_t count = mesh().n_vertices();
    m_top.assign(count, 0);
    std::vector<char> stays(count, 0);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vertex v(static_cast<int>(i));
            if (mesh().is_boundary(v))
                continue;
            for (const auto h : mesh().vih_range(v))
                m_top[i] = std::max(m_top[i], m_field.height(h));
            stays[i] = m_ground.coveredAt(m_field.point(v), m_top[i]) ? 0 : 1;
        }
    });
    m_number.assign(count, -1);
    for (std::size_t i = 0; i < count; ++i)
        if (const Vertex v(static_cast<int>(i)); stays[i])
            m_number[i] = add(m_field.point(v), m_top[i], m_field.origin(v));
}

/// An edge that stays in sight stays; one that comes out from under a skirt begins there.
void Leaning::takeEdge(Edge e) {
    const auto left = mesh().halfedge_handle(e, 0);
    const auto right = mesh().halfedge_handle(e, 1);
    std::array<Vertex, 2> end = {mesh().from_vertex_handle(left), mesh().to_vertex_handle(left)};
    std::array<double, 2> height = {
        std::max(m_field.height(right), m_field.height(mesh().prev_halfedge_handle(left))),
        std::max(m_field.height(left), m_field.height(mesh().prev_halfedge_handle(right)))};
    const auto number = [&](std::size_t k) { return m_number[static_cast<std::size_t>(end[k].idx())]; };
    const auto inSight = [&](std::size_t k) {
        return number(k) >= 0 &&
               m_top[static_cast<std::size_t>(end[k].idx())] <= height[k] + SkirtedGround::sameHeight;
    };
    if (inSight(0) && inSight(1))
        m_segments.push_back({number(0), number(1)});
    if (inSight(0) == inSight(1))
        return;
    if (!inSight(0)) {
        std::swap(end[0], end[1]);
        std::swap(height[0], height[1]);
    }
    const Eigen::Vector2d from = m_field.point(end[0]);
    const Eigen::Vector2d along = m_field.point(end[1]) - from;
    double seen = 0;
    double hidden = 1;
    const auto heightThere = [&](double t) { return height[0] + t * (height[1] - height[0]); };
    for (int i = 0; i < kHalvings && (hidden - seen) * along.norm() > 1; ++i) {
        const double t = (seen + hidden) / 2;
        (m_ground.coveredAt(from + t * along, heightThere(t)) ? hidden : seen) = t;
    }
    const Eigen::Vector2d p = (from + seen * along).array().round();
    if (seen >= kNearEnd && !m_points.anyNear(p))
        m_segments.push_back({number(0), add(p, heightThere(seen), Origin::New)});
}

void Leaning::takeFeet() {
    const std::size_t count = mesh().n_vertices();
    std::vector<std::vector<Eigen::Vector2d>> feet(count);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (m_number[i] >= 0 && m_ground.skirts().starts()[i])
                feet[i] = feetOf(m_ground, Vertex(static_cast<int>(i)), kApart * m_near);
    });
    for (const auto& found : feet)
        for (const Eigen::Vector2d& p : found)
            if (!m_points.anyNear(p))
                addNew(p);
}

void Leaning::triangulate() {
    m_plane = triangulatePlane(m_points.points(), m_segments);
    m_all = m_heights;
    for (std::size_t i = m_heights.size(); i < m_plane.points.size(); ++i)
        m_all.push_back(m_ground.leanedAt(m_plane.points[i]));
}

/// Puts points where the triangulation hangs over the skirts or passes below them. Returns whether any.
bool Leaning::refine() {
    const std::size_t count = m_plane.triangles.size();
    std::vector<std::array<std::optional<Eigen::Vector2d>, 4>> feet(count);
    std::vector<std::optional<Split>> splits(count);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            splits[t] = belowSkirt(t);
            feet[t] = missingFeet(t);
        }
    });
    const std::size_t before = m_heights.size();
    for (const auto& found : feet)
        for (const auto& p : found)
            if (p && !m_points.anyNear(*p))
                addNew(*p);
    for (std::size_t t = 0; t < count; ++t)
        if (splits[t] && !m_points.anyNear(splits[t]->place))
            split(t, *splits[t]);
    return m_heights.size() > before;
}

/// On the edges of a triangle, and on the line from its highest corner to the middle of the other two.
std::array<std::optional<Eigen::Vector2d>, 4> Leaning::missingFeet(std::size_t t) const {
    std::array<Tip, 3> tips;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(m_plane.triangles[t][k]);
        tips[k] = {m_plane.points[i], m_all[i]};
    }
    std::array<std::optional<Eigen::Vector2d>, 4> feet;
    for (std::size_t k = 0; k < 3; ++k)
        if (m_plane.neighbours[t][k] > static_cast<int>(t) && m_plane.onSegment[t][k] == 0)
            feet[k] = missingFoot(tips[k], tips[(k + 1) % 3]);
    std::sort(tips.begin(), tips.end(), [](const Tip& a, const Tip& b) { return a.height > b.height; });
    feet[3] =
        missingFoot(tips[0], {(tips[1].place + tips[2].place) / 2, (tips[1].height + tips[2].height) / 2});
    return feet;
}

/// Where a line hangs over what it should follow the foot of its skirt is missing.
std::optional<Eigen::Vector2d> Leaning::missingFoot(const Tip& a, const Tip& b) const {
    if (a.height < b.height)
        return missingFoot(b, a);
    const Eigen::Vector2d along = b.place - a.place;
    const double length = along.norm();
    const double drop = a.height - b.height;
    if (drop <= SkirtedGround::sameHeight || length < 2 * m_near ||
        a.height - drop / 2 <=
            m_ground.leanedAt(a.place + along / 2) + SkirtedGround::sameHeight + kHanging * drop)
        return std::nullopt;
    double covered = 0;
    double free = 1;
    for (int i = 0; i < kHalvings && (free - covered) * length > 1; ++i) {
        const double t = (covered + free) / 2;
        const Eigen::Vector2d p = a.place + t * along;
        (m_ground.coveredAt(p, m_ground.groundAt(p)) ? covered : free) = t;
    }
    return (a.place + std::max(free * length, kApart * m_near) / length * along).array().round();
}

/// A triangle is too steep where a skirt from its highest point passes over its lower edge unseen.
std::optional<Leaning::Split> Leaning::belowSkirt(std::size_t t) const {
    std::array<Eigen::Vector2d, 3> x;
    std::array<double, 3> z{};
    for (std::size_t k = 0; k < 3; ++k) {
        x[k] = m_plane.points[static_cast<std::size_t>(m_plane.triangles[t][k])];
        z[k] = m_all[static_cast<std::size_t>(m_plane.triangles[t][k])];
    }
    if (m_limit.steepness(gradientOf(x[0], x[1], x[2], {z[0], z[1], z[2]})) <= 1)
        return std::nullopt;
    const auto top = static_cast<std::size_t>(std::max_element(z.begin(), z.end()) - z.begin());
    const std::size_t a = (top + 1) % 3;
    const std::size_t b = (top + 2) % 3;
    const double along = (x[top] - x[a]).dot(x[b] - x[a]) / (x[b] - x[a]).squaredNorm();
    if (!(along > 0 && along < 1))
        return std::nullopt;
    const Eigen::Vector2d p = (x[a] + along * (x[b] - x[a])).array().round();
    if (m_ground.leanedAt(p) <= z[a] + along * (z[b] - z[a]) + SkirtedGround::sameHeight)
        return std::nullopt;
    return Split{a, p};
}

void Leaning::split(std::size_t t, const Split& split) {
    const int fresh = addNew(split.place);
    const int a = m_plane.triangles[t][split.k];
    const int b = m_plane.triangles[t][(split.k + 1) % 3];
    if (m_plane.onSegment[t][split.k] == 0)
        return;
    const auto segment = std::find_if(m_segments.begin(), m_segments.end(), [&](const auto& ends) {
        return std::minmax(ends[0], ends[1]) == std::minmax(a, b);
    });
    if (segment == m_segments.end())
        return;
    *segment = {a, fresh};
    m_segments.push_back({fresh, b});
}

HeightField Leaning::result() const {
    HeightField field(m_plane.points, m_plane.triangles);
    for (const auto v : field.mesh().vertices()) {
        const auto i = static_cast<std::size_t>(v.idx());
        field.setOrigin(v, i < m_origins.size() ? m_origins[i] : Origin::New);
        for (const auto h : field.mesh().vih_range(v))
            if (!field.mesh().is_boundary(h))
                field.setHeight(h, m_all[i]);
    }
    nameFaces(field);
    return field;
}

/// A triangle shows the face of the part that was seen there, if it lies on it.
void Leaning::nameFaces(HeightField& field) const {
    const std::size_t count = field.mesh().n_faces();
    std::vector<int> seen(count, -1);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Face f(static_cast<int>(i));
            if (!field.solid(f))
                continue;
            Eigen::Vector2d middle(0, 0);
            double height = 0;
            for (const auto h : field.mesh().fh_range(f)) {
                middle += field.point(field.mesh().to_vertex_handle(h)) / 3;
                height += field.height(h) / 3;
            }
            seen[i] = m_ground.seenAt(middle, height);
        }
    });
    for (std::size_t i = 0; i < count; ++i)
        field.setSeen(Face(static_cast<int>(i)), seen[i]);
}

} // namespace

HeightField leanWalls(const HeightField& field, const DraftCone& aim, const DraftCone& limit, double near) {
    return Leaning(field, aim, limit, near).make();
}

} // namespace moldwright
