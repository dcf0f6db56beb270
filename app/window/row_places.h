// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <Eigen/Geometry>

namespace moldwright {

class Workbench;

/// A box about what a row of the project's tree stands for, in the part's frame, mm; empty where that has no
/// place of its own.
[[nodiscard]] Eigen::AlignedBox3d placeOfRow(const QString& id, const Workbench& bench);

} // namespace moldwright
