// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design_run.h"
#include "design/filling.h"

#include <memory>
#include <optional>
#include <vector>

namespace moldwright {

/// By what a part is bent: the coarser, the sooner.
enum class Means { QuickProxy, FineProxy, Itself };

/// What is done at one state: the part as it is or filled first, then bent.
struct Attempt {
    const IndexedMesh* shape;
    MoldState state;
    std::optional<Filling> fill;
    Means means = Means::QuickProxy;
    std::vector<PlacedPin> pins{}; ///< of shape, part frame
    /// Made by the first of the means, the same for all.
    std::shared_ptr<const PartedPart> parted{};
};

/// Parts the part at the attempt's state, fills and bends it, finishes, rounds and proves the result, and
/// measures what has changed. Keeps the parted part in the attempt. Bends by a stand-in where that is meant
/// and there is one, otherwise the part's own tetrahedra. Errors: as of partSurface(), filledSurface() and
/// tetrahedralize(); Impossible where filling would join pieces that are apart; Cancelled.
[[nodiscard]] Result<DesignResult> tryAttempt(Attempt& attempt, const Task& task, DesignRun& run);

} // namespace moldwright
