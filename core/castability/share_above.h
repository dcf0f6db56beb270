// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace moldwright {

/// How a triangle is parted, from the heights of its corners: what partArea() does, without branches, for
/// loops that become vector code.
struct LaneShare {
    double share;  ///< of the area above
    double t;      ///< share of the triangle that the lone corner cuts off
    double lone;   ///< height of the corner that is alone on its side
    bool oneAbove; ///< whether that is above
    bool above;    ///< anything above
    bool crosses;  ///< anything on either side
};

/// `upright` is N·n: decides for a triangle wholly in the plane.
[[nodiscard]] [[gnu::always_inline]] inline LaneShare shareAbove(double s0, double s1, double s2,
                                                                 double upright) {
    const double small = s0 < s1 ? s0 : s1;
    const double large = s0 < s1 ? s1 : s0;
    const double low = s2 < small ? s2 : small;
    const double high = s2 < large ? large : s2;
    const double rest = s2 < large ? s2 : large;
    const double middle = s2 < small ? small : rest;
    const bool oneAbove = middle <= 0;
    const double lone = oneAbove ? high : low;
    const double other = oneAbove ? low : high;
    const double t = lone * lone / ((lone - other) * (lone - middle));
    const bool above = high > 0;
    const bool below = low < 0;
    const bool crosses = above & below;
    const double flat = upright > 0 ? 1.0 : 0.0;
    const double whole = above ? 1.0 : (below ? 0.0 : flat);
    const double parted = oneAbove ? t : 1 - t;
    return {crosses ? parted : whole, t, lone, oneAbove, above, crosses};
}

} // namespace moldwright
