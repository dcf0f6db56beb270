// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace moldwright {

/// A variant's cast as the document tells it; its mesh and labels are parts of their own.
struct DescribedCast {
    std::optional<CastResult> own;     ///< none: the variant has no cast, or shares one
    std::optional<std::size_t> sameAs; ///< whose cast it is: 0 for the current variant, then the others
};

/// Whose cast an other variant (by its number among Project::others) has too, as DescribedCast::sameAs; none
/// where it is its own.
[[nodiscard]] std::optional<std::size_t> sharedCast(const Project& project, std::size_t other);

/// All of a project but meshes, labels and the faces of its important regions, as JSON (version 1 of the
/// project file). Doubles keep every bit. The current variant stands where files of old have the only one.
[[nodiscard]] nlohmann::ordered_json documentJson(const Project& project);

/// Reads documentJson() back into `project`; returns what belongs to the casts of the current variant and of
/// the others, in this order. Further parts have casts without mesh and labels, see further_parts_json.h.
/// Throws nlohmann::json::exception where a key is missing or of another kind.
[[nodiscard]] std::vector<DescribedCast> readDocument(const nlohmann::ordered_json& document,
                                                      Project& project);

} // namespace moldwright
