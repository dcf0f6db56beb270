// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/bolt_holes.h"

#include "features/drafted_prism.h"

#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

using Eigen::Vector2d;

/// Of the corners of a polygon round a circle of the bolt's diameter.
double cornerRadius(const BoltSettings& bolts) {
    return bolts.diameter / 2 / std::cos(std::numbers::pi / circleCorners);
}

/// Walls of the outline between two heights, looking outwards.
IndexedMesh tube(const PlanShape& outline, double low, double high) {
    const auto n = static_cast<int>(outline.size());
    IndexedMesh mesh{Points(2 * n, 3), Triangles(2 * n, 3)};
    for (int k = 0; k < n; ++k) {
        const Vector2d& p = outline[static_cast<std::size_t>(k)];
        mesh.V.row(k) << p.x(), p.y(), low;
        mesh.V.row(n + k) << p.x(), p.y(), high;
        const int next = (k + 1) % n;
        mesh.F.row(2 * k) << k, next, n + next;
        mesh.F.row(2 * k + 1) << k, n + next, n + k;
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
    return end > 0 ? tube(outline, 0, end) : tube(outline, end, 0);
}

IndexedMesh boltSolid(const PlanShape& outline, const Block& block) {
    const auto n = static_cast<int>(outline.size());
    IndexedMesh mesh = tube(outline, block.end(2), block.end(1));
    mesh.F.conservativeResize(2 * n + 2 * (n - 2), 3);
    for (int k = 0; k < n - 2; ++k) { // convex: fans close it
        mesh.F.row(2 * n + 2 * k) << 0, k + 2, k + 1;
        mesh.F.row(2 * n + 2 * k + 1) << n, n + k + 1, n + k + 2;
    }
    return mesh;
}

} // namespace moldwright
