// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/mold_states.h"

#include "base/parallel.h"
#include "design/filling.h"
#include "design/stopwatch.h"
#include "fill/fill_estimate.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr int kCandidatePlanes = 60;    ///< searched for those that pass the topological certificate
constexpr double kLeanDifferently = 35; ///< degrees between normals

bool leansAlike(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::abs(a.dot(b)) > std::cos(radians(kLeanDifferently));
}

/// Towards the middles of a cube's faces, its corners and its edges, one of each two opposite ones.
std::vector<Eigen::Vector3d> evenDirections() {
    std::vector<Eigen::Vector3d> directions;
    for (const int parts : {1, 3, 2})
        for (int code = 14; code < 27; ++code) {
            const Eigen::Vector3d way(code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1);
            if (way.cwiseAbs().sum() == parts)
                directions.push_back(way.normalized());
        }
    return directions;
}

} // namespace

Result<MoldStates> MoldStates::create(const IndexedMesh& shape, DesignRun& run) {
    MoldStates states(shape, run);
    if (run.request().plane) {
        states.m_best = {*run.request().plane, run.directionsFor(shape, *run.request().plane)};
        states.m_all = states.m_left = {{states.m_best, true}};
        return states;
    }
    const Stopwatch watch(run.seconds(), "plane");
    std::vector<PlaneCandidate> found =
        findPlanes(shape, run.planeSearch(kCandidatePlanes), run.task().part(0, 0.1));
    if (run.stopped() || found.empty())
        return DesignRun::cancelled();
    states.m_best = states.stateAt(found.front().state);
    // The first was preferred by the search; without it energy alone counts.
    std::stable_sort(found.begin() + 1, found.end(),
                     [](const PlaneCandidate& a, const PlaneCandidate& b) { return a.energy < b.energy; });
    for (const PlaneCandidate& candidate : found)
        states.m_all.push_back({candidate.state, true});
    states.addOtherPlanes();
    states.m_left = states.m_all;
    return states;
}

/// Through the middle of the part's volume.
void MoldStates::addOtherPlanes() {
    const Eigen::Vector3d middle = centroid(*m_shape);
    const PlaneSearch search = m_run->planeSearch(1);
    const DirectionLimits limits = search.normalDirections ? alongNormal(search.limits) : search.limits;
    for (const Eigen::Vector3d& normal : evenDirections()) {
        const bool isNew = std::ranges::none_of(
            m_all, [&](const Candidate& there) { return leansAlike(there.state.plane.normal, normal); });
        if (isNew && allows(limits, normal))
            m_all.push_back({{{normal, normal.dot(middle)}, middleDirections(limits, normal)}, false});
    }
}

FillableState MoldStates::leastToFill() const {
    const Stopwatch watch(m_run->seconds(), "plane");
    std::vector<FillableState> states;
    states.reserve(m_all.size());
    for (const Candidate& candidate : m_all)
        states.push_back({stateAt(candidate.state), 0});
    parallelFor(states.size(), 1, [&](std::size_t i, std::size_t) {
        states[i].filled = estimatedFill(*m_shape, states[i].state);
    });
    return *std::ranges::min_element(states, {}, &FillableState::filled);
}

MoldState MoldStates::stateAt(const MoldState& candidate) const {
    MoldState state = candidate;
    if (!m_run->request().plane && m_run->request().directionsChoice != DirectionsChoice::Normal)
        state.directions = m_run->directionsFor(*m_shape, state.plane);
    return state;
}

std::optional<MoldState> MoldStates::takeIfPassing(std::size_t i) {
    const Candidate candidate = m_left[i];
    const MoldState state = stateAt(candidate.state);
    m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(i));
    if (!planePasses(*m_shape, state, m_run->request().undercuts, m_run->task()))
        return std::nullopt;
    m_normals.push_back(state.plane.normal);
    m_bestPassed = m_bestPassed || candidate.isBest;
    return state;
}

std::optional<MoldState> MoldStates::next() {
    const Stopwatch watch(m_run->seconds(), "plane");
    for (const bool mustDiffer : {true, false})
        for (std::size_t i = 0; i < m_left.size() && !m_run->stopped();) {
            const Eigen::Vector3d normal = m_left[i].state.plane.normal;
            const bool alike = std::any_of(m_normals.begin(), m_normals.end(),
                                           [&](const Eigen::Vector3d& n) { return leansAlike(n, normal); });
            if (mustDiffer && alike)
                ++i;
            else if (const std::optional<MoldState> state = takeIfPassing(i))
                return state;
        }
    return std::nullopt;
}

} // namespace moldwright
