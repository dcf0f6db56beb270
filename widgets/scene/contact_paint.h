// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/contact_ways.h"
#include "scene/colours.h"

#include <array>
#include <vector>

namespace moldwright::scene {

/// The colours of a surface that mold halves leave: red where one meets it on its way.
class ContactPaint {
public:
    /// What halves 1 and 2 meet of the surface.
    void setContacts(const std::array<ContactWays, 2>& contacts) { m_contacts = contacts; }
    /// Whether anything is met anywhere.
    [[nodiscard]] bool any() const { return m_contacts[0].any() || m_contacts[1].any(); }

    /// `wanted` with the faces red that are met once the halves have gone these ways, mm.
    [[nodiscard]] std::vector<Rgb> painted(std::vector<Rgb> wanted, const std::array<double, 2>& ways,
                                           Rgb red);
    /// How many faces were red in the last answer.
    [[nodiscard]] int facesMet() const { return m_facesMet; }

private:
    std::array<ContactWays, 2> m_contacts;
    int m_facesMet = 0;
};

} // namespace moldwright::scene
