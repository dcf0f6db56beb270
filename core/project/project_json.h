// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <nlohmann/json_fwd.hpp>

namespace moldwright {

/// All of a project but its meshes, labels and the faces of its important regions, as JSON (version 1 of the
/// project file). Doubles keep every bit.
[[nodiscard]] nlohmann::ordered_json documentJson(const Project& project);

/// Reads documentJson() back into `project`; `cast` receives what belongs to it, when the document has one.
/// Throws nlohmann::json::exception where a key is missing or of another kind.
void readDocument(const nlohmann::ordered_json& document, Project& project, std::optional<CastResult>& cast);

} // namespace moldwright
