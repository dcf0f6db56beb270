// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/fill.h"

namespace moldwright {

/// Turns edges of triangles that are all but a line: one that reaches less than `flat` above its longest edge
/// gives its middle point to the neighbour there. The surface moves by no more than that; points and the
/// parting line stay.
void flipCaps(FilledPart& part, double flat);

} // namespace moldwright
