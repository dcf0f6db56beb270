// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold.h"

#include <string>
#include <vector>

namespace moldwright {

/// Lines of one kind in a drawing; mm.
struct DrawingLayer {
    std::string name;                                 ///< letters, digits and underscores: DXF asks for it
    std::vector<std::vector<Eigen::Vector2d>> curves; ///< closed: the last point joins the first
};

/// A flat drawing of a mold at scale 1:1.
struct Drawing {
    std::string title;
    std::vector<DrawingLayer> layers;
};

/// The parting plane seen from side 1, x to the right: the parting line of all that solidifies, and the faces
/// in which half 1 and half 2 end, with sockets, keys and slits.
[[nodiscard]] Drawing planDrawing(const Mold& mold);

/// Both halves and the cast cut upright through the first cavity: across x (`axis` 0; y to the right) or
/// across y (`axis` 1; x to the right), z up.
[[nodiscard]] Drawing sectionDrawing(const Mold& mold, int axis);

/// The drawing as SVG in millimetres, side 1 up.
[[nodiscard]] std::string svgOf(const Drawing& drawing);

/// The drawing as DXF (R12, millimetres): closed polylines on layers of these names.
[[nodiscard]] std::string dxfOf(const Drawing& drawing);

} // namespace moldwright
