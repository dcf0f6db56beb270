// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// Binary parts of a project file, little-endian: a count (or two) as 64-bit integers, then the values.
/// Reading gives none when lengths do not fit, an index points nowhere, or a number is not finite.

[[nodiscard]] std::string meshPart(const IndexedMesh& mesh); ///< n, m, n×3 doubles, m×3 32-bit integers
[[nodiscard]] std::optional<IndexedMesh> readMeshPart(const std::string& bytes);

[[nodiscard]] std::string labelsPart(const SideLabels& labels); ///< m, m bytes
[[nodiscard]] std::optional<SideLabels> readLabelsPart(const std::string& bytes);

[[nodiscard]] std::string numbersPart(const std::vector<double>& numbers); ///< n, n doubles
[[nodiscard]] std::optional<std::vector<double>> readNumbersPart(const std::string& bytes);

[[nodiscard]] std::string indicesPart(const std::vector<int>& indices); ///< n, n 32-bit integers
/// None too where they do not ascend, or one is not below `end`.
[[nodiscard]] std::optional<std::vector<int>> readIndicesPart(const std::string& bytes, int end);

} // namespace moldwright
