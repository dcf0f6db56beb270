// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/mold_states.h"

#include "castability/plane_search.h"
#include "design/parting.h"
#include "design/stopwatch.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr int kCandidatePlanes = 60;    ///< searched for those that pass the topological certificate
constexpr std::size_t kMostPassing = 8; ///< more are not looked for

MoldStates atGivenPlane(const IndexedMesh& shape, const PartingPlane& plane, DesignRun& run) {
    MoldStates states;
    states.best = {plane, run.directionsFor(shape, plane)};
    states.obstructions = obstructionsAt(shape, states.best);
    if (states.obstructions.empty())
        states.passing = {states.best};
    return states;
}

std::vector<PlaneCandidate> candidatesFor(const IndexedMesh& shape, const DesignRun& run) {
    PlaneSearch search;
    search.count = kCandidatePlanes;
    search.draftDegrees = run.request().draftDegrees;
    search.maxTiltDegrees = run.request().maxTiltDegrees;
    search.normalDirections = run.request().directionsChoice == DirectionsChoice::Normal;
    search.seed = run.request().seed;
    return findPlanes(shape, search, run.task().part(0, 0.1));
}

} // namespace

Result<MoldStates> moldStatesFor(const IndexedMesh& shape, DesignRun& run) {
    if (run.request().plane)
        return atGivenPlane(shape, *run.request().plane, run);
    const Stopwatch watch(run.seconds(), "plane");
    const std::vector<PlaneCandidate> candidates = candidatesFor(shape, run);
    if (run.stopped() || candidates.empty())
        return DesignRun::cancelled();
    const auto stateAt = [&](const PlaneCandidate& candidate) {
        MoldState state = candidate.state;
        if (run.request().directionsChoice != DirectionsChoice::Normal)
            state.directions = run.directionsFor(shape, state.plane);
        return state;
    };
    std::vector<std::pair<double, MoldState>> passing;
    for (const PlaneCandidate& candidate : candidates) {
        if (run.stopped())
            return DesignRun::cancelled();
        const MoldState state = stateAt(candidate);
        if (planePasses(shape, state))
            passing.emplace_back(candidate.energy, state);
        if (passing.size() == kMostPassing)
            break;
    }
    if (!passing.empty())
        std::stable_sort(passing.begin() + 1, passing.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
    MoldStates states;
    states.best = stateAt(candidates.front());
    for (const auto& [energy, state] : passing)
        states.passing.push_back(state);
    if (passing.empty())
        states.obstructions = obstructionsAt(shape, states.best);
    return states;
}

} // namespace moldwright
