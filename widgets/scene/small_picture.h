// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/camera.h"
#include "scene/colours.h"
#include "scene/plane_handle.h"

#include <cstdint>
#include <span>
#include <vector>

namespace moldwright::scene {

/// A picture on a clear ground: rows from top to bottom; red, green, blue and opacity per pixel, not
/// premultiplied.
struct SmallPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// A surface with its parting plane, small, for a list to choose from. Drawn without graphics, so on any
/// thread and the same everywhere; 300,000 faces take about 50 ms. `faceColours` may be empty: all in the
/// part's colour. The camera is taken as it stands, without perspective.
[[nodiscard]] SmallPicture smallPicture(const IndexedMesh& mesh, std::span<const Rgb> faceColours,
                                        const PlaneRectangle& plane, const SceneColours& colours,
                                        const Camera& camera, int width, int height);

} // namespace moldwright::scene
