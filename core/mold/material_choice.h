// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "mold/mold_settings.h"

#include <vector>

namespace moldwright {

/// Settings with what a material asks of the mold: shrink along all axes and its formula, density, and the
/// depth of vents in the parting plane where it has one (else none that the material before had asked for).
[[nodiscard]] MoldSettings withMaterial(MoldSettings settings, const Material& material);

/// Settings that no longer say whose values they hold; these stay.
[[nodiscard]] MoldSettings withoutMaterial(MoldSettings settings);

/// A value that the chosen material names.
struct MaterialSetting {
    const char* name = ""; ///< English, for people
    const char* unit = "";
    MaterialValue of;     ///< the material's
    double set = 0;       ///< as the settings have it
    bool isTaken = false; ///< the settings have the material's
};

/// The settings that the chosen material speaks for: shrink, density, depth of vents where there are
/// any; none without a material.
[[nodiscard]] std::vector<MaterialSetting> materialSettings(const MoldSettings& settings);

/// What to know of the chosen material: where its values come from, which of them are set otherwise, that the
/// cast has less draft than is usual, and how the mold is prepared. None without a material.
[[nodiscard]] std::vector<Message> materialNotes(const MoldSettings& settings, double draftDegrees);

} // namespace moldwright
