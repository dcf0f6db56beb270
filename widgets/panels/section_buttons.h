// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/property_panel.h"

class QVBoxLayout;

namespace moldwright {

/// Adds the buttons of a section below what is laid out: two side by side where `width` (logical pixels) has
/// room for both. They show what their actions say.
void addSectionButtons(const PropertySection& section, int width, QWidget* parent, QVBoxLayout* column);

} // namespace moldwright
