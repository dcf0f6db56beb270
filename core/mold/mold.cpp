// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold.h"

#include "base/stop_point.h"
#include "mold/mold_builder.h"

#include <array>
#include <optional>

namespace moldwright {

namespace {

struct Stage {
    double at;
    const char* name;
    Result<void> (MoldBuilder::*work)();
};

/// After the cast was placed. A mold's block is known after the first six.
constexpr std::array stages = {
    Stage{0.15, "Lay out the cavities", &MoldBuilder::makeKinds},
    Stage{0.16, "Look where air stays", &MoldBuilder::findTilt},
    Stage{0.2, "Lay out the cavities", &MoldBuilder::layOut},
    Stage{0.2, "Lay out the cavities", &MoldBuilder::findEntries},
    Stage{0.24, "Lay out the cavities", &MoldBuilder::findOverflows},
    Stage{0.25, "Fit the block", &MoldBuilder::fitBlock},
    Stage{0.26, "Look where air stays", &MoldBuilder::tellOfTilt},
    Stage{0.3, "Join the channels", &MoldBuilder::join},
    Stage{0.5, "Measure the steel", &MoldBuilder::measureSteel},
    Stage{0.55, "Measure the steel", &MoldBuilder::refuseCollisions},
    Stage{0.55, "Build the halves", &MoldBuilder::assemble},
    Stage{0.65, "Build the halves", &MoldBuilder::measure},
    Stage{0.7, "Prove the halves", &MoldBuilder::prove},
};
constexpr std::size_t untilBlock = 6;

Result<Mold> moldByStages(const Tray& tray, double draftDegrees, const MoldSettings& settings,
                          const Task& task) {
    MoldBuilder builder(settings, draftDegrees);
    task.progress(0, "Place the cast");
    Result<void> done = builder.place(tray);
    for (const Stage& stage : stages) {
        if (!done)
            return std::unexpected(done.error());
        stopPoint();
        task.progress(stage.at, stage.name);
        done = (builder.*stage.work)();
    }
    if (!done)
        return std::unexpected(done.error());
    stopPoint();
    task.progress(1, "Prove the halves");
    return builder.mold();
}

} // namespace

Result<Mold> buildMold(const Tray& tray, double draftDegrees, const MoldSettings& settings,
                       const Task& task) {
    std::optional<Result<Mold>> built =
        unlessStopped(task, [&] { return moldByStages(tray, draftDegrees, settings, task); });
    if (!built)
        return failure(ErrorCode::Cancelled, MW_TEXT("Mold", "Building the mold was cancelled."));
    return *std::move(built);
}

Result<Eigen::Vector3d> blockSize(const Tray& tray, double draftDegrees, const MoldSettings& settings) {
    MoldBuilder builder(settings, draftDegrees);
    Result<void> done = builder.place(tray);
    for (std::size_t i = 0; i < untilBlock && done; ++i)
        done = (builder.*stages.at(i).work)();
    if (!done)
        return std::unexpected(done.error());
    return builder.block().box().sizes();
}

} // namespace moldwright
