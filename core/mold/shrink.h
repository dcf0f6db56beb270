// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "mold/mold_settings.h"

namespace moldwright {

/// The factor that makes up for `percent` of linear shrink: 1 + S or 1/(1 − S). Precondition: percent < 100.
[[nodiscard]] double shrinkFactor(double percent, ShrinkFormula formula);

/// A place of the part where shrink is made up for, mm: `origin` stays.
[[nodiscard]] inline Eigen::Vector3d madeLarger(const Eigen::Vector3d& place, const Eigen::Vector3d& factors,
                                                const Eigen::Vector3d& origin) {
    return origin + factors.cwiseProduct(place - origin);
}

/// A cast with the plane and directions that it is castable in.
struct CompensatedCast {
    IndexedMesh mesh;
    MoldState state;
    Eigen::Vector3d factors = Eigen::Vector3d::Ones();
};

/// The cast made larger about the origin. Factors that differ between the axes, A = diag(sx, sy, sz), turn
/// normals too: plane A⁻ᵀn, directions A·d, made unit again; the draft must be proved anew. Errors: Usage (a
/// shrink of −50 % or below, or 50 % or above, is a mistake).
[[nodiscard]] Result<CompensatedCast> compensated(const IndexedMesh& cast, const MoldState& state,
                                                  const ShrinkSettings& shrink);

} // namespace moldwright
