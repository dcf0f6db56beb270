// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "castability/analysis.h"
#include "project/project.h"

#include <memory>
#include <optional>

namespace moldwright {

/// All that follows from a project: never saved, never undone, made again when the project changed.
struct Evaluation {
    std::optional<DraftAnalysis> part; ///< of the part in the project's mold state; none without a state
    std::optional<DraftAnalysis> cast; ///< of the cast, its faces as in the project; none without one
    std::shared_ptr<const Mold> mold;  ///< none without a cast, or when it could not be built
    std::optional<Error> moldFailure;  ///< why it could not
};

/// Evaluates a project: window, command line and report share this, so all numbers come from one place.
/// Errors: Cancelled.
[[nodiscard]] Result<Evaluation> evaluate(const Project& project, const Task& task = {});

} // namespace moldwright
