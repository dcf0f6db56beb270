// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/circle_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moldwright {

namespace {

using Eigen::Vector2d;

constexpr double rounding = 2.0 / 256; ///< mm, by which two copies may stand nearer than computed

/// Where place i lies, seen from the middle. Straight up there is the spout.
Vector2d wayTo(int i, int count) {
    const double angle = std::numbers::pi * (0.5 + (2 * i + 1) / static_cast<double>(count));
    return {std::cos(angle), std::sin(angle)};
}

class Circle {
public:
    Circle(const std::vector<CavityKind>& kinds, const std::vector<Vector2d>& tips, double spacing,
           const StarRoom& room)
        : m_kinds(kinds), m_tips(tips), m_spacing(spacing), m_room(room) {
        for (std::size_t i = 0; i < kinds.size(); ++i)
            for (const Vector2d& p : kinds[i].hull) {
                m_beyondTip = std::max(m_beyondTip, (p - tips[i]).dot(kinds[i].inlet));
                m_reach = std::max(m_reach, (p - tips[i]).norm());
            }
    }

    Layout smallest() {
        constexpr double close = 0.125; // mm
        double low = m_room.hub + armGap();
        double high = low + m_reach;
        while (!fits(high))
            high *= 2;
        while (high - low > close) {
            const double middle = (low + high) / 2;
            (fits(middle) ? high : low) = middle;
        }
        return at(high);
    }

private:
    /// From an arm's end to the place it fills.
    [[nodiscard]] double armGap() const { return m_beyondTip + m_spacing; }

    [[nodiscard]] Layout at(double radius) const {
        Layout layout;
        layout.armEnd = radius - armGap();
        for (std::size_t i = 0; i < m_kinds.size(); ++i) {
            CavityCopy copy;
            copy.kind = i;
            copy.column = static_cast<int>(i);
            copy.offset = onCopyStep(-radius * m_kinds[i].inlet - m_tips[i]);
            layout.copies.push_back(copy);
            layout.arms.emplace_back(-m_kinds[i].inlet);
            layout.tipRadii.push_back((m_tips[i] + copy.offset).norm());
        }
        return layout;
    }

    [[nodiscard]] bool fits(double radius) const {
        const Layout layout = at(radius);
        std::vector<PlanShape> hulls;
        for (const CavityCopy& copy : layout.copies)
            hulls.push_back(movedPlan(m_kinds[copy.kind].hull, copy.offset));
        std::vector<PlanShape> channels;
        if (m_room.arm > 0) {
            channels.push_back(starArm({0, 0}, Vector2d::UnitY(), radius + 2 * m_reach, m_room.spout));
            for (const Vector2d& way : layout.arms)
                channels.push_back(starArm({0, 0}, way, layout.armEnd, m_room.arm));
        }
        for (std::size_t i = 0; i < hulls.size(); ++i) {
            for (std::size_t j = i + 1; j < hulls.size(); ++j)
                if (!planKeepsClear(hulls[i], hulls[j], m_spacing))
                    return false;
            for (const PlanShape& channel : channels)
                if (!planKeepsClear(hulls[i], channel, m_spacing - rounding))
                    return false;
        }
        return true;
    }

    const std::vector<CavityKind>& m_kinds;
    const std::vector<Vector2d>& m_tips;
    double m_spacing;
    StarRoom m_room;
    double m_beyondTip = 0; ///< how far any cavity reaches beyond its tip towards the middle
    double m_reach = 0;
};

} // namespace

std::vector<CavityKind> kindsRound(const std::vector<CavityKind>& parts,
                                   const std::vector<std::size_t>& partAt, const CavityRules& rules) {
    const auto count = static_cast<int>(partAt.size());
    std::vector<CavityKind> turned;
    std::vector<CavityKind> moved;
    for (int i = 0; i < count; ++i) {
        const CavityKind& upright = parts[partAt[static_cast<std::size_t>(i)]];
        const Vector2d inlet = -wayTo(i, count);
        moved.push_back(upright);
        moved.back().inlet = inlet;
        if (turned.size() < static_cast<std::size_t>(i))
            continue;                                          // a turn before this one was not allowed
        const double turn = std::atan2(-inlet.x(), inlet.y()); // of +y onto the inlet
        std::expected<CavityKind, double> kind = turnedKind(upright, turn, rules);
        if (kind) {
            kind->inlet = inlet;
            turned.push_back(*std::move(kind));
        }
    }
    return turned.size() == moved.size() ? turned : moved;
}

Layout circleLayout(const std::vector<CavityKind>& kinds, const std::vector<Vector2d>& tips, double spacing,
                    const StarRoom& room) {
    return Circle(kinds, tips, spacing, room).smallest();
}

PlanShape starArm(const Vector2d& hub, const Vector2d& way, double length, double width) {
    const Vector2d across = width / 2 * Vector2d(-way.y(), way.x());
    const Vector2d end = hub + length * way;
    return {hub - across, end - across, end + across, hub + across};
}

} // namespace moldwright
