// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "deformation/elastic_body.h"
#include "design/design.h"
#include "design/placed_pin.h"
#include "design/working_frame.h"

#include <vector>

namespace moldwright {

/// A part, unsplit, filled with tetrahedra in the plane's frame, and the points that pins hold.
struct WorkingBody {
    WorkingFrame frame;
    BodyShape shape;         ///< in `frame`; the part's points first
    int surfacePoints = 0;   ///< how many those are
    std::vector<int> pinned; ///< the point that each pin holds

    /// The shape at positions `X` of its points, in the part's frame; faces as in the part.
    [[nodiscard]] IndexedMesh surfaceAt(const Positions& X) const;
    /// Where the pins are at positions `X`, part frame, one a pin.
    [[nodiscard]] std::vector<PlacedPin> pinsAt(const Positions& X) const;
    /// Holds the point nearest to each pin (part frame, undeformed).
    void setPins(const std::vector<Pin>& pins);
};

/// Fills a part; `pins` that lie inside it, not just below the surface, become points of their own.
/// `faceWeights`: importance per face, empty: all 1. Errors: Worker, Cancelled.
[[nodiscard]] Result<WorkingBody> workingBody(const IndexedMesh& part, const MoldState& state,
                                              const std::vector<Pin>& pins,
                                              const std::vector<double>& faceWeights, const Task& task);

} // namespace moldwright
