// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/suggested_pins.h"

#include "base/parallel.h"
#include "mesh/decimate.h"
#include "mesh/geodesic.h"
#include "mesh/measures.h"
#include "pins/cgal/inside_test.h"
#include "pins/coverage.h"
#include "pins/medial_axis.h"
#include "pins/pin_ranking.h"
#include "pins/simplify.h"
#include "pins/surface_samples.h"
#include "pins/unit_part.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moldwright {

namespace {

// Lengths in sizes of the part, see UnitPart.
constexpr double kJitter = 4e-6;
constexpr double kReach = 0.03;           ///< no surface is farther from every ball
constexpr double kProminence = 0.03;      ///< of a limb's tip, in mean distance
constexpr double kTouches = 0.004;        ///< a ball this near to a tip touches it
constexpr double kTipRadius = 0.04;       ///< of the ball in a tip at most: a pin is to lie near the tip
constexpr double kLeastProtrusion = 0.02; ///< of an end of the axis beyond what it hangs on
constexpr double kLeastSpacing = 0.04;
constexpr double kSpacingInRadii = 0.6;
constexpr int kMostFaces = 30000; ///< more are decimated first: the axis needs no more

/// A ball that may become a pin.
struct Candidate {
    MedialBall ball;
    PinKind kind;
};

/// The ball in the end of a limb that touches its tip: of the largest there as much as keeps near the tip.
/// Radius 0: none touches it.
MedialBall ballInTip(const Eigen::Vector3d& tip, const MedialMesh& axis) {
    MedialBall largest;
    for (const MedialBall& ball : axis.balls)
        if (distanceFrom(ball, tip) <= kTouches && ball.radius > largest.radius)
            largest = ball;
    if (largest.radius <= kTipRadius)
        return largest;
    const Eigen::Vector3d out = (tip - largest.centre).normalized();
    return {largest.centre + (largest.radius - kTipRadius) * out, kTipRadius};
}

std::vector<Candidate> tipCandidates(const IndexedMesh& mesh, const MedialMesh& axis) {
    std::vector<Candidate> tips;
    for (const int v : limbTips(EdgeGraph(mesh), kProminence))
        if (const MedialBall ball = ballInTip(mesh.point(v), axis); ball.radius > 0)
            tips.push_back({ball, PinKind::Tip});
    return tips;
}

/// The ball of the axis itself that is most like one that fits the planes best.
MedialBall nearestOnAxis(const MedialBall& ball, const MedialMesh& axis) {
    const auto unlike = [&](const MedialBall& other) {
        const double dr = other.radius - ball.radius;
        return (other.centre - ball.centre).squaredNorm() + dr * dr;
    };
    return *std::min_element(axis.balls.begin(), axis.balls.end(),
                             [&](const MedialBall& a, const MedialBall& b) { return unlike(a) < unlike(b); });
}

/// The balls of the reduced axis, largest first; ends that hardly protrude are left out.
std::vector<Candidate> axisCandidates(const MedialMesh& reduced, const MedialMesh& axis) {
    std::vector<std::vector<int>> around(reduced.balls.size());
    for (const auto& [a, b] : reduced.edges) {
        around[static_cast<std::size_t>(a)].push_back(b);
        around[static_cast<std::size_t>(b)].push_back(a);
    }
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < around.size(); ++i) {
        const MedialBall& ball = reduced.balls[i];
        const bool end = around[i].size() == 1;
        if (end) {
            const MedialBall& next = reduced.balls[static_cast<std::size_t>(around[i].front())];
            if ((ball.centre - next.centre).norm() + ball.radius - next.radius < kLeastProtrusion)
                continue;
        }
        candidates.push_back({nearestOnAxis(ball, axis), end                    ? PinKind::Tip
                                                         : around[i].size() > 2 ? PinKind::Junction
                                                                                : PinKind::Body});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.ball.radius > b.ball.radius; });
    return candidates;
}

/// The candidates that keep their distance from all before them.
std::vector<Candidate> spaced(const std::vector<Candidate>& candidates) {
    std::vector<Candidate> kept;
    for (const Candidate& c : candidates) {
        const double spacing = std::max(kLeastSpacing, kSpacingInRadii * c.ball.radius);
        if (std::all_of(kept.begin(), kept.end(), [&](const Candidate& k) {
                return (k.ball.centre - c.ball.centre).norm() >= spacing;
            }))
            kept.push_back(c);
    }
    return kept;
}

std::vector<int> nearestOfFaces(const std::vector<Candidate>& pins, const IndexedMesh& mesh) {
    std::vector<int> nearest(static_cast<std::size_t>(mesh.faceCount()), 0);
    parallelFor(nearest.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const int face = static_cast<int>(f);
            const Eigen::Vector3d p =
                (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3;
            const auto closer = [&](const Candidate& a, const Candidate& b) {
                return distanceFrom(a.ball, p) < distanceFrom(b.ball, p);
            };
            nearest[f] = static_cast<int>(std::min_element(pins.begin(), pins.end(), closer) - pins.begin());
        }
    });
    return nearest;
}

/// The share of the surface that is each pin's, `nearest` being the pin of each face.
std::vector<double> areaShares(std::size_t pins, const std::vector<int>& nearest, const IndexedMesh& mesh) {
    std::vector<double> shares(pins, 0);
    const double whole = surfaceArea(mesh);
    for (int f = 0; f < mesh.faceCount(); ++f)
        shares[static_cast<std::size_t>(nearest[static_cast<std::size_t>(f)])] +=
            doubleAreaVector(mesh, f).norm() / 2 / whole;
    return shares;
}

/// At most `count` of the pins: those with the least surface go first, the ends of limbs last.
std::vector<Candidate> fewest(std::vector<Candidate> pins, int count, const IndexedMesh& mesh) {
    if (static_cast<int>(pins.size()) <= count)
        return pins;
    const std::vector<double> shares = areaShares(pins.size(), nearestOfFaces(pins, mesh), mesh);
    std::vector<std::size_t> order(pins.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const bool tipA = pins[a].kind == PinKind::Tip;
        const bool tipB = pins[b].kind == PinKind::Tip;
        return tipA != tipB ? tipA : shares[a] > shares[b];
    });
    order.resize(static_cast<std::size_t>(std::max(count, 1)));
    std::sort(order.begin(), order.end());
    std::vector<Candidate> kept;
    for (const std::size_t i : order)
        kept.push_back(pins[i]);
    return kept;
}

/// Highest rank first.
PinSuggestions suggestionsOf(const std::vector<Candidate>& pins, const UnitPart& unit) {
    std::vector<SuggestedPin> found;
    const std::vector<int> nearest = nearestOfFaces(pins, unit.mesh);
    const std::vector<double> shares = areaShares(pins.size(), nearest, unit.mesh);
    for (std::size_t i = 0; i < pins.size(); ++i)
        found.push_back({unit.toPart(pins[i].ball.centre), unit.size * pins[i].ball.radius, pins[i].kind,
                         shares[i], 0, 0});
    setRanks(found);
    std::vector<std::size_t> order(pins.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return found[a].rank > found[b].rank; });
    PinSuggestions ordered;
    std::vector<int> now(pins.size());
    for (const std::size_t i : order) {
        now[i] = static_cast<int>(ordered.pins.size());
        ordered.pins.push_back(found[i]);
    }
    for (const int pin : nearest)
        ordered.pinOfFace.push_back(now[static_cast<std::size_t>(pin)]);
    return ordered;
}

} // namespace

Result<PinSuggestions> suggestPins(const IndexedMesh& part, const PinSearch& search, const Task& task) {
    const UnitPart unit(part);
    const IndexedMesh coarse = decimate(unit.mesh, kMostFaces);
    const Points samples = surfaceSamples(coarse, kJitter, search.seed);
    const InsideTest solid(unit.mesh);
    const MedialMesh axis = medialAxis(samples, solid, task.part(0, 0.5));
    const auto cancelled = [] {
        return failure(ErrorCode::Cancelled, MW_TEXT("pins", "The search for pins was cancelled."));
    };
    if (task.stopped())
        return cancelled();
    if (axis.balls.empty())
        return PinSuggestions{{}, std::vector<int>(static_cast<std::size_t>(part.faceCount()), -1)};
    const MedialMesh reduced = simplify(axis, search.count, task.part(0.5, 0.9));
    if (task.stopped())
        return cancelled();
    std::vector<Candidate> candidates = tipCandidates(coarse, axis);
    for (const Candidate& c : axisCandidates(reduced, axis))
        candidates.push_back(c);
    std::vector<MedialBall> balls;
    for (const Candidate& c : candidates)
        balls.push_back(c.ball);
    for (const MedialBall& ball : missingBalls(samples, axis, balls, kReach, search.count))
        candidates.push_back({ball, PinKind::Body});
    std::erase_if(candidates, [&](const Candidate& c) { return !solid.inside(c.ball.centre); });
    return suggestionsOf(fewest(spaced(candidates), search.count, unit.mesh), unit);
}

} // namespace moldwright
