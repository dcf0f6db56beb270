// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/design.h"

#include "design/default_method.h"
#include "design/design_run.h"
#include "design/legs.h"
#include "design/paper_method.h"

namespace moldwright {

namespace {

/// What cannot be had together; none where all can.
std::optional<Error> contradictionIn(const DesignRequest& request) {
    if (!request.undercuts.empty() && !request.plane)
        return Error{ErrorCode::Usage,
                     {MW_TEXT("design", "Undercuts were chosen to be filled or bent, and no plane was given: "
                                        "which undercuts there are depends on it. Give a plane too."),
                      {}},
                     {},
                     {}};
    const DirectionLimits limits =
        request.directionsChoice == DirectionsChoice::Normal ? alongNormal(request.limits) : request.limits;
    if (request.directionsChoice == DirectionsChoice::Given || !request.plane ||
        allows(limits, request.plane->normal))
        return std::nullopt;
    return Error{
        ErrorCode::Impossible,
        {MW_TEXT("design", "No direction within {0}° of the axis leaves the plane within {1}° of its "
                           "normal. Turn the plane towards the axis, or allow more."),
         {readable(limits.coneDegrees), readable(limits.maxTiltDegrees)}},
        {},
        {}};
}

Result<DesignResult> runLeg(DesignRun& run) {
    if (const std::optional<Error> refusal = contradictionIn(run.request()))
        return std::unexpected(*refusal);
    return run.request().method == DeformationMethod::Paper ? designAsPublished(run) : designByBending(run);
}

} // namespace

Result<DesignResult> design(const DesignRequest& request, const Task& task, const FrameSink& frames) {
    return Legs(request, task, frames, runLeg).run();
}

} // namespace moldwright
