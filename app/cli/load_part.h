// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cli/session.h"
#include "mesh/check.h"

#include <filesystem>

namespace moldwright::cli {

/// Reads a mesh file and prepares it for a command; what was mended on the way is told to the person.
/// Errors: as readMesh() and prepare().
[[nodiscard]] Result<IndexedMesh> loadPart(const std::filesystem::path& file, const Session& session);

} // namespace moldwright::cli
