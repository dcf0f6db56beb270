// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

enum class PinKind { Tip, Junction, Body };

/// A point of a part that may be worth pinning to the parting plane.
struct SuggestedPin {
    Eigen::Vector3d point = Eigen::Vector3d::Zero(); ///< mm, part frame; strictly inside the part
    double radius = 0;                               ///< mm, of a ball about it that lies inside the part
    PinKind kind = PinKind::Body;                    ///< end of a limb, where limbs meet, or neither
    double areaShare = 0;                            ///< of the surface, nearer to this pin than to any other
    double gain = 0; ///< share of the castability energy that goes when the pin's region is moved onto the
                     ///< plane; negative where that adds to it, 0 without a plane
    double rank = 0; ///< in [0, 1]: how much it is worth proposing
};

/// Suggested pins, and which part of the surface belongs to each.
struct PinSuggestions {
    std::vector<SuggestedPin> pins;
    std::vector<int> pinOfFace; ///< nearest pin of each face of the part; −1 where there is none at all
};

struct PinSearch {
    int count = 40; ///< pins at most; fewer where the shape has no more to offer
    unsigned seed = 1;
};

/// Points of the medial axis that stand for the part's shape: the axis, reduced to few balls [Li 2015], more
/// where these leave the surface far off, and the ends of limbs. Highest rank first, without a plane. Takes
/// about a second; turning, moving or scaling the part does the same to the pins. [Stein
/// 2019], Section 6.1. Precondition: closed, usable (see prepare()). Errors: Cancelled.
[[nodiscard]] Result<PinSuggestions> suggestPins(const IndexedMesh& part, const PinSearch& search,
                                                 const Task& task = {});

/// Sets gain and rank for a plane; the pins stay in their order. Takes milliseconds: for when the plane
/// moves.
void rankPins(PinSuggestions& suggestions, const IndexedMesh& part, const MoldState& state,
              double draftDegrees);

} // namespace moldwright
