// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "features/plan_shape.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace moldwright {

/// The width of a stroke, of the height of a capital.
inline constexpr double strokeOfHeight = 1.0 / 7;

/// Lettering whose strokes do not touch each other, as stencils have it: each is a groove of its own, and
/// nothing has to be united. Between strokes 0.6 of their width stays at least.
struct StencilText {
    std::vector<PlanShape> strokes; ///< outlines, counter-clockwise, mm
    Eigen::AlignedBox2d box;        ///< about all of them
};

/// Lines of text below each other, their middles one above the other; height: of a capital, mm. There are
/// A–Z, 0–9, space, - . , : / % ° # + ( ) and Western letters with marks; small letters become capitals.
/// Errors: Usage, for another character, with its name.
[[nodiscard]] Result<StencilText> stencilText(const std::vector<std::string>& lines, double height);

/// The outline of a line of this width, its ends cut square; corners are mitred, sharp ones cut off.
[[nodiscard]] PlanShape strokeOutline(const PlanShape& line, double width);

} // namespace moldwright
