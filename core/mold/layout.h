// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "features/plan_shape.h"
#include "mesh/indexed_mesh.h"
#include "mold/gates.h"
#include "mold/mold_settings.h"

#include <vector>

namespace moldwright {

/// One shape of cavity, centred where it was placed; copies of it are moved by multiples of 1/16 mm, so they
/// are the same to the bit.
struct CavityKind {
    IndexedMesh cast; ///< mold's frame, on the grid
    SideLabels labels;
    PlanShape hull;                      ///< round all of it, seen along the plane's normal
    std::vector<CavityOutline> outlines; ///< its parting curves
    bool mirrored = false;               ///< the opposite-handed part
};

/// A cavity: which kind, and where.
struct CavityCopy {
    std::size_t kind = 0;
    int row = 0;
    int column = 0;
    Eigen::Vector2d offset = Eigen::Vector2d::Zero(); ///< mm; multiples of 1/16
};

/// The cast as it is and, where every second one is to be another, that one. A copy placed by a turn R is
/// allowed exactly when the cast leaves along R⁻¹d1 and R⁻¹d2. Errors: Impossible, with the draft it would
/// have.
[[nodiscard]] Result<std::vector<CavityKind>> cavityKinds(const IndexedMesh& cast, const SideLabels& labels,
                                                          const Directions& directions, double draftDegrees,
                                                          double grid, Alternation alternation);

/// Room that runners take in a layout, mm; zero without.
struct RunnerRoom {
    double row = 0;  ///< between a row of cavities and the next: the runner that feeds it
    double main = 0; ///< beside a column: the one that feeds the runners
};

/// Where the cavities stand, the middle of all over the origin; row 0 lowest, column 0 leftmost. With runners
/// a row's cavities hang below theirs, and the main runner passes before column `mainColumn`.
struct Layout {
    std::vector<CavityCopy> copies;
    int mainColumn = 0;
    double mainAxis = 0;            ///< mm, x of the main runner
    std::vector<double> runnerAxes; ///< mm, y of the runner over each row
    double runnerOverKind = 0;      ///< mm, y of a row's runner less that of its cavities' offset
};
[[nodiscard]] Layout layoutOf(const std::vector<CavityKind>& kinds, const LayoutSettings& settings,
                              const RunnerRoom& room);

/// A length as the next multiple of 1/16 mm.
[[nodiscard]] double upToSixteenth(double length);

} // namespace moldwright
