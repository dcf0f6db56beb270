// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/choice_mesh.h"

#include <functional>

namespace moldwright {

/// A plane x·normal = offset; unit normal.
struct DividingPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double offset = 0;
    std::uint8_t label = 0; ///< of the faces in it; 0: it is the parting plane, where they have that of the
                            ///< side they look at
};

/// Whether a cut between two regions may stay.
using CutCheck = std::function<bool(const ChoiceMesh& choices, int region, int beyond)>;

/// Divides a region by a plane: the part of its space beyond it becomes the last region. Faces are cut along
/// the plane. Returns false, with nothing changed, where the plane does not cut the space into two clean
/// parts, or `check` is against it.
bool divideRegion(ChoiceMesh& choices, int region, const DividingPlane& plane, const CutCheck& check = {});

} // namespace moldwright
