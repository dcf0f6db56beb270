// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/bolt_holes.h"

#include "features/drafted_prism.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

using Eigen::Vector2d;

/// Of the corners of a polygon round a circle of the bolt's diameter.
double cornerRadius(const BoltSettings& bolts) {
    return bolts.diameter / 2 / std::cos(std::numbers::pi / circleCorners);
}

/// Walls of the outline between heights, ascending, looking outwards.
IndexedMesh tube(const PlanShape& outline, const std::vector<double>& heights) {
    const auto n = static_cast<int>(outline.size());
    const auto rings = static_cast<int>(heights.size());
    IndexedMesh mesh{Points(rings * n, 3), Triangles(2 * (rings - 1) * n, 3)};
    for (int ring = 0; ring < rings; ++ring)
        for (int k = 0; k < n; ++k) {
            const Vector2d& p = outline[static_cast<std::size_t>(k)];
            const int here = ring * n + k;
            mesh.V.row(here) << p.x(), p.y(), heights[static_cast<std::size_t>(ring)];
            if (ring + 1 == rings)
                continue;
            const int next = ring * n + (k + 1) % n;
            mesh.F.row(2 * here) << here, next, n + next;
            mesh.F.row(2 * here + 1) << here, n + next, n + here;
        }
    return mesh;
}

} // namespace

std::vector<Vector2d> boltPlaces(const BoltSettings& bolts, const Block& block, const Obstacles& obstacles,
                                 const Wishes& wishes, Pull pull) {
    std::vector<Vector2d> places;
    Obstacles taken = obstacles;
    const std::vector<Vector2d> round = placesRound(block, static_cast<int>(wishes.size()));
    for (std::size_t i = 0; i < round.size(); ++i) {
        const std::optional<Vector2d> place = wishes[i] ? wishes[i]
                                                        : nearestFree(round[i], cornerRadius(bolts), block,
                                                                      taken, {bolts.wall, bolts.clear}, pull);
        if (!place)
            break;
        places.push_back(*place);
        taken.push_back(boltRoom(bolts, *place));
    }
    return places;
}

PlanShape boltRoom(const BoltSettings& bolts, const Vector2d& place, double about) {
    return planCircle(place, cornerRadius(bolts) + about, circleCorners);
}

PlanShape boltOutline(const BoltSettings& bolts, const Vector2d& place, double grid) {
    PlanShape outline = boltRoom(bolts, place);
    for (Vector2d& p : outline)
        p = {onGrid(p.x(), grid), onGrid(p.y(), grid)};
    return outline;
}

IndexedMesh boltSurface(const PlanShape& outline, double end) {
    return tube(outline, {std::min(0.0, end), std::max(0.0, end)});
}

IndexedMesh boltSolid(const PlanShape& outline, const Block& block) {
    const auto n = static_cast<int>(outline.size());
    // With points in the plane, where all else is widest: steel is measured from points.
    IndexedMesh mesh = tube(outline, {block.end(2), 0, block.end(1)});
    mesh.F.conservativeResize(4 * n + 2 * (n - 2), 3);
    for (int k = 0; k < n - 2; ++k) { // convex: fans close it
        mesh.F.row(4 * n + 2 * k) << 0, k + 2, k + 1;
        mesh.F.row(4 * n + 2 * k + 1) << 2 * n, 2 * n + k + 1, 2 * n + k + 2;
    }
    return mesh;
}

} // namespace moldwright
