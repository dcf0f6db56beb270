// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design.h"

#include <algorithm>

namespace moldwright {

inline constexpr double kLimbLength = 0.85; ///< share of its length that a limb keeps, or it counts as lost
inline constexpr double kLimbVolume = 0.75; ///< share of its volume
inline constexpr double kStrainKept = 1;    ///< rms strain above which nothing of the part's form is left
inline constexpr double kStrainFree = 0.2;  ///< rms strain that hardly shows
inline constexpr double kStrainPrice = 0.5; ///< shares of the volume filled that rms strain above it weighs

/// By how much a limb fell short of what it is to keep.
[[nodiscard]] inline double missing(const LimbMeasure& limb) {
    return std::max(0.0, kLimbLength - limb.lengthRatio) + std::max(0.0, kLimbVolume - limb.volumeRatio);
}

/// The same of all limbs, summed; 0: all kept.
[[nodiscard]] inline double limbsLost(const DesignResult& result) {
    double lost = 0;
    for (const LimbMeasure& limb : result.limbs)
        lost += missing(limb);
    return lost;
}

/// By how much the part itself, filling aside, fell short of the volume that a limb is to keep.
[[nodiscard]] inline double volumeLost(const DesignResult& result) {
    const double kept = result.change.volumeRatio / (1 + result.change.filledVolumeFraction);
    return std::max(0.0, kLimbVolume - kept);
}

/// What bending has taken from the part: limbs, volume, and its form where it was stretched beyond all
/// measure, as a cup is that is turned inside out.
[[nodiscard]] inline double bentAway(const DesignResult& result) {
    return limbsLost(result) + volumeLost(result) + std::max(0.0, result.strain.rms - kStrainKept);
}

/// What the part has given up, to compare ways by: what bending took and how far it went, and the share of
/// the part's volume that filling buries it under.
[[nodiscard]] inline double givenUp(const DesignResult& result) {
    return bentAway(result) + kStrainPrice * std::max(0.0, result.strain.rms - kStrainFree) +
           result.change.filledVolumeFraction;
}

} // namespace moldwright
