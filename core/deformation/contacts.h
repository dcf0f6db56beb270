// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/elastic_body.h"

#include <vector>

namespace moldwright {

/// Two points of a body's surface that must not come nearer than they have: the first is to stay at least
/// `gap` from the second along `away`.
struct Contact {
    int a, b;
    Eigen::Vector3d away; ///< unit, from b's side of the gap to a's
    double gap;

    bool operator==(const Contact&) const = default;
};

/// Pairs of surface points that a motion has brought nearer than `gap`, and to less than half their distance
/// at rest, and whose faces look at each other; each point with the nearest such one. `X`: positions now, of
/// `body.V` at rest.
[[nodiscard]] std::vector<Contact> contactsAt(const BodyShape& body, const Positions& X, double gap);

/// The mean length of the surface's edges at rest.
[[nodiscard]] double meanEdge(const BodyShape& body);

} // namespace moldwright
