// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design.h"

namespace moldwright::cli {

/// A design, and what was asked for in the end.
struct AutoPinned {
    DesignRequest request; ///< with the pins that were taken, none where they did not help
    DesignResult result;
};

/// Designs without pins, then at the same plane with those suggested ends of limbs pinned that the plane
/// gains by, and keeps the latter if it is castable and gives up no more of the part. Errors: those of
/// design().
[[nodiscard]] Result<AutoPinned> designWithTips(const DesignRequest& request, const Task& task,
                                                const FrameSink& frames);

} // namespace moldwright::cli
