// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "project/project.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moldwright {

/// The variants of a project stand in one order, counted from 0; the current one is at Project::place. There
/// is always one. Names are all different.

[[nodiscard]] std::size_t variantCount(const Project& project);
[[nodiscard]] const Variant& variantAt(const Project& project, std::size_t number);
[[nodiscard]] std::optional<std::size_t> variantNamed(const Project& project, std::string_view name);
/// The project with the variant of this name as the current one; an empty name: as it is. Errors: Usage,
/// naming the file and its variants.
[[nodiscard]] Result<Project> atVariant(Project project, const std::string& name,
                                        const std::string& fileName);
/// What a variant's mold is built for: its cast, then its further parts. Without a cast the first has none,
/// and nothing can be built. `name`: of the part.
[[nodiscard]] Tray trayOf(const Variant& variant, const std::string& name);
/// Joined by commas, for sentences.
[[nodiscard]] std::string variantNames(const Project& project);

/// The first of A, B, …, Z, A2, B2, … that no variant has.
[[nodiscard]] std::string freeVariantName(const Project& project);

/// Edits: pure functions, see edits.h. Numbers are those of variants that there are.

/// Another variant becomes the current one.
[[nodiscard]] Project withVariant(Project project, std::size_t number);

/// A copy of a variant, with its cast, comes after it and becomes the current one, under a free name.
[[nodiscard]] Project withDuplicate(Project project, std::size_t number);

/// A variant with the current one's settings, those of its mold with its further parts too, and nothing else
/// comes last and becomes the current one: no pins, no regions, no cast. The plane is kept as a place to
/// begin at, open to the run's search.
[[nodiscard]] Project withFreshVariant(Project project);

/// Without a variant; where it was the current one, the next becomes that, or the one before the last. The
/// only one stays.
[[nodiscard]] Project withoutVariant(Project project, std::size_t number);

/// Blanks at both ends are dropped; a name that is empty or another's changes nothing.
[[nodiscard]] Project withVariantName(Project project, std::size_t number, std::string_view name);

} // namespace moldwright
