// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/elastic_body.h"

#include <vector>

namespace moldwright {

/// Keeps surface points on their side of the plane by construction: the height of each is |z| = φ(u) of a
/// free number u, with φ(u) = (u + √(u² + 4ε²))/2, which is u itself far from the plane and never reaches 0.
/// ε is a small share of the point's height at rest.
class SideHeights {
public:
    /// `side`: per point +1, −1, or 0 where the height is free or held. `rest`: heights |z| > 0 give ε.
    SideHeights(std::vector<signed char> side, const Positions& rest);

    /// Free numbers of positions: z replaced by u. Points must lie on their sides.
    [[nodiscard]] Positions toFree(Positions X) const;
    /// Positions of free numbers.
    [[nodiscard]] Positions toPositions(Positions U) const;
    /// Turns a gradient with respect to the positions of U into that with respect to U.
    void pullBack(const Positions& U, Positions& gradient) const;

private:
    std::vector<signed char> m_side;
    std::vector<double> m_epsilon;
};

} // namespace moldwright
