// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/contact_paint.h"

namespace moldwright::scene {

std::vector<Rgb> ContactPaint::painted(std::vector<Rgb> wanted, const std::array<double, 2>& ways, Rgb red) {
    m_facesMet = 0;
    if (!any())
        return wanted;
    for (std::size_t f = 0; f < wanted.size(); ++f)
        if (m_contacts[0].touches(f, ways[0]) || m_contacts[1].touches(f, ways[1])) {
            wanted[f] = red;
            ++m_facesMet;
        }
    return wanted;
}

} // namespace moldwright::scene
