// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

namespace moldwright::test {

/// A project in which everything is set to something that is not its default: a drafted box, moved, with a
/// cast, pins and weights.
Project someProject();

/// The same in three variants, the one in the middle current: the first two share a cast, the last has its
/// own.
Project someVariants();

/// These with further parts in their molds: the first variant has a ball, the current one that and a ring.
Project someTrays();

/// Equal in every value, meshes by content.
bool equal(const Variant& a, const Variant& b);
bool equal(const Project& a, const Project& b);

} // namespace moldwright::test
