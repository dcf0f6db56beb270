// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/fill.h"

namespace moldwright {

/// Collapses edges shorter than `shortest` into one of their ends: points that filling made go, those of the
/// part stay. The parting line stays simple and where it is; no face turns over.
void collapseShortEdges(FilledPart& part, double shortest);

} // namespace moldwright
