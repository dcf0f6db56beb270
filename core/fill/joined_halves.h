// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/parting_line.h"
#include "fill/height_field.h"
#include "fill/projected_half.h"

#include <array>

namespace moldwright {

/// Joins two filled halves in the parting plane to one closed mesh in the plane's frame: tops, walls, and
/// where only one half is solid a flat face of the other side, on which it rests. sourceFace: the face of the
/// parted mesh a top shows, −1 for the rest. Points on the outlines are added to the fields where the
/// outlines cross.
[[nodiscard]] PartedMesh joinHalves(std::array<HeightField, 2>& halves, const ShadowGrid& grid);

} // namespace moldwright
