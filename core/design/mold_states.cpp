// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/mold_states.h"

#include "design/filling.h"
#include "design/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr int kCandidatePlanes = 60;    ///< searched for those that pass the topological certificate
constexpr double kLeanDifferently = 35; ///< degrees between normals

bool leansAlike(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::abs(a.dot(b)) > std::cos(radians(kLeanDifferently));
}

} // namespace

Result<MoldStates> MoldStates::create(const IndexedMesh& shape, DesignRun& run) {
    MoldStates states(shape, run);
    if (run.request().plane) {
        states.m_best = {*run.request().plane, run.directionsFor(shape, *run.request().plane)};
        states.m_left.push_back({states.m_best});
        return states;
    }
    const Stopwatch watch(run.seconds(), "plane");
    states.m_left = findPlanes(shape, run.planeSearch(kCandidatePlanes), run.task().part(0, 0.1));
    if (run.stopped() || states.m_left.empty())
        return DesignRun::cancelled();
    states.m_best = states.stateAt(states.m_left.front());
    // The first was preferred by the search; without it energy alone counts.
    std::stable_sort(states.m_left.begin() + 1, states.m_left.end(),
                     [](const PlaneCandidate& a, const PlaneCandidate& b) { return a.energy < b.energy; });
    return states;
}

MoldState MoldStates::stateAt(const PlaneCandidate& candidate) const {
    MoldState state = candidate.state;
    if (!m_run->request().plane && m_run->request().directionsChoice != DirectionsChoice::Normal)
        state.directions = m_run->directionsFor(*m_shape, state.plane);
    return state;
}

std::optional<MoldState> MoldStates::takeIfPassing(std::size_t i) {
    const MoldState state = stateAt(m_left[i]);
    m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(i));
    if (!planePasses(*m_shape, state, m_run->request().undercuts, m_run->task()))
        return std::nullopt;
    m_normals.push_back(state.plane.normal);
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
