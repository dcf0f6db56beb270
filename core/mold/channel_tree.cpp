// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/channel_tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace moldwright {

namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The two at the channel that joins them, or none.
std::optional<ChannelBranch> joined(ChannelBranch a, ChannelBranch b, Eigen::Index along, double level,
                                    double least) {
    ChannelBranch joint;
    const double from = a.at[along];
    const double to = b.at[along];
    joint.at[along] = (from + to) / 2 + (b.reach - a.reach) / 2;
    joint.at[1 - along] = level;
    if (joint.at[along] - from < least || to - joint.at[along] < least)
        return std::nullopt;
    joint.reach = a.reach + (joint.at[along] - from);
    joint.feeds = {std::move(a), std::move(b)};
    return joint;
}

/// Walks round a tree, its channels on the left.
class Walk {
public:
    Walk(const TreeWidths& widths, std::size_t copies) : m_widths(widths) {
        m_outline.edges.resize(copies);
        m_outline.lengths.resize(copies);
    }

    TreeOutline round(const ChannelBranch& root) {
        about(root, {Vector2d::UnitY(), m_widths.trunk / 2}, 0);
        return std::move(m_outline);
    }

private:
    /// `back`: to where it is fed from; `so far`: mm from the root.
    void about(const ChannelBranch& branch, const ChannelRay& back, double soFar) {
        if (branch.feeds.empty())
            return end(branch, back, soFar);
        std::vector<std::pair<double, const ChannelBranch*>> onwards; // by angle, counter-clockwise
        for (const ChannelBranch& feed : branch.feeds) {
            const Vector2d way = feed.at - branch.at;
            const double angle = std::atan2(cross(back.way, way), back.way.dot(way));
            onwards.emplace_back(angle < 0 ? angle + 2 * std::numbers::pi : angle, &feed);
        }
        std::sort(onwards.begin(), onwards.end());
        ChannelRay before = back;
        for (const auto& [angle, feed] : onwards) {
            const ChannelRay ray{(feed->at - branch.at).normalized(), m_widths.branch / 2};
            addCorner(branch.at, before, ray);
            about(*feed, {-ray.way, ray.half}, soFar + (feed->at - branch.at).norm());
            before = ray;
        }
        addCorner(branch.at, before, back);
    }

    void addCorner(const Vector2d& at, const ChannelRay& a, const ChannelRay& b) {
        if (const std::optional<Vector2d> corner = cornerBetween(a, b))
            m_outline.shape.emplace_back(at + *corner);
    }

    void end(const ChannelBranch& gate, const ChannelRay& back, double soFar) {
        const Vector2d way = -back.way;
        const Vector2d across = back.half * Vector2d(-way.y(), way.x());
        const Vector2d last = gate.at + m_widths.beyond * way;
        // The side that looks down lies behind the end of a channel to the left, before that of one to the
        // right.
        const std::size_t first = m_outline.shape.size();
        m_outline.edges[gate.copy] = way.x() < 0 ? first + 1 : first - 1;
        m_outline.lengths[gate.copy] = soFar + gate.reach;
        m_outline.shape.emplace_back(last - across);
        m_outline.shape.emplace_back(last + across);
    }

    const TreeWidths& m_widths;
    TreeOutline m_outline;
};

} // namespace

std::optional<Vector2d> cornerBetween(const ChannelRay& a, const ChannelRay& b) {
    const double turn = cross(a.way, b.way);
    constexpr double straight = 1e-9;
    if (std::abs(turn) < straight)
        return std::nullopt;
    const Vector2d left = a.half * Vector2d(-a.way.y(), a.way.x());
    const Vector2d right = b.half * Vector2d(b.way.y(), -b.way.x());
    return left + a.way * cross(right - left, b.way) / turn;
}

ChannelBranch ledTo(ChannelBranch branch, Across across, double place) {
    const auto axis = static_cast<Eigen::Index>(across);
    const double way = std::abs(place - branch.at[axis]);
    if (way == 0)
        return branch;
    ChannelBranch corner{branch.at, branch.reach + way, {}, branch.copy};
    corner.at[axis] = place;
    corner.feeds.push_back(std::move(branch));
    return corner;
}

std::optional<ChannelBranch> joinedInPairs(std::vector<ChannelBranch> ends, Across across,
                                           const std::vector<double>& levels, double least) {
    const auto along = static_cast<Eigen::Index>(across);
    const Across upwards = across == Across::X ? Across::Y : Across::X;
    for (const double level : levels) {
        std::vector<ChannelBranch> joints;
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
            std::optional<ChannelBranch> joint =
                joined(ledTo(std::move(ends[i]), upwards, level),
                       ledTo(std::move(ends[i + 1]), upwards, level), along, level, least);
            if (!joint)
                return std::nullopt;
            joints.push_back(*std::move(joint));
        }
        ends = std::move(joints);
    }
    return std::move(ends.front());
}

std::vector<PlanShape> stripsOf(const ChannelBranch& root, const TreeWidths& widths) {
    std::vector<PlanShape> strips;
    const double half = widths.branch / 2;
    for (const ChannelBranch& feed : root.feeds) {
        const double beyond = feed.feeds.empty() ? widths.beyond : half;
        const Vector2d way = (feed.at - root.at).normalized();
        const Vector2d end = feed.at + beyond * way;
        const Vector2d begin = root.at - half * way;
        const Vector2d across = half * way.cwiseAbs().reverse();
        strips.push_back(planRectangle(begin.cwiseMin(end) - across, begin.cwiseMax(end) + across));
        for (PlanShape& strip : stripsOf(feed, widths))
            strips.push_back(std::move(strip));
    }
    return strips;
}

TreeOutline outlineOf(const ChannelBranch& root, const TreeWidths& widths, std::size_t copies) {
    return Walk(widths, copies).round(root);
}

} // namespace moldwright
