// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design.h"
#include "design/working_frame.h"
#include "mesh/indexed_mesh.h"

#include <vector>

namespace moldwright {

/// Why a parted mesh (in the working frame) can never be cast with these labels, however it is bent: one
/// entry for each piece of a side that fails the topological certificate, in words, with its place and size
/// in the part's frame.
[[nodiscard]] std::vector<Obstruction> findObstructions(const IndexedMesh& parted, const SideLabels& labels,
                                                        const WorkingFrame& frame);

/// "(1.5, -3, 0)", to a tenth of a millimetre: a place is to be found, not measured.
[[nodiscard]] std::string placeText(const Eigen::Vector3d& place);

} // namespace moldwright
