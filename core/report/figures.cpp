// SPDX-License-Identifier: AGPL-3.0-or-later
#include "report/figures.h"

#include <cmath>
#include <cstdio>

namespace moldwright {

namespace {

constexpr const char* minus = "\u2212";
constexpr const char* thinSpace = "\u2009";

/// Decimals that show three significant digits of a small value and at least one digit of a large one.
int decimalsFor(double value) {
    const double size = std::abs(value);
    return size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
}

} // namespace

std::string figure(double value, int decimals) {
    char digits[400];
    std::snprintf(digits, sizeof digits, "%.*f", decimals, std::abs(value));
    const std::string plain = digits;
    const std::size_t whole = std::min(plain.find('.'), plain.size());
    std::string grouped;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        if (i > 0 && i < whole && (whole - i) % 3 == 0)
            grouped += thinSpace;
        grouped += plain[i];
    }
    const bool zero = plain.find_first_not_of("0.") == std::string::npos;
    return value < 0 && !zero ? minus + grouped : grouped;
}

std::string figureRoundedDown(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    return figure(std::floor(value * scale) / scale, decimals);
}

std::string figures(const Eigen::Vector3d& v, int decimals) {
    return "(" + figure(v.x(), decimals) + ", " + figure(v.y(), decimals) + ", " + figure(v.z(), decimals) +
           ")";
}

std::string sizeInMillimetres(const Eigen::Vector3d& size) {
    return figure(size.x(), 1) + " × " + figure(size.y(), 1) + " × " + figure(size.z(), 1) + " mm";
}

std::string volumeInCm3(double mm3) {
    return figure(mm3 / 1000, decimalsFor(mm3 / 1000)) + " cm³";
}

std::string areaInCm2(double mm2) {
    return figure(mm2 / 100, decimalsFor(mm2 / 100)) + " cm²";
}

} // namespace moldwright
