// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/field_repair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace moldwright {

namespace {

constexpr int kRounds = 30;
constexpr double kLow = 0.1;   ///< of the greatest height about: how far a touching top is lifted
constexpr double kReach = 0.3; ///< of the shortest edge: how far a closed gap reaches

using Vertex = HeightField::Vertex;
using Edge = HeightField::Edge;
using Face = HeightField::Face;

bool uncrossWalls(HeightField& field) {
    bool changed = false;
    const TriangleMesh& mesh = field.mesh();
    for (const auto e : mesh.edges()) {
        if (mesh.is_boundary(e))
            continue;
        const auto left = mesh.halfedge_handle(e, 0);
        const auto right = mesh.halfedge_handle(e, 1);
        const auto leftBack = mesh.prev_halfedge_handle(left);
        const auto rightBack = mesh.prev_halfedge_handle(right);
        const double atTo = field.height(left) - field.height(rightBack);
        const double atFrom = field.height(leftBack) - field.height(right);
        if (!(std::min(atTo, atFrom) < 0 && std::max(atTo, atFrom) > 0))
            continue;
        const auto [a, b] =
            std::abs(atTo) < std::abs(atFrom) ? std::pair{left, rightBack} : std::pair{leftBack, right};
        const double level = std::max(field.height(a), field.height(b));
        field.setHeight(a, level);
        field.setHeight(b, level);
        changed = true;
    }
    return changed;
}

/// A height above the plane, small beside what is about the triangles.
double lowLevel(const HeightField& field, const std::vector<Face>& faces) {
    double highest = 0;
    for (const Face f : faces)
        for (const auto h : field.mesh().fh_range(f))
            highest = std::max(highest, field.height(h));
    return kLow * highest;
}

bool liftTouchingEdges(HeightField& field) {
    std::vector<Edge> touching;
    const TriangleMesh& mesh = field.mesh();
    for (const auto e : mesh.edges()) {
        if (mesh.is_boundary(e))
            continue;
        const auto left = mesh.halfedge_handle(e, 0);
        const auto right = mesh.halfedge_handle(e, 1);
        if (field.solid(mesh.face_handle(left)) && field.solid(mesh.face_handle(right)) &&
            field.height(left) == 0 && field.height(right) == 0 &&
            field.height(mesh.prev_halfedge_handle(left)) == 0 &&
            field.height(mesh.prev_halfedge_handle(right)) == 0)
            touching.push_back(e);
    }
    for (const Edge e : touching) {
        const auto h = mesh.halfedge_handle(e, 0);
        field.split(e, (field.point(mesh.from_vertex_handle(h)) + field.point(mesh.to_vertex_handle(h))) / 2);
    }
    return !touching.empty();
}

bool liftTouchingPoints(HeightField& field) {
    bool changed = false;
    for (const auto v : field.mesh().vertices()) {
        const std::vector<Face> fan = field.fan(v);
        const bool within = std::all_of(fan.begin(), fan.end(), [&](Face f) { return field.solid(f); });
        if (!within)
            continue;
        for (const Face f : fan)
            if (field.height(field.corner(f, v)) == 0) {
                field.setHeight(field.corner(f, v), lowLevel(field, fan));
                changed = true;
            }
    }
    return changed;
}

/// Neighbouring triangles of a fan, counter-clockwise.
struct Gap {
    std::size_t first = 0;
    std::size_t count = 0;
};

double angleOf(const HeightField& field, Vertex v, Face f) {
    const auto in = field.corner(f, v);
    const Eigen::Vector2d a =
        field.point(field.mesh().to_vertex_handle(field.mesh().next_halfedge_handle(in))) - field.point(v);
    const Eigen::Vector2d b = field.point(field.mesh().from_vertex_handle(in)) - field.point(v);
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

/// The narrowest of several runs of triangles that are not `high`; none if there is one run at most.
std::optional<Gap> narrowestGap(const HeightField& field, Vertex v, const std::vector<Face>& fan,
                                const std::vector<char>& high) {
    std::vector<Gap> gaps;
    const std::size_t n = fan.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (high[i] || !high[(i + n - 1) % n])
            continue;
        Gap gap{i, 0};
        while (!high[(i + gap.count) % n])
            ++gap.count;
        gaps.push_back(gap);
    }
    if (gaps.size() < 2)
        return std::nullopt;
    const auto width = [&](const Gap& gap) {
        double sum = 0;
        for (std::size_t i = 0; i < gap.count; ++i)
            sum += angleOf(field, v, fan[(gap.first + i) % n]);
        return sum;
    };
    return *std::min_element(gaps.begin(), gaps.end(),
                             [&](const Gap& a, const Gap& b) { return width(a) < width(b); });
}

/// Raises a gap's triangles near v, as the walls beside it stand, to `level` at least at v.
void closeGap(HeightField& field, Vertex v, const std::vector<Face>& fan, const Gap& gap, double level) {
    const TriangleMesh& mesh = field.mesh();
    std::vector<Vertex> spokes;
    spokes.reserve(gap.count + 1);
    for (std::size_t i = 0; i < gap.count; ++i)
        spokes.push_back(mesh.to_vertex_handle(
            mesh.next_halfedge_handle(field.corner(fan[(gap.first + i) % fan.size()], v))));
    spokes.push_back(mesh.from_vertex_handle(field.corner(fan[(gap.first + gap.count - 1) % fan.size()], v)));
    double reach = std::numeric_limits<double>::infinity();
    for (const Vertex x : spokes)
        reach = std::min(reach, kReach * (field.point(x) - field.point(v)).norm());

    std::vector<Vertex> ends;
    ends.reserve(spokes.size());
    for (const Vertex x : spokes)
        ends.push_back(field.split(mesh.edge_handle(mesh.find_halfedge(v, x)),
                                   field.point(v) + reach * (field.point(x) - field.point(v)).normalized()));
    const auto raise = [&](Face f, Vertex w, double to) {
        const auto h = field.corner(f, w);
        field.setHeight(h, std::max(field.height(h), to));
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const auto out = mesh.find_halfedge(v, ends[i]);
        const Face f = mesh.face_handle(out);
        raise(f, v, level);
        const auto across = mesh.find_halfedge(ends[i + 1], v);
        const Face before = mesh.face_handle(mesh.opposite_halfedge_handle(out));
        const Face after = mesh.face_handle(mesh.opposite_halfedge_handle(across));
        raise(f, ends[i], i == 0 ? field.height(field.corner(before, ends[i])) : level);
        raise(f, ends[i + 1], i + 2 == ends.size() ? field.height(field.corner(after, ends[i + 1])) : level);
    }
}

/// Closes one gap at v if walls or the outline meet there more than once.
bool closeGapAt(HeightField& field, Vertex v) {
    const std::vector<Face> fan = field.fan(v);
    std::vector<double> heights;
    heights.reserve(fan.size());
    for (const Face f : fan)
        heights.push_back(field.height(field.corner(f, v)));
    std::vector<double> levels = heights;
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    std::vector<char> high(fan.size());
    for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
        std::transform(heights.begin(), heights.end(), high.begin(),
                       [&](double h) { return h > levels[k] ? 1 : 0; });
        if (const auto gap = narrowestGap(field, v, fan, high)) {
            const double before = heights[(gap->first + fan.size() - 1) % fan.size()];
            const double after = heights[(gap->first + gap->count) % fan.size()];
            closeGap(field, v, fan, *gap, std::min(before, after));
            return true;
        }
    }
    std::transform(fan.begin(), fan.end(), high.begin(), [&](Face f) { return field.solid(f) ? 1 : 0; });
    if (const auto gap = narrowestGap(field, v, fan, high)) {
        closeGap(field, v, fan, *gap, lowLevel(field, fan));
        return true;
    }
    return false;
}

bool closeGaps(HeightField& field) {
    bool changed = false;
    const std::size_t count = field.mesh().n_vertices();
    for (std::size_t v = 0; v < count; ++v)
        if (const Vertex vertex(static_cast<int>(v)); !field.mesh().is_boundary(vertex))
            changed = closeGapAt(field, vertex) || changed;
    return changed;
}

} // namespace

void makeManifold(HeightField& field) {
    for (int round = 0; round < kRounds; ++round) {
        bool changed = uncrossWalls(field);
        changed = liftTouchingEdges(field) || changed;
        changed = liftTouchingPoints(field) || changed;
        changed = closeGaps(field) || changed;
        if (!changed)
            return;
    }
}

} // namespace moldwright
