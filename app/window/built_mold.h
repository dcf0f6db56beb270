// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/contact_ways.h"
#include "mold/mold.h"
#include "project/project.h"
#include "scene/drawn_mesh.h"

#include <array>
#include <memory>

namespace moldwright {

/// A mold, and what it was built from.
struct BuiltMold {
    std::shared_ptr<const Mold> mold;
    std::array<scene::SharedDrawnMesh, 2> halves;
    std::array<ContactWays, 2> contacts; ///< of the halves with the cast, on their way out
    Tray tray;
    MoldSettings settings;
};

} // namespace moldwright
