// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "mesh/measures.h"

#include <vector>

namespace moldwright {

/// Signed volume of each component, mm³. Precondition: every component is closed.
[[nodiscard]] std::vector<double> componentVolumes(const IndexedMesh& mesh, const Components& components);

/// Components that lie inside another one, in ascending order, whichever way either is turned. Precondition:
/// every component is closed and oriented in itself, and none crosses another.
[[nodiscard]] std::vector<int> componentsInsideOthers(const IndexedMesh& mesh, const Components& components);

} // namespace moldwright
