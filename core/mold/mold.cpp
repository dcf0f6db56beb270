// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold.h"

#include "mold/mold_builder.h"

namespace moldwright {

Result<Mold> buildMold(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                       double draftDegrees, const MoldSettings& settings, const Task& task) {
    const auto stopped = [&] {
        return failure(ErrorCode::Cancelled, MW_TEXT("Mold", "Building the mold was cancelled."));
    };
    MoldBuilder builder(settings, draftDegrees);
    const auto stage = [&](double at, const char* name, Result<void> (MoldBuilder::*work)()) -> Result<void> {
        if (task.stopped())
            return stopped();
        task.progress(at, name);
        return (builder.*work)();
    };
    task.progress(0, "Place the cast");
    Result<void> done = builder.place(cast, labels, state);
    if (done)
        done = stage(0.15, "Lay out the cavities", &MoldBuilder::layOut);
    if (done)
        done = stage(0.25, "Fit the block", &MoldBuilder::fitBlock);
    if (done)
        done = stage(0.3, "Join the channels", &MoldBuilder::join);
    if (done)
        done = stage(0.5, "Build the halves", &MoldBuilder::assemble);
    if (done)
        done = stage(0.6, "Measure the steel", &MoldBuilder::measure);
    if (done)
        done = stage(0.7, "Prove the halves", &MoldBuilder::prove);
    if (!done)
        return std::unexpected(done.error());
    task.progress(1, "Prove the halves");
    return builder.mold();
}

Result<Eigen::Vector3d> blockSize(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                                  double draftDegrees, const MoldSettings& settings) {
    MoldBuilder builder(settings, draftDegrees);
    Result<void> done = builder.place(cast, labels, state);
    if (done)
        done = builder.layOut();
    if (done)
        done = builder.fitBlock();
    if (!done)
        return std::unexpected(done.error());
    return builder.block().sizes();
}

} // namespace moldwright
