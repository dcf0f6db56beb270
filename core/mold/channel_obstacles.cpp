// SPDX-License-Identifier: AGPL-3.0-or-later
// What channels take of the plane, before they are built.
#include "mold/balanced_runners.h"
#include "mold/channel_room.h"
#include "mold/circle_layout.h"
#include "mold/mold_builder.h"
#include "mold/star_runners.h"

#include <algorithm>

namespace moldwright {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

/// Gates of a copy with their feet and, where they lead to a runner, their ways there; mold's frame.
std::vector<PlanShape> MoldBuilder::gateShapes(const CavityCopy& copy) const {
    const CavityKind& kind = kinds()[copy.kind];
    std::vector<PlanShape> shapes;
    for (const Gate& gate : (*m_entries)[copy.kind].gates) {
        shapes.push_back(movedPlan(gateFoot(kind, gate), copy.offset));
        if (!spoutEach())
            shapes.push_back(
                movedPlan(wayFrom(kind, gate.tip, halfRoom(gate), endOfStubs(copy.kind)), copy.offset));
    }
    return shapes;
}

void MoldBuilder::addChannelObstacles(Obstacles& obstacles, double faceY) const {
    const auto addUpwards = [&](const Vector2d& from, double half) {
        obstacles.push_back(planRectangle({from.x() - half, from.y()}, {from.x() + half, faceY}));
    };
    for (const CavityCopy& copy : m_layout.copies)
        for (PlanShape& shape : gateShapes(copy))
            obstacles.push_back(std::move(shape));
    const double funnel = widestOfSpout() / 2;
    const double nudged = (jointAttempts - 1) * jointNudge * m_widths.gate; // it may be joined so far aside
    if (spoutEach())
        for (const CavityCopy& copy : m_layout.copies) {
            for (const Gate& gate : (*m_entries)[copy.kind].gates)
                addUpwards(gate.tip + copy.offset, funnel + nudged);
            addVentObstacles(obstacles, copy, faceY);
        }
    else if (star()) {
        addUpwards(m_layout.hub, std::max(funnel, m_widths.main / 2));
        for (const Vector2d& arm : m_layout.arms)
            obstacles.push_back(starArm(m_layout.hub, arm, m_layout.armEnd, m_widths.runner));
    } else if (balanced()) {
        addRunnerObstacles(obstacles);
        addUpwards(m_layout.tree->at, std::max(funnel, m_widths.main / 2));
    } else {
        addRunnerObstacles(obstacles);
        addUpwards({m_layout.mainAxis, m_layout.runnerAxes.front() - m_widths.runner / 2 - m_widths.beside},
                   std::max(funnel, m_widths.main / 2));
    }
}

void MoldBuilder::addRunnerObstacles(Obstacles& obstacles) const {
    const ChannelWidths& widths = m_widths;
    AlignedBox2d all;
    for (const CavityCopy& copy : m_layout.copies)
        for (const Vector2d& p : kinds()[copy.kind].hull)
            all.extend(Vector2d(p + copy.offset));
    all.extend(Vector2d(m_layout.mainAxis, all.center().y())); // staggered, it stands beside all of them
    if (balanced())
        for (PlanShape& strip : stripsOf(*m_layout.tree, treeWidths(widths)))
            obstacles.push_back(std::move(strip));
    else
        for (const double axis : m_layout.runnerAxes)
            obstacles.push_back(planRectangle({all.min().x() - widths.gate, axis - widths.runner / 2},
                                              {all.max().x() + widths.gate, axis + widths.runner / 2}));
    if (!balanced())
        for (const CavityCopy& copy : m_layout.copies)
            addVentObstacles(obstacles, copy, copy.offset.y() + endOfStubs(copy.kind));
}

/// Vents of a copy that may run up the parting plane; as wide as their joints may become.
void MoldBuilder::addVentObstacles(Obstacles& obstacles, const CavityCopy& copy, double end) const {
    const double half = m_mold.settings.vents.diameter;
    for (const VentedTrap& vented : (*m_entries)[copy.kind].traps)
        if (const std::optional<Vector2d> top = topInPlane(kinds()[copy.kind], vented, up())) {
            const Vector2d tip = *top + copy.offset;
            obstacles.push_back(planRectangle({tip.x() - half, tip.y()}, {tip.x() + half, end}));
        }
}

} // namespace moldwright
