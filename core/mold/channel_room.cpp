// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/channel_room.h"

#include <algorithm>

namespace moldwright {

using Eigen::Vector2d;
using Eigen::Vector3d;

double halfRoom(const Gate& gate) {
    return gate.width * (0.5 + (jointAttempts - 1) * jointNudge);
}

PlanShape gateFoot(const CavityKind& kind, const Gate& gate) {
    const Vector2d tip = kind.fromInlet(gate.tip);
    const double half = halfRoom(gate);
    PlanShape foot =
        planRectangle({tip.x() - half, tip.y() - 1.3 * gate.drop}, {tip.x() + half, tip.y() + gate.drop});
    for (Vector2d& p : foot)
        p = kind.toInlet(p);
    return foot;
}

PlanShape wayFrom(const CavityKind& kind, const Vector2d& place, double half, double end) {
    const Vector2d start = kind.fromInlet(place);
    PlanShape strip =
        planRectangle({start.x() - half, start.y()}, {start.x() + half, std::max(start.y(), end)});
    for (Vector2d& p : strip)
        p = kind.toInlet(p);
    return strip;
}

std::optional<Vector2d> topInPlane(const CavityKind& kind, const VentedTrap& vented, const Vector3d& up) {
    if (vented.byHand)
        return topOver(kind.outlines, vented.top.x(), vented.trap.points);
    const auto level = [&](const Vector2d& place) { return place.dot(up.head<2>()); };
    std::optional<Vector2d> best;
    for (const int v : vented.trap.points) {
        const Vector2d place = kind.cast.V.row(v).head<2>();
        if (kind.cast.V(v, 2) == 0 && (!best || level(place) > level(*best)))
            best = place;
    }
    return best;
}

} // namespace moldwright
