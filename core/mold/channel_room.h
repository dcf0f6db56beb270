// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/cavity_joints.h"

#include <optional>

namespace moldwright {

/// Where a vent in the parting plane begins, the kind's coordinates, mm: the trap's highest point of the
/// parting line, or by hand the line's highest over the place. None where the trap does not reach the plane.
[[nodiscard]] std::optional<Eigen::Vector2d> topInPlane(const CavityKind& kind, const VentedTrap& vented,
                                                        const Eigen::Vector3d& up);

/// Half a gate's width, and as far aside as it may be joined, mm.
[[nodiscard]] double halfRoom(const Gate& gate);

/// A gate from its end in the cavity to the parting line and as far beyond, as far aside as it may be joined;
/// where a cavity is pointed it stands out on both sides. The kind's coordinates.
[[nodiscard]] PlanShape gateFoot(const CavityKind& kind, const Gate& gate);

/// A strip along the kind's inlet from a place of the parting line to `end` along the inlet, mm.
[[nodiscard]] PlanShape wayFrom(const CavityKind& kind, const Eigen::Vector2d& place, double half,
                                double end);

} // namespace moldwright
