// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/design_run.h"

#include "castability/analysis.h"
#include "castability/cast_analysis.h"
#include "castability/directions.h"
#include "design/stopwatch.h"

namespace moldwright {

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

void DesignRun::show(const char* stage, IndexedMesh shape, const SideLabels& labels, const MoldState& state) {
    if (!m_frames)
        return;
    const DraftAnalysis analysis = labels.empty() ? analyzeDraft(shape, state, m_request.draftDegrees, false)
                                                  : analyzeCast(shape, labels, state, m_request.draftDegrees);
    m_frames({stage, std::make_shared<const IndexedMesh>(std::move(shape)), labels, state, ++m_step,
              analysis.energy, analysis.worstDraftDegrees, analysis.violatingAreaFraction});
}

std::unexpected<Error> DesignRun::cancelled() {
    return failure(ErrorCode::Cancelled, MW_TEXT("design", "The design was cancelled."));
}

} // namespace moldwright
