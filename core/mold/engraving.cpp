// SPDX-License-Identifier: AGPL-3.0-or-later
// The builder's stage that letters the backs of the halves.
#include "mold/mold_builder.h"

#include <algorithm>

namespace moldwright {

using Eigen::Vector2d;

/// What opens into a half's back, and what comes so near to it that no letter may stand over it.
Obstacles MoldBuilder::openingsInBack(int side) const {
    const MoldSettings& settings = m_mold.settings;
    Obstacles openings = m_bolts;
    for (const CavityCopy& copy : m_layout.copies)
        for (const OutwardHole& hole : outwardHoles(copy))
            if (hole.side == side)
                openings.push_back(
                    planCircle(mouthOf(hole, m_block.end(side)).head<2>(), hole.radius, circleCorners));
    const double reach = std::abs(m_block.end(side)) - settings.plaque.depth - settings.leastSteel;
    const std::size_t i = side == 1 ? 0 : 1;
    for (const InsertPocket& pocket : m_pockets)
        if (pocket.prism.height[i] > reach)
            openings.push_back(pocket.prism.base);
    for (const RegistrationKey& key : m_keys)
        if (key.socket.height[i] > reach)
            openings.push_back(key.socket.base);
    return openings;
}

Result<void> MoldBuilder::engrave() {
    const MoldSettings& settings = m_mold.settings;
    const bool blank = settings.plaque.text.find_first_not_of(" |") == std::string::npos;
    for (const int side : {1, 2}) {
        if (blank)
            break;
        Result<Plaque> plaque = plaqueOn(settings.plaque, plaqueLines(settings.plaque, settings.shrink, side),
                                         side, m_block, openingsInBack(side),
                                         side == 1 ? settings.ceiling : settings.floor, settings.leastSteel);
        if (!plaque)
            return std::unexpected(plaque.error());
        m_plaques.push_back(*std::move(plaque));
    }
    return {};
}

} // namespace moldwright
