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

/// The middle of a region as a surface shows it.
struct RegionPlace {
    int region = 0;
    Eigen::Vector3d place; ///< mm
};
/// Those of the regions that are not hidden; none while it is not known where they are.
[[nodiscard]] std::vector<RegionPlace> regionPlaces(const Workbench& bench, const ShownSurface& surface,
                                                    const Visibility& visible);

/// The region that a face of a surface belongs to: of those not hidden the one in which it weighs most; −1
/// for none.
[[nodiscard]] int regionAt(const Workbench& bench, const ShownSurface& surface, const Visibility& visible,
                           int face);

/// A chip with name and weight at each region that is not hidden.
[[nodiscard]] std::vector<scene::Chip> regionChips(const Workbench& bench, const ShownSurface& surface,
                                                   const Visibility& visible, const QString& selected);

} // namespace moldwright
