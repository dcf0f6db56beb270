// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "castability/certificate.h"

namespace moldwright {

/// Draft of a cast whose parting line is inserted: each face against the direction of its own side, so that
/// points rounded off the plane by an ulp make no slivers on the wrong side. Which faces violate is taken
/// from the certificate, where it was decided exactly. Without undercut regions. O(m).
[[nodiscard]] DraftAnalysis analyzeCast(const IndexedMesh& cast, const SideLabels& labels,
                                        const MoldState& state, double draftDegrees,
                                        const Certificate& certificate);

/// The same in floating point, for a shape on its way: no certificate is needed. O(m).
[[nodiscard]] DraftAnalysis analyzeCast(const IndexedMesh& cast, const SideLabels& labels,
                                        const MoldState& state, double draftDegrees);

} // namespace moldwright
