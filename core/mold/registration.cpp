// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/registration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace moldwright {

namespace {

using Eigen::Vector2d;

constexpr double searchStep = 1; // mm

double diameterOf(const KeySettings& keys, bool odd) {
    return keys.diameter + (odd ? keys.oddBy : 0);
}

/// What the keys' common axis moves aside over their height, mm.
double shiftOf(const KeySettings& keys, const Directions& directions) {
    const Eigen::Vector3d axis = directions.d1 - directions.d2;
    return (keys.height + keys.clearance) * axis.head<2>().norm() / axis.z();
}

/// Radius of the room that a socket takes, seen along the normal. Walls lean: measured along the plane the
/// clearance is a little more than across the wall.
double socketRadius(const KeySettings& keys, bool odd, double shift) {
    return diameterOf(keys, odd) / 2 + 1.5 * keys.clearance + shift;
}

/// Its axis halves the angle ψ between d1 and −d2; walls that lean ψ/2 more than the draft against the axis
/// have the draft against both.
Result<DraftedPrism> frustum(const Vector2d& place, double radius, double height,
                             const Directions& directions, double draft, double grid) {
    const Eigen::Vector3d axis = (directions.d1 - directions.d2).normalized();
    const double halfAngle = degrees(std::acos(std::clamp(axis.dot(directions.d1), -1.0, 1.0)));
    PrismRequest request;
    request.base = planCircle(place, radius, circleCorners);
    request.height = {height, 0};
    request.directions[0] = {axis};
    request.draftDegrees = draft + halfAngle;
    request.grid = grid;
    request.closed = {
        MW_TEXT("Mold", "A key {0} mm wide whose walls lean {1}° comes to a point before it is {2} mm high. "
                        "Make it wider, lower, or its draft smaller."),
        {readable(2 * radius), readable(request.draftDegrees), readable(height)}};
    return draftedPrism(request);
}

/// The place that is farthest from all that stand; of equals, and where nothing stands, the first.
std::vector<Vector2d>::iterator farthestFrom(std::vector<Vector2d>& places,
                                             const std::vector<Vector2d>& standing) {
    constexpr double clearly = 1e-6; // mm
    auto best = places.begin();
    double most = 0;
    for (auto place = places.begin(); place != places.end(); ++place) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vector2d& other : standing)
            nearest = std::min(nearest, (*place - other).norm());
        if (nearest > most + clearly) {
            most = nearest;
            best = place;
        }
    }
    return best;
}

} // namespace

std::vector<Vector2d> keyPlaces(const KeySettings& keys, const Directions& directions, const Block& block,
                                const Obstacles& obstacles, double steel, const Wishes& wishes, Pull pull) {
    const double shift = shiftOf(keys, directions);
    std::vector<Vector2d> places;
    Obstacles taken = obstacles;
    std::vector<Vector2d> standing; // by hand, or found
    for (const std::optional<Vector2d>& wish : wishes)
        if (wish)
            standing.push_back(*wish);
    std::vector<Vector2d> round = placesRound(block, mostRound);
    for (std::size_t i = 0; i < wishes.size() && !round.empty(); ++i) {
        const double radius = socketRadius(keys, i == 0, shift);
        std::optional<Vector2d> place = wishes[i];
        if (!place) {
            const auto freeAt = [&](std::vector<Vector2d>::iterator at) {
                const Vector2d near = *at;
                const auto found = nearestFree(near, radius, block, taken, {steel, steel}, pull);
                if (found)
                    round.erase(at);
                return found;
            };
            const auto farthest = farthestFrom(round, standing);
            place = freeAt(farthest);
            if (!place && farthest != round.begin())
                place = freeAt(round.begin());
            if (!place)
                break;
            standing.push_back(*place);
        }
        places.push_back(*place);
        taken.push_back(planCircle(*place, radius, circleCorners));
    }
    return places;
}

PlanShape keyRoom(const KeySettings& keys, const Directions& directions, int number, const Vector2d& place) {
    return planCircle(place, socketRadius(keys, number == 0, shiftOf(keys, directions)), circleCorners);
}

Result<RegistrationKey> registrationKey(const KeySettings& keys, bool odd, const Vector2d& place,
                                        const Directions& directions, double draftDegrees, double grid) {
    RegistrationKey key;
    key.place = place;
    key.diameter = diameterOf(keys, odd);
    const double draft = std::max(keys.draft, draftDegrees);
    Result<DraftedPrism> frustum1 = frustum(place, key.diameter / 2, keys.height, directions, draft, grid);
    if (!frustum1)
        return std::unexpected(frustum1.error());
    key.key = *std::move(frustum1);
    double steepest = 0;
    for (const double slope : key.key.slope[0])
        steepest = std::max(steepest, std::abs(slope));
    key.leanDegrees = degrees(std::atan(steepest));
    // Across a wall of slope k a gap of c is c·√(1+k²) along the plane, and the polygon's sides lie within
    // the circle through its corners.
    const double gap =
        keys.clearance * std::sqrt(1 + steepest * steepest) / std::cos(radians(180.0 / circleCorners));
    Result<DraftedPrism> socket =
        frustum(place, key.diameter / 2 + gap, keys.height + keys.clearance, directions, draft, grid);
    if (!socket)
        return std::unexpected(socket.error());
    key.socket = *std::move(socket);
    return key;
}

Vector2d onFace(const Vector2d& wish, const Block& block) {
    const Eigen::AlignedBox2d box = block.plan();
    return {wish.x() < 0 ? box.min().x() : box.max().x(), wish.y()};
}

std::vector<Vector2d> slitPlaces(const SlitSettings& slits, const Block& block, const Obstacles& obstacles,
                                 double steel, const Wishes& wishes, Pull pull) {
    std::vector<Vector2d> places;
    Obstacles taken = obstacles;
    const Eigen::AlignedBox2d box = block.plan();
    const double reach = box.max().y() - slits.width / 2 - steel;
    const Vector2d middle = box.center();
    const auto full = [&](std::size_t more) { return places.size() + more >= wishes.size(); };
    // A slit by hand needs no place of this pair.
    const auto free = [&](std::size_t more, const Vector2d& place) {
        return (!full(more) && wishes[places.size() + more]) ||
               keepsClear(slitShape(slits, place), taken, steel);
    };
    std::vector<double> rows;
    for (double y = reach; y > middle.y(); y -= searchStep)
        rows.push_back(y);
    // From the corner inwards: there the leverage is best. A shell has no corners.
    if (pull == Pull::Inwards)
        std::reverse(rows.begin(), rows.end());
    for (const double y : rows)
        for (const double way : {1.0, -1.0}) {
            const Vector2d place(box.max().x(), middle.y() + way * (y - middle.y()));
            const Vector2d opposite(box.min().x(), middle.y() - way * (y - middle.y()));
            if (full(0) || !free(0, place) || (wishes.size() > 1 && !free(1, opposite)))
                continue;
            for (const Vector2d& p : {place, opposite})
                if (!full(0)) {
                    const auto& wish = wishes[places.size()];
                    places.push_back(wish ? onFace(*wish, block) : p);
                    taken.push_back(slitShape(slits, places.back()));
                }
        }
    return places;
}

PlanShape slitShape(const SlitSettings& slits, const Vector2d& place) {
    const double inner = place.x() > 0 ? place.x() - slits.depth : place.x() + slits.depth;
    return planRectangle({std::min(inner, place.x()), place.y() - slits.width / 2},
                         {std::max(inner, place.x()), place.y() + slits.width / 2});
}

Result<WedgeSlit> wedgeSlit(const SlitSettings& slits, const Vector2d& place, const Block& block,
                            const Directions& directions, double draftDegrees, double grid) {
    PrismRequest request;
    request.base = slitShape(slits, place);
    request.openings = {
        {place.x() > 0 ? 1UL : 3UL, block.flare(place.x() > 0 ? Vector2d(1, 0) : Vector2d(-1, 0))}};
    request.height = {slits.height, slits.height};
    request.directions = {std::vector{directions.d1}, std::vector{directions.d2}};
    request.draftDegrees = draftDegrees + 0.5;
    request.leastSlope = 0;
    request.grid = grid;
    request.closed = {
        MW_TEXT("Mold",
                "A wedge slit of {0} by {1} mm cannot be {2} mm high in each half with the draft that "
                "its walls need. Make it lower, or larger."),
        {readable(slits.width), readable(slits.depth), readable(slits.height)}};
    Result<DraftedPrism> prism = draftedPrism(request);
    if (!prism)
        return std::unexpected(prism.error());
    return WedgeSlit{*std::move(prism), place};
}

} // namespace moldwright
