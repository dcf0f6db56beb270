// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/plane_search.h"

#include "base/parallel.h"
#include "castability/directions.h"
#include "castability/flat_back.h"
#include "castability/minimize.h"
#include "castability/state_coordinates.h"
#include "castability/state_cost.h"
#include "mesh/cluster.h"
#include "mesh/measures.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

namespace moldwright {

namespace {

constexpr int kProxyFaces = 2500;
constexpr double kDistinctShare = 0.06; ///< of the part's extent along the normal
constexpr int kAxisSteps = 20;          ///< planes square to each axis that are always tried
constexpr double kSmallSide = 0.15;     ///< below this share of the volume a side counts as too small
constexpr int kSpareStarts = 12;        ///< refined beside the planes asked for: some end in one place
constexpr int kRefineSteps = 30;
constexpr int kPolished = 8; ///< best candidates that are refined on the mesh itself
constexpr int kPolishSteps = 12;
constexpr double kLargestLean = 89; ///< degrees, of a normal against the axis of a press

/// A candidate on the way: in the frame of the scaled mesh.
struct Trial {
    MoldState state;
    double extent = 0; ///< of the part along the normal
    double score = 0;
};

/// A surface that states are judged on; diagonal 1, centred.
struct Surface {
    explicit Surface(IndexedMesh mesh)
        : shape(std::move(mesh)), faces(shape), volume(moldwright::volume(shape)) {}

    IndexedMesh shape;
    FaceArrays faces;
    double volume;
};

/// Factor up to 2 where nearly all of the volume lies on one side, and its derivative with respect to the
/// share above. A factor, so that a plane at which the part already passes (energy 0) is never worse for it.
std::pair<double, double> oneSidedness(double shareAbove) {
    const double smaller = std::min(shareAbove, 1 - shareAbove);
    const double missing = std::max(0.0, (kSmallSide - smaller) / kSmallSide);
    const double slope = missing > 0 ? (shareAbove < 0.5 ? -1 : 1) / kSmallSide : 0.0;
    return {1 + missing, slope};
}

/// Energy times one-sidedness of each trial.
std::vector<StateCost> scoreAll(const Surface& surface, std::vector<Trial>& trials, double tau) {
    std::vector<MoldState> states;
    states.reserve(trials.size());
    for (const Trial& trial : trials)
        states.push_back(trial.state);
    std::vector<StateCost> costs = stateCosts(surface.faces, states, tau);
    for (std::size_t i = 0; i < trials.size(); ++i)
        trials[i].score = costs[i].energy * oneSidedness(costs[i].volumeAbove / surface.volume).first;
    return costs;
}

/// Lowest and highest place of the points along a direction.
std::pair<double, double> span(const Points& V, const Eigen::Vector3d& direction) {
    const Eigen::VectorXd heights = V * direction;
    return {heights.minCoeff(), heights.maxCoeff()};
}

/// What limits the directions of a search.
DirectionLimits limitsOf(const PlaneSearch& wanted) {
    return wanted.normalDirections ? alongNormal(wanted.limits) : wanted.limits;
}

/// The plane square to `normal` at a share of the way through the points.
Trial trialAt(const Points& V, const Eigen::Vector3d& normal, double share, const DirectionLimits& limits) {
    const auto [low, high] = span(V, normal);
    const MoldState state{{normal, low + (high - low) * share}, middleDirections(limits, normal)};
    return {state, high - low, 0};
}

/// A normal by two numbers in 0 … 1, any that allows directions as likely as any other.
Eigen::Vector3d normalAt(double share, double turn, const DirectionLimits& limits) {
    const double most =
        limits.axis ? std::min(limits.maxTiltDegrees + limits.coneDegrees, kLargestLean) : 180.0;
    const double lowest = std::cos(radians(most));
    const double z = lowest + (1 - lowest) * share;
    const double angle = 2 * std::numbers::pi * turn;
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const Eigen::Vector3d normal(r * std::cos(angle), r * std::sin(angle), z);
    return limits.axis ? Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), *limits.axis) * normal
                       : normal;
}

std::vector<Trial> samplePlanes(const Points& V, const PlaneSearch& wanted) {
    std::mt19937 random(wanted.seed);
    const DirectionLimits limits = limitsOf(wanted);
    // Plain arithmetic on the generator's words: the library's distributions differ between platforms.
    const auto uniform = [&] { return (random() + 0.5) / 4294967296.0; };
    std::vector<Trial> trials;
    // Made parts stand square to their axes, and their seams are often near an end.
    for (int axis = 0; axis < 3; ++axis)
        for (int step = 1; step < kAxisSteps && allows(limits, Eigen::Vector3d::Unit(axis)); ++step)
            trials.push_back(
                trialAt(V, Eigen::Vector3d::Unit(axis), static_cast<double>(step) / kAxisSteps, limits));
    while (static_cast<int>(trials.size()) < wanted.samples) {
        const double share = uniform();
        const double turn = uniform();
        trials.push_back(trialAt(V, normalAt(share, turn, limits), 0.1 + 0.8 * uniform(), limits));
    }
    return trials;
}

/// Planes are distinct when they lean differently or cut at clearly different heights of the part.
bool distinct(const Trial& a, const Trial& b) {
    static const double sameLean = std::cos(radians(12));
    const double cosine = a.state.plane.normal.dot(b.state.plane.normal);
    if (std::abs(cosine) < sameLean)
        return true;
    const double offset = cosine > 0 ? b.state.plane.offset : -b.state.plane.offset;
    return std::abs(a.state.plane.offset - offset) > kDistinctShare * a.extent;
}

/// The best trials that are distinct from each other, best first: their indices.
std::vector<std::size_t> bestDistinct(const std::vector<Trial>& trials, int count) {
    std::vector<std::size_t> order(trials.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return trials[a].score < trials[b].score; });
    std::vector<std::size_t> kept;
    for (const std::size_t i : order) {
        const bool isNew = std::all_of(kept.begin(), kept.end(),
                                       [&](std::size_t k) { return distinct(trials[i], trials[k]); });
        if (isNew)
            kept.push_back(i);
        if (static_cast<int>(kept.size()) == count)
            break;
    }
    return kept;
}

/// Energy times one-sidedness from a start downhill.
Trial refine(const Surface& surface, const Trial& start, const PlaneSearch& wanted, int steps) {
    const DirectionLimits limits = limitsOf(wanted);
    const DirectionsFollow follow = wanted.normalDirections ? DirectionsFollow::Normal
                                    : limits.axis           ? DirectionsFollow::Held
                                                            : DirectionsFollow::Freely;
    const StateCoordinates coordinates(start.state, limits.maxTiltDegrees, follow);
    const double tau = std::sin(radians(wanted.draftDegrees));
    const Objective objective = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        const MoldState state = coordinates.state(x);
        StateGradient g;
        VolumeGradient v;
        const StateCost cost = stateCost(surface.faces, state, tau, g, v);
        const auto [factor, slope] = oneSidedness(cost.volumeAbove / surface.volume);
        const double dVolume = cost.energy * slope / surface.volume;
        g.normal = factor * g.normal + dVolume * v.normal;
        g.offset = factor * g.offset + dVolume * v.offset;
        g.d1 *= factor;
        g.d2 *= factor;
        coordinates.pullBack(x, g, gradient);
        return cost.energy * factor;
    };
    MinimizeOptions options;
    options.iterations = steps;
    options.relativeDecrease = 1e-3;
    const Minimum best = minimize(objective, coordinates.origin(), options);
    MoldState state = coordinates.state(best.x);
    if (!allows(limits, state.plane.normal))
        return start;
    if (follow == DirectionsFollow::Held)
        state.directions = bestDirections(surface.shape, state.plane, wanted.draftDegrees, limits);
    const auto [low, high] = span(surface.shape.V, state.plane.normal);
    return {state, high - low, best.value};
}

/// Adds what refinement makes of the chosen trials. They stay candidates of their own: there may be more
/// planes asked for than minima.
void addRefined(const Surface& surface, const std::vector<std::size_t>& chosen, int steps,
                const PlaneSearch& wanted, const Task& task, std::vector<Trial>& trials) {
    std::vector<Trial> refined(chosen.size());
    parallelFor(chosen.size(), 1, [&](std::size_t i, std::size_t) {
        const Trial& start = trials[chosen[i]];
        refined[i] = task.stopped() ? start : refine(surface, start, wanted, steps);
        task.progress(static_cast<double>(i) / static_cast<double>(chosen.size()), "plane");
    });
    trials.insert(trials.end(), refined.begin(), refined.end());
}

std::vector<Trial> chosenOf(const std::vector<Trial>& trials, const std::vector<std::size_t>& chosen) {
    std::vector<Trial> kept;
    kept.reserve(chosen.size());
    for (const std::size_t i : chosen)
        kept.push_back(trials[i]);
    return kept;
}

Trial flatBackTrial(const Surface& surface, const PartingPlane& plane, const PlaneSearch& wanted) {
    Trial trial{{plane, bestDirections(surface.shape, plane, wanted.draftDegrees, limitsOf(wanted))}, 0, 0};
    const auto [low, high] = span(surface.shape.V, plane.normal);
    trial.extent = high - low;
    return trial;
}

} // namespace

std::vector<PlaneCandidate> findPlanes(const IndexedMesh& mesh, const PlaneSearch& wanted, const Task& task) {
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    const Eigen::Vector3d centre = box.center();
    const double scale = box.diagonal().norm();
    const double tau = std::sin(radians(wanted.draftDegrees));
    const Surface full(IndexedMesh{(mesh.V.rowwise() - centre.transpose()) / scale, mesh.F});
    const Surface proxy(cluster(full.shape, kProxyFaces));

    task.progress(0, "plane");
    std::vector<Trial> trials = samplePlanes(proxy.shape.V, wanted);
    (void)scoreAll(proxy, trials, tau);
    trials = chosenOf(trials, bestDistinct(trials, wanted.count + kSpareStarts));
    std::vector<std::size_t> all(trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    addRefined(proxy, all, kRefineSteps, wanted, task.part(0, 0.6), trials);
    for (const PartingPlane& plane : flatBackPlanes(full.shape))
        if (allows(limitsOf(wanted), plane.normal))
            trials.push_back(flatBackTrial(full, plane, wanted));
    (void)scoreAll(full, trials, tau);
    addRefined(full, bestDistinct(trials, std::min(wanted.count, kPolished)), kPolishSteps, wanted,
               task.part(0.6, 1), trials);

    const std::vector<StateCost> costs = scoreAll(full, trials, tau);
    const double area = full.faces.area();
    std::vector<PlaneCandidate> candidates;
    for (const std::size_t i : bestDistinct(trials, wanted.count)) {
        const double above = costs[i].volumeAbove / full.volume;
        PlaneCandidate candidate{trials[i].state, costs[i].energy, costs[i].violatingArea / area,
                                 draftDegrees(costs[i].worstSine), std::max(0.0, std::min(above, 1 - above))};
        PartingPlane& plane = candidate.state.plane;
        plane.offset = plane.offset * scale + plane.normal.dot(centre);
        candidates.push_back(candidate);
    }
    return candidates;
}

} // namespace moldwright
