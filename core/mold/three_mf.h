// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace moldwright {

/// A named solid of a 3MF file and where it stands on the build plate. Coordinates in mm, floats.
struct PlateItem {
    std::string name;
    SharedMesh mesh;
    Eigen::Isometry3d placement = Eigen::Isometry3d::Identity(); ///< mesh's frame to the plate
};

/// The bytes of a 3MF file with these solids, unit millimetre. Written by lib3mf, in memory. Errors:
/// Internal when lib3mf refuses.
[[nodiscard]] Result<std::string> threeMfBytes(const std::string& title, const std::vector<PlateItem>& items);

} // namespace moldwright
