// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/contact_ways.h"
#include "scene/overlay.h"
#include "window/display_mode.h"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace moldwright {

class Workbench;
struct FaceMap;
struct ShownSurface;

/// How the faces of a surface are painted in a mode; `map`: the newest there is, null for none. Empty: they
/// stay as they are.
struct FacePaint {
    std::vector<scene::Rgb> faces;
    std::vector<scene::Rgb> standIn; ///< of its stand-in
};
[[nodiscard]] FacePaint paintFor(const ShownSurface& surface, DisplayMode mode, const FaceMap* map);

/// Paints the faces that reach into a box, so that a place can be pointed at.
void pointAt(FacePaint& paint, const ShownSurface& surface, const Eigen::AlignedBox3d& place);

/// What the colours mean, with units, and the area of each class.
[[nodiscard]] scene::PanelContent legendFor(const Workbench& bench, const ShownSurface& surface,
                                            DisplayMode mode, const FaceMap* map);

/// The same for a mold that opens: nothing where its halves meet nothing of the cast.
[[nodiscard]] scene::PanelContent contactLegend(const std::array<ContactWays, 2>& contacts);

/// A value of a map with its name and unit: "Deviation 1.23 mm".
[[nodiscard]] QString mapValueText(const FaceMap& map, double value);

/// A chip at the largest value of a map; none where nothing is above 0.
[[nodiscard]] std::optional<scene::Chip> largestOf(const FaceMap& map);

} // namespace moldwright
