// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/channels.h"

#include "features/wall_slope.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;

constexpr double leastLean = 0.02;      ///< a channel's wall never overhangs the plane's normal
constexpr double guestBelowHost = 0.85; ///< so that a wall stays above a guest's section

/// A runner from its far end to the main runner's wall, or the other way round.
struct RunnerPlan {
    double from = 0;
    double to = 0;
    double inner = 0; ///< where its stubs nearest to the main runner end
    bool left = true; ///< of the main runner
};

} // namespace

Result<std::array<double, 2>> ChannelRules::slope(const Vector2d& m) const {
    std::array<double, 2> slopes{0, 0};
    for (const int side : {1, 2}) {
        const std::optional<double> k = wallSlope(m, side, {directions.of(side)}, draftDegrees);
        if (!k)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "A channel's wall would have to lie flat to leave along the removal "
                                   "directions with {0}°."),
                           {readable(draftDegrees)});
        slopes[side == 1 ? 0 : 1] = std::max(*k, leastLean);
    }
    return slopes;
}

Result<DraftedPrism> ChannelRules::prism(PlanShape base, double height,
                                         std::vector<DraftedPrism::Opening> openings) const {
    PrismRequest request;
    request.base = std::move(base);
    request.openings = std::move(openings);
    request.height = {sides[0] ? height : 0, sides[1] ? height : 0};
    request.directions = {std::vector{directions.d1}, std::vector{directions.d2}};
    request.draftDegrees = draftDegrees;
    request.leastSlope = leastLean;
    request.grid = grid;
    return prismAsHighAsFits(std::move(request));
}

Result<ChannelWidths> ChannelWidths::of(const SpoutSettings& spout, const ChannelRules& rules) {
    ChannelWidths widths;
    widths.main = spout.diameter;
    widths.runner = 0.8 * spout.diameter;
    widths.gate = std::min(spout.gate, 0.75 * widths.runner);
    double steepest = 0;
    for (const double way : {-1.0, 1.0})
        for (const Vector2d& m : {Vector2d(way, 0), Vector2d(0, way)}) {
            const Result<std::array<double, 2>> slope = rules.slope(m);
            if (!slope)
                return std::unexpected(slope.error());
            steepest = std::max({steepest, (*slope)[0], (*slope)[1]});
        }
    widths.beside = 1 + heightOverWidth * widths.main * steepest;
    return widths;
}

PlanShape spoutShape(double axis, double bottom, double width, double neckEnd, double top, double straight,
                     const SpoutSettings& spout) {
    const double neck = width / 2;
    const double full = std::max(spout.diameter / 2, neck);
    const double funnel = std::max(spout.funnel / 2, full);
    const double fullAt = neckEnd + (full - neck);
    const double funnelAt = top - straight;
    const double widenAt = funnelAt - (funnel - full);
    // Edges beside a turn must be long enough for the lid's to keep their way; no turn, no point.
    PlanShape right{{axis + neck, bottom}};
    if (full > neck) {
        right.emplace_back(axis + neck, neckEnd);
        if (widenAt >= fullAt + straight)
            right.emplace_back(axis + full, fullAt);
    }
    if (funnel > full) {
        if (widenAt >= fullAt + straight)
            right.emplace_back(axis + full, widenAt);
        right.emplace_back(axis + funnel, funnelAt);
    }
    right.emplace_back(axis + funnel, top);
    PlanShape shape{{axis - neck, bottom}};
    shape.insert(shape.end(), right.begin(), right.end());
    for (auto p = right.rbegin(); p + 1 != right.rend(); ++p)
        shape.emplace_back(2 * axis - p->x(), p->y());
    return shape;
}

std::size_t addSpoutAbove(PlanShape& outline, double axis, double neckEnd, const SpoutSettings& spout,
                          const ChannelWidths& widths, const FaceEnd& end) {
    // Of the spout's own polygon the first two corners are those it has in common with what it leads up from.
    const PlanShape above =
        spoutShape(axis, neckEnd - widths.beside, widths.main, neckEnd, end.line, widths.straight(), spout);
    const std::size_t mouth = outline.size() + above.size() / 2 - 2;
    outline.insert(outline.end(), above.begin() + 2, above.end());
    return mouth;
}

Result<void> carries(const DraftedPrism& channel, const DraftedPrism& stub) {
    for (const std::size_t side : {0UL, 1UL})
        if (stub.height[side] > 0.95 * channel.height[side])
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "A runner can only be {0} mm deep here, which is too little for the gates "
                                   "that open into it. Take a wider spout or narrower gates."),
                           {readable(std::max(channel.height[0], channel.height[1]))});
    return {};
}

double spoutLength(const SpoutSettings& spout, double width, double straight) {
    const double full = std::max(spout.diameter, width);
    return (full - width) / 2 + (std::max(spout.funnel, full) - full) / 2 + 2 * straight + 0.5;
}

Result<double> tailLength(double height, const ChannelRules& rules) {
    const Result<std::array<double, 2>> slope = rules.slope(Vector2d::UnitY());
    if (!slope)
        return std::unexpected(slope.error());
    return upToSixteenth(height * std::max((*slope)[0], (*slope)[1]) + 0.5);
}

Result<DraftedPrism> tailOf(const DraftedPrism& channel, const ChannelRules& rules, const FaceEnd& end,
                            bool closed) {
    const std::size_t from = channel.openings.front().edge; // runs from right to left
    const double right = channel.base[from].x();
    const double left = channel.base[(from + 1) % channel.base.size()].x();
    PrismRequest request;
    // Where the face comes in with the height, what solidifies keeps behind it.
    double behind = 0;
    for (const std::size_t side : {0UL, 1UL})
        behind = std::max(behind, -end.flare[side] * channel.height[side]);
    request.base = planRectangle({left, end.line}, {right, closed ? end.face - behind : end.face});
    request.openings = {{0, {0, 0}}};
    if (!closed)
        request.openings.push_back({2, end.flare});
    request.height = channel.height;
    request.directions = {std::vector{rules.directions.d1}, std::vector{rules.directions.d2}};
    request.draftDegrees = rules.draftDegrees;
    request.leastSlope = leastLean;
    request.grid = rules.grid;
    return draftedPrism(request);
}

namespace {

/// Lays out the net for one layout.
class NetBuilder {
public:
    NetBuilder(const Layout& layout, const std::vector<std::vector<Stub>>& stubs, const SpoutSettings& spout,
               const ChannelWidths& widths, const ChannelRules& rules, const FaceEnd& end)
        : m_layout(layout), m_stubs(stubs), m_spout(spout), m_rules(rules), m_end(end), m_widths(widths) {}

    Result<RunnerNet> build() {
        if (Result<void> done = addMain(); !done)
            return std::unexpected(done.error());
        for (std::size_t row = 0; row < m_layout.runnerAxes.size(); ++row)
            for (const bool left : {true, false})
                if (Result<void> done = addRunner(row, left); !done)
                    return std::unexpected(done.error());
        measurePaths();
        return std::move(m_net);
    }

private:
    Result<void> addMain() {
        const double bottom = m_layout.runnerAxes.front() - m_widths.runner / 2 - m_widths.beside;
        const double neckEnd = m_layout.runnerAxes.back() + m_widths.runner / 2 + m_widths.beside;
        PlanShape shape = spoutShape(m_layout.mainAxis, bottom, m_widths.main, neckEnd, m_end.line,
                                     m_widths.straight(), m_spout);
        m_mainTop = shape.size() / 2; // the edge along the top, right to left
        Result<DraftedPrism> prism =
            m_rules.prism(std::move(shape), heightOverWidth * m_widths.main, {{m_mainTop, {0, 0}}});
        if (!prism)
            return std::unexpected(prism.error());
        m_net.channels.push_back({*std::move(prism), {}, "Spout"});
        return {};
    }

    [[nodiscard]] std::optional<RunnerPlan> planned(std::size_t row, bool left) const {
        RunnerPlan plan{1e300, -1e300, 0, left};
        for (const CavityCopy& copy : m_layout.copies) {
            if (copy.row != static_cast<int>(row) || (copy.column < m_layout.mainColumn) != left)
                continue;
            for (const Stub& stub : m_stubs[copy.kind])
                for (const Vector2d& p : stub.prism.base) {
                    plan.from = std::min(plan.from, p.x() + copy.offset.x() - m_widths.beside);
                    plan.to = std::max(plan.to, p.x() + copy.offset.x() + m_widths.beside);
                }
        }
        if (plan.from > plan.to)
            return std::nullopt;
        plan.inner = left ? plan.to - m_widths.beside : plan.from + m_widths.beside;
        (left ? plan.to : plan.from) = m_layout.mainAxis + (left ? -1 : 1) * m_widths.main / 2;
        return plan;
    }

    Result<void> addRunner(std::size_t row, bool left) {
        const std::optional<RunnerPlan> plan = planned(row, left);
        if (!plan)
            return {};
        if (left ? plan->to <= plan->inner : plan->from >= plan->inner)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "At x = {0} mm the spout has no room between the gates beside it. "
                                           "Move it away from them."),
                           {readable(m_layout.mainAxis)});
        const double axis = m_layout.runnerAxes[row];
        const double half = m_widths.runner / 2;
        // The main runner's walls: 1 looks right, the last one left.
        Channel& main = m_net.channels.front();
        const std::size_t hostEdge = left ? main.prism.base.size() - 1 : 1;
        const std::array<double, 2> hostSlope = slopeAt(main.prism, hostEdge);
        // Of the rectangle's edges 1 looks right, 3 left.
        Result<DraftedPrism> prism = m_rules.prism(
            planRectangle({plan->from, axis - half}, {plan->to, axis + half}),
            guestHeight(heightOverWidth * m_widths.runner, main.prism), {{left ? 1UL : 3UL, hostSlope}});
        if (!prism)
            return std::unexpected(prism.error());
        if (Result<void> done = carriesItsStubs(*prism, row, left); !done)
            return done;
        m_net.channels.push_back({*std::move(prism), {}, "Runner"});
        Channel& runner = m_net.channels.back();
        main.guests.push_back({hostEdge, &runner.prism});
        for (const CavityCopy& copy : m_layout.copies)
            if (copy.row == static_cast<int>(row) && (copy.column < m_layout.mainColumn) == left)
                for (const Stub& stub : m_stubs[copy.kind])
                    runner.guests.push_back({0, &stub.prism, copy.offset});
        return {};
    }

    [[nodiscard]] Result<void> carriesItsStubs(const DraftedPrism& runner, std::size_t row, bool left) const {
        for (const CavityCopy& copy : m_layout.copies)
            if (copy.row == static_cast<int>(row) && (copy.column < m_layout.mainColumn) == left)
                for (const Stub& stub : m_stubs[copy.kind])
                    if (Result<void> done = carries(runner, stub.prism); !done)
                        return done;
        return {};
    }
    static std::array<double, 2> slopeAt(const DraftedPrism& prism, std::size_t edge) {
        return {prism.stands(1) ? prism.slope[0][edge] : 0, prism.stands(2) ? prism.slope[1][edge] : 0};
    }
    static double guestHeight(double wanted, const DraftedPrism& host) {
        return std::min(wanted, guestBelowHost * std::max(host.height[0], host.height[1]));
    }

    void measurePaths() {
        for (const CavityCopy& copy : m_layout.copies) {
            const double axis = m_layout.runnerAxes[static_cast<std::size_t>(copy.row)];
            const DraftedPrism& gate = m_stubs[copy.kind].front().prism;
            double x = 0;
            for (const Vector2d& p : gate.base)
                x += p.x() / static_cast<double>(gate.base.size());
            m_net.pathLengths.push_back(m_end.face - axis +
                                        std::abs(x + copy.offset.x() - m_layout.mainAxis));
        }
    }

    const Layout& m_layout;
    const std::vector<std::vector<Stub>>& m_stubs;
    const SpoutSettings& m_spout;
    const ChannelRules& m_rules;
    FaceEnd m_end;
    const ChannelWidths& m_widths;
    std::size_t m_mainTop = 0;
    RunnerNet m_net;
};

} // namespace

Result<RunnerNet> runnerNet(const Layout& layout, const std::vector<std::vector<Stub>>& stubsOfKind,
                            const SpoutSettings& spout, const ChannelWidths& widths,
                            const ChannelRules& rules, const FaceEnd& end) {
    return NetBuilder(layout, stubsOfKind, spout, widths, rules, end).build();
}

} // namespace moldwright
