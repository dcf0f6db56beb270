// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "materials/material.h"

namespace moldwright::cli {

/// The bundled materials and the user's own, which are the JSON files in
/// $XDG_CONFIG_HOME/moldwright/materials
/// (~/.config without that), in the order of their names. Errors: BadInput, naming the file.
[[nodiscard]] Result<std::vector<Material>> materialTable();

} // namespace moldwright::cli
