// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/design_run.h"

#include "castability/analysis.h"
#include "castability/cast_analysis.h"
#include "castability/directions.h"
#include "design/stopwatch.h"

namespace moldwright {

DesignRun::DesignRun(const DesignRequest& request, const Task& task, FrameSink frames, SharedMesh start,
                     WhenReplaced whenReplaced)
    : m_request(request), m_start(start ? std::move(start) : request.part), m_frames(std::move(frames)),
      m_leg(std::make_shared<Leg>(Leg{task, request, {}, {}, {}, std::move(whenReplaced)})) {}

DesignRun DesignRun::at(const PartingPlane& plane) const {
    DesignRun there = *this;
    there.m_seconds.clear();
    there.m_request.plane = plane;
    return there;
}

void DesignRun::takeSettings(const DesignRun& other) {
    const std::optional<PartingPlane> plane = m_request.plane;
    static_cast<LiveSettings&>(m_request) = other.request();
    m_request.plane = plane;
}

bool DesignRun::hear(bool inPlace) {
    if (!live() || m_leg->next || stopped())
        return false;
    const std::optional<LiveSettings> newest = m_request.newest();
    if (!newest || *newest == m_leg->heard)
        return false;
    const bool samePlane = !newest->plane || newest->plane == m_request.plane;
    if (inPlace && samePlane && newest->pins == m_request.pins) {
        const std::optional<PartingPlane> plane = m_request.plane;
        static_cast<LiveSettings&>(m_request) = *newest;
        m_request.plane = plane;
        m_leg->heard = *newest;
        return true;
    }
    m_leg->next = newest;
    if (!m_request.bendMeanwhile || !m_request.bendMeanwhile())
        end();
    if (m_leg->whenReplaced)
        m_leg->whenReplaced(*this);
    return false;
}

bool DesignRun::finishAsked() const {
    return !m_leg->next && m_request.finishNow && m_request.finishNow();
}

void DesignRun::setReached(const IndexedMesh& shape, const MoldState& state) {
    m_leg->reached = std::make_shared<const Points>(shape.V.topRows(m_start->vertexCount()));
    m_leg->reachedState = state;
}

Directions DesignRun::directionsFor(const IndexedMesh& shape, const PartingPlane& plane) {
    const Stopwatch watch(m_seconds, "directions_first");
    switch (m_request.directionsChoice) {
    case DirectionsChoice::Given:
        return m_request.directions;
    case DirectionsChoice::Normal:
        return Directions::normalTo(plane);
    default:
        return bestDirections(shape, plane, m_request.draftDegrees, m_request.limits);
    }
}

PlaneSearch DesignRun::planeSearch(int count) const {
    PlaneSearch search;
    search.count = count;
    search.draftDegrees = m_request.draftDegrees;
    search.limits = m_request.limits;
    search.normalDirections = m_request.directionsChoice == DirectionsChoice::Normal;
    search.seed = m_request.seed;
    return search;
}

void DesignRun::show(SeenStep step) {
    if (!m_frames)
        return;
    const auto& [stage, shape, labels, state, before] = step;
    const DraftAnalysis analysis = labels.empty() ? analyzeDraft(shape, state, m_request.draftDegrees, false)
                                                  : analyzeCast(shape, labels, state, m_request.draftDegrees);
    m_frames({stage, std::make_shared<const IndexedMesh>(std::move(step.shape)), labels, state, before,
              m_leg->reached, 0, analysis.energy, analysis.worstDraftDegrees, analysis.violatingAreaFraction,
              m_leg->heard});
}

std::unexpected<Error> DesignRun::cancelled() {
    return failure(ErrorCode::Cancelled, MW_TEXT("design", "The design was cancelled."));
}

} // namespace moldwright
