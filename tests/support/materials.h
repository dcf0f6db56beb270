// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "materials/material.h"

#include <string>

namespace moldwright::test {

/// A material of that name that nothing else is known of.
inline Material materialCalled(const std::string& name) {
    Material material;
    material.id = name;
    material.name = name;
    return material;
}

} // namespace moldwright::test
