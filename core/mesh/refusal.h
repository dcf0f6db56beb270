// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/check.h"

#include <string>
#include <vector>

namespace moldwright {

/// Why a mesh cannot be designed with, a sentence for each kind of fault, the gravest first: what, how many,
/// where. Empty when it is usable. `diagnosis` is of `mesh`; `name` is the file's.
[[nodiscard]] std::vector<Error> refusals(const IndexedMesh& mesh, const MeshDiagnosis& diagnosis,
                                          const std::string& name);

/// A surface with one side only, found at two neighbouring faces that cannot agree.
[[nodiscard]] Error oneSidedRefusal(const IndexedMesh& mesh, const std::vector<int>& faces,
                                    const std::string& name);

/// A refusal that points at faces of `mesh`, or at the points given.
[[nodiscard]] Error refusalAtFaces(const IndexedMesh& mesh, std::string text,
                                   std::vector<std::string> arguments, std::vector<int> faces);

} // namespace moldwright
