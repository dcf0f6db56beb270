// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/design.h"

#include "design/default_method.h"
#include "design/design_run.h"
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

} // namespace

Result<DesignResult> design(const DesignRequest& request, const Task& task, const FrameSink& frames) {
    DesignRun run(request, task, frames);
    if (const std::optional<Error> refusal = contradictionIn(request))
        return std::unexpected(*refusal);
    Result<DesignResult> result =
        request.method == DeformationMethod::Paper ? designAsPublished(run) : designByBending(run);
    if (!result && result.error().code == ErrorCode::Cancelled && request.keepUnfinished) {
        result = DesignResult{}; // nothing was reached yet
        result->cutShort = true;
        result->certificate.reason = "The design was stopped before it had a shape.";
    }
    if (result)
        result->seconds = run.seconds();
    return result;
}

} // namespace moldwright
