// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/design.h"

#include "design/default_method.h"
#include "design/design_run.h"
#include "design/paper_method.h"

namespace moldwright {

Result<DesignResult> design(const DesignRequest& request, const Task& task, const FrameSink& frames) {
    DesignRun run(request, task, frames);
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
