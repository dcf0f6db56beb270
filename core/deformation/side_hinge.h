// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "deformation/elastic_body.h"

#include <vector>

namespace moldwright {

/// Castability energy of a surface whose faces have fixed sides: ½ Σ_f a_f min(N_f·d_side(f) − τ, 0)². [Stein
/// 2019], Eq. (2), where the weights a_f need not be the current areas: with the areas at rest, shrinking a
/// bad face gains nothing, so that limbs turn instead.
struct SideHinge {
    const Triangles& F;
    const SideLabels& labels;
    Directions directions;
    double tau = 0;
    std::vector<double> weights; ///< a_f

    /// Energy at X; adds `factor` times its gradient to `gradient`.
    [[nodiscard]] double energy(const Positions& X, double factor, Positions& gradient) const;
};

/// How far the worst face is from its goal, and how many faces and how much area miss it.
struct SideDraft {
    double worstSine = 1; ///< smallest N·d
    int violating = 0;
    double violatingArea = 0;
};
[[nodiscard]] SideDraft sideDraft(const Triangles& F, const SideLabels& labels, const Directions& directions,
                                  const Positions& X, double tau);

/// The smallest rotation Q with (QN)·d ≥ τ: about N×d, or about any axis across d where N = −d. [Stein 2019],
/// Section 5.3. Identity where N·d ≥ τ already.
[[nodiscard]] Eigen::Quaterniond castableRotation(const Eigen::Vector3d& N, const Eigen::Vector3d& d,
                                                  double tau);

} // namespace moldwright
