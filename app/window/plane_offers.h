// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/plane_search.h"
#include "project/project.h"
#include "scene/small_picture.h"

#include <vector>

namespace moldwright {

/// A parting plane that a search offers, with a picture of the part at it, undercuts red.
struct OfferedPlane {
    PlaneCandidate plane;
    scene::SmallPicture picture;
};

/// The best distinct planes at which the part can be bent to castable, best first; where there is none, the
/// best ones all the same. Seconds; a stopped task ends with what was found.
[[nodiscard]] std::vector<OfferedPlane> offerPlanes(const IndexedMesh& part, const DesignSettings& settings,
                                                    const scene::SceneColours& colours, const Task& task);

} // namespace moldwright
