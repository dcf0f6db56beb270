// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/mold_fields.h"

namespace moldwright {

/// The sections that mold_fields.h puts together.

[[nodiscard]] MoldFieldSection blockFields();
[[nodiscard]] MoldFieldSection cavityFields();
[[nodiscard]] MoldFieldSection shrinkFields();
[[nodiscard]] MoldFieldSection machineFields();
[[nodiscard]] MoldFieldSection fillingFields();
[[nodiscard]] MoldFieldSection tiltFields();
[[nodiscard]] MoldFieldSection closingFields();
[[nodiscard]] MoldFieldSection plaqueFields();

} // namespace moldwright
