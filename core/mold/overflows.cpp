// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/overflows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace moldwright {

namespace {

using Eigen::Vector2d;

constexpr std::size_t wellCorners = 8; ///< the first edge faces the cavity

/// A channel opens into one edge of its well, which leans on both sides of it.
double channelWidth(const OverflowSettings& settings) {
    return std::min(settings.channel, 0.3 * settings.diameter);
}

/// A place of a frame in which the channel leads along +y from the tip, in the kind's.
Vector2d fromTip(const Overflow& overflow, const Vector2d& p) {
    const Vector2d right(overflow.way.y(), -overflow.way.x());
    return overflow.tip + p.x() * right + p.y() * overflow.way;
}

PlanShape channelShape(const Overflow& overflow, const OverflowSettings& settings, int attempt) {
    const double width = channelWidth(settings) * (1 - 0.013 * attempt);
    const double axis = width * 0.011 * (attempt % 2 == 0 ? attempt : -attempt);
    PlanShape shape = planRectangle({axis - width / 2, -overflow.drop * (1 + 0.03 * attempt)},
                                    {axis + width / 2, overflow.exit + settings.length});
    for (Vector2d& p : shape)
        p = fromTip(overflow, p);
    return shape;
}

/// A closed curve by the way along it.
class Walk {
public:
    explicit Walk(const PlanShape& shape) : m_shape(shape), m_upTo{0} {
        for (std::size_t k = 0; k < shape.size(); ++k)
            m_upTo.push_back(m_upTo.back() + (shape[(k + 1) % shape.size()] - shape[k]).norm());
    }
    [[nodiscard]] double length() const { return m_upTo.back(); }
    [[nodiscard]] Vector2d at(double s) const {
        s -= length() * std::floor(s / length());
        const auto after = std::upper_bound(m_upTo.begin() + 1, m_upTo.end() - 1, s);
        const auto k = static_cast<std::size_t>(after - m_upTo.begin()) - 1;
        const double edge = m_upTo[k + 1] - m_upTo[k];
        const Vector2d& from = m_shape[k];
        return edge > 0 ? Vector2d(from + (s - m_upTo[k]) / edge * (m_shape[(k + 1) % m_shape.size()] - from))
                        : from;
    }
    /// Out of the cavity, square to the curve as it runs about `s` within `width`: outer curves run
    /// counter-clockwise, inner ones clockwise.
    [[nodiscard]] Vector2d outwards(double s, double width) const {
        const Vector2d along = (at(s + width / 2) - at(s - width / 2)).normalized();
        return {along.y(), -along.x()};
    }
    /// Where the curve is nearest to a place.
    [[nodiscard]] double nearest(const Vector2d& place) const {
        double best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < m_shape.size(); ++k) {
            const Vector2d edge = m_shape[(k + 1) % m_shape.size()] - m_shape[k];
            const double t =
                std::clamp((place - m_shape[k]).dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
            if (const double away = (m_shape[k] + t * edge - place).norm(); away < least) {
                least = away;
                best = m_upTo[k] + t * edge.norm();
            }
        }
        return best;
    }

private:
    const PlanShape& m_shape;
    std::vector<double> m_upTo; ///< each corner, mm along the curve
};

/// A place of a parting curve at which a channel could leave.
struct Place {
    Vector2d tip;
    Vector2d way;
};

class OverflowFinder {
public:
    OverflowFinder(const CavityKind& kind, const CavityFeatures& features, const OverflowPlan& plan)
        : m_kind(kind), m_features(features), m_plan(plan), m_settings(plan.settings->overflows) {
        std::map<int, std::vector<const CavityOutline*>> solids;
        for (const CavityOutline& outline : kind.outlines)
            solids[outline.solid].push_back(&outline);
        for (auto& [number, outlines] : solids)
            m_solids.push_back(std::move(outlines));
        for (const Gate& gate : features.gates)
            m_away.push_back(gate.tip);
        for (const HalfBore& bore : features.bores)
            if (bore.use == HalfBore::Use::Spout)
                m_away.push_back(bore.axis);
    }

    Result<std::vector<Overflow>> found() {
        // What stands by hand comes first, so that the others find room beside it.
        for (const bool byHand : {true, false})
            for (std::size_t i = 0; i < m_solids.size() * static_cast<std::size_t>(m_settings.count); ++i) {
                const int number = m_plan.firstNumber + static_cast<int>(i);
                const auto wish = placeByHand(m_plan.settings->placed, Placeable::Overflow, number);
                if (wish.has_value() != byHand)
                    continue;
                const std::size_t solid = i / static_cast<std::size_t>(m_settings.count);
                Result<Overflow> overflow = wish ? at(solid, *wish, number) : placed(solid);
                if (!overflow)
                    return std::unexpected(overflow.error());
                overflow->number = number;
                m_away.push_back(overflow->tip);
                m_found.push_back(*std::move(overflow));
            }
        std::sort(m_found.begin(), m_found.end(),
                  [](const Overflow& a, const Overflow& b) { return a.number < b.number; });
        return std::move(m_found);
    }

private:
    Result<Overflow> at(std::size_t solid, const Vector2d& wish, int number) {
        std::optional<Place> best;
        for (const CavityOutline* outline : m_solids[solid]) {
            const Walk walk(outline->shape);
            const double s = walk.nearest(wish);
            if (!best || (walk.at(s) - wish).norm() < (best->tip - wish).norm())
                best = {walk.at(s), walk.outwards(s, channelWidth(m_settings))};
        }
        const double away = (best->tip - wish).norm();
        if (away > overflowReach(m_settings))
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "Overflow {0} would stand {1} mm from its cavity's parting line. "
                                           "Keep it within {2} mm, or have it placed automatically."),
                           {std::to_string(number + 1), readable(away), readable(overflowReach(m_settings))});
        std::optional<Overflow> overflow = leaving(*best, solid);
        if (!overflow)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "Overflow {0} cannot stand there: its channel would meet another "
                                           "part of the cavity. Move it, or have it placed automatically."),
                           {std::to_string(number + 1)});
        overflow->stands = wish;
        return *std::move(overflow);
    }

    /// At the first place with room of those that are wanted most.
    Result<Overflow> placed(std::size_t solid) {
        for (const Place& place : wanted(solid))
            if (const std::optional<Overflow> overflow = leaving(place, solid);
                overflow && hasRoom(*overflow))
                return *overflow;
        std::unexpected<Error> error =
            failure(ErrorCode::Impossible,
                    MW_TEXT("Mold", "There is no room for {0} overflows {1} mm wide at each cavity. Ask for "
                                    "fewer or smaller ones, or for more steel between the cavities."),
                    {std::to_string(m_settings.count), readable(m_settings.diameter)});
        const Vector2d& near = m_solids[solid].front()->shape.front();
        error.error().places.emplace_back(near.x(), near.y(), 0);
        return error;
    }

    [[nodiscard]] std::vector<Place> wanted(std::size_t solid) const {
        const double width = channelWidth(m_settings);
        std::vector<Place> places;
        std::vector<double> rank; // the greater, the better
        for (const CavityOutline* outline : m_solids[solid]) {
            constexpr double most = 96; // of one curve
            const Walk walk(outline->shape);
            const double step = std::max(m_settings.diameter / 4, walk.length() / most);
            for (double s = 0; s < walk.length(); s += step) {
                places.push_back({walk.at(s), walk.outwards(s, width)});
                rank.push_back(fromTheOthers(places.back().tip));
            }
            const auto farthest = std::max_element(
                outline->shape.begin(), outline->shape.end(),
                [&](const Vector2d& a, const Vector2d& b) { return fromTheOthers(a) < fromTheOthers(b); });
            const double corner = walk.nearest(*farthest);
            places.push_back({walk.at(corner), walk.outwards(corner, width)});
            rank.push_back(fromTheOthers(*farthest));
            for (const Vector2d& top : trapsOn(*outline)) {
                const double s = walk.nearest(top);
                places.push_back({walk.at(s), walk.outwards(s, width)});
                rank.push_back(1e6 + fromTheOthers(top));
            }
        }
        std::vector<std::size_t> order(places.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return rank[a] > rank[b]; });
        std::vector<Place> sorted;
        for (const std::size_t i : order)
            sorted.push_back(places[i]);
        return sorted;
    }

    /// The highest places of a curve in traps that have no vent and no well yet.
    [[nodiscard]] std::vector<Vector2d> trapsOn(const CavityOutline& outline) const {
        std::vector<Vector2d> tops;
        for (const AirTrap& trap : m_features.unvented)
            if (const auto top = topOf(trap, outline);
                top && std::none_of(m_found.begin(), m_found.end(), [&](const Overflow& other) {
                    return (other.tip - *top).norm() < m_settings.diameter;
                }))
                tops.push_back(*top);
        return tops;
    }

    /// Where a curve is highest within a trap: the middle where that is a level edge.
    [[nodiscard]] std::optional<Vector2d> topOf(const AirTrap& trap, const CavityOutline& outline) const {
        constexpr double level = 1e-3; // mm
        double most = -std::numeric_limits<double>::infinity();
        Vector2d sum = Vector2d::Zero();
        int count = 0;
        for (std::size_t k = 0; k < outline.shape.size(); ++k) {
            const double height = m_kind.fromInlet(outline.shape[k]).y();
            if (height < most - level ||
                std::find(trap.points.begin(), trap.points.end(), outline.points[k]) == trap.points.end())
                continue;
            if (height > most + level) {
                sum.setZero();
                count = 0;
            }
            most = std::max(most, height);
            sum += outline.shape[k];
            ++count;
        }
        return count > 0 ? std::optional<Vector2d>(sum / count) : std::nullopt;
    }

    [[nodiscard]] double fromTheOthers(const Vector2d& p) const {
        double least = std::numeric_limits<double>::max();
        for (const Vector2d& other : m_away)
            least = std::min(least, (p - other).norm());
        return least;
    }

    /// None where the channel does not lead straight out there, or the well would lie in the cavity's way.
    [[nodiscard]] std::optional<Overflow> leaving(const Place& place, std::size_t solid) const {
        Overflow overflow;
        overflow.stands = overflow.tip = place.tip;
        overflow.way = place.way;
        const double width = channelWidth(m_settings);
        std::vector<CavityOutline> turned;
        for (const CavityOutline* outline : m_solids[solid]) {
            turned.push_back(*outline);
            turned.back().solid = 0;
            for (Vector2d& p : turned.back().shape) {
                const Vector2d from = p - place.tip;
                p = {from.x() * place.way.y() - from.y() * place.way.x(), from.dot(place.way)};
            }
        }
        // Nothing of the solid's own outlines may lie over the channel.
        const Result<Gate> gate = gateAt(turned, 0, 0, width);
        if (!gate || gate->width < width || gate->tip.y() > width / 2)
            return std::nullopt;
        overflow.drop = gate->drop;
        overflow.exit = std::max(gate->exit, 0.0);
        Overflow outside = overflow;
        outside.drop = -overflow.exit - std::min(0.3, m_settings.length / 2);
        const PlanShape channel = overflowChannel(outside, m_settings);
        const PlanShape well = overflowWell(overflow, m_settings);
        const double steel = std::min(m_plan.settings->leastSteel, 0.9 * m_settings.length);
        for (const CavityOutline& outline : m_kind.outlines)
            if (planDistance(channel, outline.shape) == 0 || planDistance(well, outline.shape) < steel)
                return std::nullopt;
        return overflow;
    }

    [[nodiscard]] bool hasRoom(const Overflow& overflow) const {
        const double steel = m_plan.settings->leastSteel;
        for (const PlanShape& shape :
             {overflowChannel(overflow, m_settings), overflowWell(overflow, m_settings)}) {
            const auto clear = [&](const PlanShape& other) { return planKeepsClear(shape, other, steel); };
            if (!std::all_of(m_plan.others.begin(), m_plan.others.end(), clear) ||
                !std::all_of(m_found.begin(), m_found.end(), [&](const Overflow& other) {
                    return clear(overflowChannel(other, m_settings)) &&
                           clear(overflowWell(other, m_settings));
                }))
                return false;
        }
        return true;
    }

    const CavityKind& m_kind;
    const CavityFeatures& m_features;
    const OverflowPlan& m_plan;
    const OverflowSettings& m_settings;
    std::vector<std::vector<const CavityOutline*>> m_solids;
    std::vector<Vector2d> m_away; ///< gates, spouts and wells so far
    std::vector<Overflow> m_found;
};

} // namespace

double overflowReach(const OverflowSettings& settings) {
    constexpr double steepest = 1.5; // widths that a slanting outline may rise within a channel
    return settings.count > 0 ? steepest * channelWidth(settings) + settings.length + settings.diameter : 0;
}

double spacingWithOverflows(const MoldSettings& settings) {
    // Two may face each other.
    return settings.layout.spacing + 2 * overflowReach(settings.overflows);
}

int overflowCount(const CavityKind& kind, const OverflowSettings& settings) {
    std::set<int> solids;
    for (const CavityOutline& outline : kind.outlines)
        solids.insert(outline.solid);
    return settings.count * static_cast<int>(solids.size());
}

Result<std::vector<Overflow>> overflowsOf(const CavityKind& kind, const CavityFeatures& features,
                                          const OverflowPlan& plan) {
    if (plan.settings->overflows.count <= 0)
        return std::vector<Overflow>();
    return OverflowFinder(kind, features, plan).found();
}

PlanShape overflowChannel(const Overflow& overflow, const OverflowSettings& settings) {
    return channelShape(overflow, settings, 0);
}

PlanShape overflowWell(const Overflow& overflow, const OverflowSettings& settings) {
    const double half = std::numbers::pi / wellCorners;
    const double radius = settings.diameter / 2 / std::cos(half);
    const double middle = overflow.exit + settings.length + settings.diameter / 2;
    PlanShape shape;
    for (std::size_t k = 0; k < wellCorners; ++k) {
        const double angle = -std::numbers::pi / 2 + half * (2 * static_cast<double>(k) - 1);
        shape.push_back(
            fromTip(overflow, Vector2d(radius * std::cos(angle), middle + radius * std::sin(angle))));
    }
    return shape;
}

Result<JoinedOverflow> overflowBodies(const Overflow& overflow, const OverflowSettings& settings,
                                      const ChannelRules& rules, int attempt) {
    Result<DraftedPrism> well =
        rules.prism(overflowWell(overflow, settings), heightOverWidth * settings.diameter, {});
    if (!well)
        return std::unexpected(well.error());
    std::array<double, 2> slope{};
    for (const std::size_t side : {0UL, 1UL})
        if (well->stands(static_cast<int>(side) + 1))
            slope[side] = well->slope[side].front();
    constexpr double below = 0.85; // of the well's height, so that its wall stays above the channel
    const double height = std::min(heightOverWidth * channelWidth(settings),
                                   below * std::max(well->height[0], well->height[1]));
    constexpr std::size_t end = 2; // of the rectangle's edges
    Result<DraftedPrism> channel =
        rules.prism(channelShape(overflow, settings, attempt), height, {{end, slope}});
    if (!channel)
        return std::unexpected(channel.error());
    return JoinedOverflow{*std::move(channel), *std::move(well), overflow.number, overflow.tip,
                          overflow.stands};
}

} // namespace moldwright
