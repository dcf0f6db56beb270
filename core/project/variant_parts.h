// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/archive.h"
#include "project/part_source.h"
#include "project/project.h"
#include "project/project_json.h"

#include <vector>

namespace moldwright {

/// The binary parts of variants in a project file: faces and weights of their important regions, their
/// casts, and those of the further parts of their molds ("further-cast-1.mesh"). The current one's names are
/// bare ("cast.mesh"), those of the first of the others begin with "variant-1-", and so on. A cast that
/// several variants share is there once.

void addVariantParts(std::vector<ArchiveEntry>& entries, const Project& project);

/// Reads what belongs to the variants of a document. `casts` is what it tells of theirs. Errors: BadInput,
/// naming the part.
[[nodiscard]] Result<void> readVariantParts(const PartSource& parts, std::vector<DescribedCast> casts,
                                            Project& project);

} // namespace moldwright
