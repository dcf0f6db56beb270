// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <cstddef>

namespace moldwright::test {

/// Of all that a document holds: what its file would tell, and the meshes and casts of all variants to the
/// bit.
[[nodiscard]] std::size_t hashOf(const Project& project);

} // namespace moldwright::test
