// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/pipeline.h"

#include "project/title.h"
#include "project/variants.h"

namespace moldwright {

Result<Evaluation> evaluate(const Project& project, const Task& task) {
    Evaluation evaluation;
    const auto stopped = [&] {
        return failure(ErrorCode::Cancelled, MW_TEXT("Project", "The evaluation was cancelled."));
    };
    task.progress(0, "Draft of the part");
    if (project.part && project.state)
        evaluation.part = analyzeDraft(*project.part, *project.state, project.design.draftDegrees);
    if (task.stopped())
        return stopped();
    if (!project.cast)
        return evaluation;
    const CastResult& cast = *project.cast;
    Result<Mold> mold = buildMold(trayOf(project, project.name), cast.draftDegrees, moldAsBuilt(project),
                                  task.part(0.3, 0.8));
    if (!mold && mold.error().code == ErrorCode::Cancelled)
        return stopped();
    task.progress(0.8, "Draft of the cast");
    if (mold) {
        evaluation.mold = std::make_shared<const Mold>(*std::move(mold));
        // In the mold's frame the parting line lies at z = 0 exactly: no face crosses the plane by rounding.
        evaluation.cast =
            analyzeDraft(*evaluation.mold->cast, {{}, evaluation.mold->directions}, cast.draftDegrees);
    } else {
        evaluation.moldFailure = std::move(mold).error();
        evaluation.cast = analyzeDraft(*cast.mesh, cast.state, cast.draftDegrees);
    }
    return evaluation;
}

} // namespace moldwright
