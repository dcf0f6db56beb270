// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/overlay.h"
#include "window/face_paint.h"

#include <vector>

namespace moldwright {

class Workbench;
struct ShownSurface;
struct Visibility;

/// How the faces of a surface show importance: they darken with the weight of the part's faces that they are
/// or were, those of regions that are hidden excepted.
[[nodiscard]] FacePaint importancePaint(const Workbench& bench, const ShownSurface& surface,
                                        const Visibility& visible);

/// The weights and their areas.
[[nodiscard]] scene::PanelContent importanceLegend(const Workbench& bench, const ShownSurface& surface,
                                                   const Visibility& visible);

/// A chip with name and weight at each region that is not hidden.
[[nodiscard]] std::vector<scene::Chip> regionChips(const Workbench& bench, const ShownSurface& surface,
                                                   const Visibility& visible, const QString& selected);

} // namespace moldwright
