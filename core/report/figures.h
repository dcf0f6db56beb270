// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <string>

namespace moldwright {

/// Numbers as a report prints them: a true minus, a thin space between thousands, a unit after a space.

/// `value` with this many decimals: "−0.2379", "12 400.5".
[[nodiscard]] std::string figure(double value, int decimals);

/// `value` rounded down to this many decimals: for what was proved.
[[nodiscard]] std::string figureRoundedDown(double value, int decimals);

/// "(0.1603, 0.1146, −0.9804)"
[[nodiscard]] std::string figures(const Eigen::Vector3d& v, int decimals);

/// Size in mm: "61.1 × 80.0 × 58.5 mm"
[[nodiscard]] std::string sizeInMillimetres(const Eigen::Vector3d& size);

/// A volume given in mm³, in cm³ with three significant digits or more: "54.2 cm³"
[[nodiscard]] std::string volumeInCm3(double mm3);

/// An area given in mm², in cm²: "23.7 cm²"
[[nodiscard]] std::string areaInCm2(double mm2);

} // namespace moldwright
