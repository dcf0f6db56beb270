// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/tray.h"
#include "project/project.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <vector>

namespace moldwright {

/// The further parts of molds in a project file's document: "further_casts", each once however many variants
/// have it, and in each variant "further_parts". Files without them have none.

using SharedCast = std::shared_ptr<const CertifiedCast>;

/// The casts of all further parts of a project, in the order in which its current variant and then the
/// others name them, each once.
[[nodiscard]] std::vector<SharedCast> furtherCasts(const Project& project);

/// Adds them to documentJson().
void addFurtherParts(nlohmann::ordered_json& document, const Project& project);

/// Reads them back into the variants of `project`, which are read already. Their casts have a state, and no
/// mesh and labels yet. Throws nlohmann::json::exception where a key is missing or of another kind, a count
/// is none that a mold can have, or a cast is not there.
void readFurtherParts(const nlohmann::ordered_json& document, Project& project);

} // namespace moldwright
