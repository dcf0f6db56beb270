// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/height_field.h"

#include <array>
#include <vector>

namespace moldwright {

/// An edge where one half's solid ends.
struct OutlineEdge {
    std::size_t half = 0;
    HeightField::Vertex from;
    HeightField::Vertex to;
};

/// Those of both halves, in the order of their edges.
[[nodiscard]] std::vector<OutlineEdge> outlinesOf(const std::array<HeightField, 2>& halves);

/// Brings together what nearly touches: a point of one outline that lies within `near` of a point of the
/// other takes its place or gives it its own, one that lies within it of an edge is put onto the edge. So no
/// face of the parting plane gets thinner than it must. Points that both outlines have stay.
void matchOutlines(std::array<HeightField, 2>& halves, double near);

} // namespace moldwright
