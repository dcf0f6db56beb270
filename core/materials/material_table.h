// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "materials/material.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// Where materials are kept: those that come with the program, and the user's own.
struct MaterialPlaces {
    std::filesystem::path bundled;            ///< a table
    std::optional<std::filesystem::path> own; ///< a folder of tables, *.json; it need not exist

    /// Beside the program, else in the source tree it was built from; and userFolder("materials").
    [[nodiscard]] static MaterialPlaces usual();
};

/// The bundled materials with the user's own, table by table in the order of their names. Errors: BadInput,
/// naming the file.
[[nodiscard]] Result<std::vector<Material>> materialTable(const MaterialPlaces& places);

/// The user's own alone. Errors: as above.
[[nodiscard]] Result<std::vector<Material>> ownMaterials(const MaterialPlaces& places);

/// Writes a material of the user's own: over the one with its id, in whichever table that is, else as a table
/// of its own, ID.json. What else stands in a table stays. Errors: Usage where its numbers cannot be right,
/// with the reason, or its id cannot be a file's name; BadInput; WriteFailed.
[[nodiscard]] Result<void> saveMaterial(const MaterialPlaces& places, const Material& material);

/// Forgets a material of the user's own; a bundled one of that id is there again. A table that holds nothing
/// more is removed. Errors: Usage where there is none; BadInput; WriteFailed.
[[nodiscard]] Result<void> removeMaterial(const MaterialPlaces& places, const std::string& id);

/// An id for a new material of this name: its letters and digits in lower case, with a number where `taken`
/// has that.
[[nodiscard]] std::string freeMaterialId(const std::string& name, const std::vector<Material>& taken);

} // namespace moldwright
