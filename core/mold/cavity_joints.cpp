// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/cavity_joints.h"

#include "features/joined_channel.h"
#include "mesh/measures.h"
#include "mold/channel_room.h"
#include "mold/free_place.h"
#include "mold/overflows.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

IndexedMesh inOne(const std::vector<IndexedMesh>& bodies) {
    IndexedMesh all;
    for (const IndexedMesh& body : bodies) {
        const Eigen::Index points = all.V.rows();
        const Eigen::Index faces = all.F.rows();
        all.V.conservativeResize(points + body.V.rows(), 3);
        all.F.conservativeResize(faces + body.F.rows(), 3);
        all.V.bottomRows(body.V.rows()) = body.V;
        all.F.bottomRows(body.F.rows()) = (body.F.array() + static_cast<int>(points)).matrix();
    }
    return all;
}

class Joiner {
public:
    Joiner(const CavityKind& kind, const CavityFeatures& features, const JointPlan& plan)
        : m_kind(kind), m_features(features), m_plan(plan), m_outlines(kind.outlinesFromInlet()),
          m_through(kind.cast, kind.labels, plan.rules.directions) {}

    /// All of it, moved a little for each attempt.
    Result<JoinedCavity> planned(int attempt) {
        m_nudge = attempt;
        m_result = {};
        for (const Gate& gate : m_features.gates)
            if (Result<void> done = addGate(gate); !done)
                return std::unexpected(done.error());
        for (const Overflow& overflow : m_plan.overflows)
            if (Result<void> done = addOverflow(overflow); !done)
                return std::unexpected(done.error());
        for (const VentedTrap& trap : m_features.traps)
            if (Result<void> done = vent(trap); !done)
                return std::unexpected(done.error());
        for (const HalfBore& bore : m_features.bores)
            addBore(bore);
        return m_result;
    }

    Result<JoinedCavity> joined() {
        for (int attempt = 0; attempt < jointAttempts; ++attempt) {
            if (Result<JoinedCavity> cavity = planned(attempt); !cavity)
                return cavity;
            if (joinAll())
                return std::move(m_result);
        }
        Error error;
        error.code = ErrorCode::Impossible;
        error.message = {
            MW_TEXT("Mold", "The channels could not be joined to the cavity soundly at any of {0} nearby "
                            "places. Another pour direction or gate width may help."),
            {std::to_string(jointAttempts)}};
        for (const Gate& gate : m_features.gates)
            error.places.push_back(m_kind.cast.point(gate.point));
        return std::unexpected(error);
    }

private:
    [[nodiscard]] double nudged(double value, double width) const {
        return value + width * jointNudge * (m_nudge % 2 == 0 ? m_nudge : -m_nudge);
    }

    /// Found as if the inlet were +y, and turned back.
    Result<void> addGate(const Gate& gate) {
        const double width = gate.width * (1 - 0.013 * m_nudge);
        const Vector2d tip = m_kind.fromInlet(gate.tip);
        const double axis = nudged(tip.x(), width);
        const double bottom = tip.y() - gate.drop * (1 + 0.03 * m_nudge);
        PlanShape shape =
            m_plan.spout ? spoutShape(axis, bottom, width, gate.exit + m_plan.settings->layout.spacing / 2,
                                      m_plan.line, m_plan.widths.straight(), m_plan.settings->spout)
                         : planRectangle({axis - width / 2, bottom}, {axis + width / 2, m_plan.line});
        if (!wayIsFree(shape, gate.exit + 0.5)) {
            Error error;
            error.code = ErrorCode::Impossible;
            error.message.text =
                MW_TEXT("Mold", "The way from a cavity's gate to the runner passes through another "
                                "part of the cavity. Choose another pour direction.");
            error.places.emplace_back(gate.tip.x(), gate.tip.y(), 0);
            return std::unexpected(std::move(error));
        }
        for (Vector2d& p : shape)
            p = m_kind.toInlet(p);
        return add(std::move(shape),
                   heightOverWidth * (m_plan.spout ? m_plan.settings->spout.diameter : width),
                   {{}, m_plan.spout ? "Spout" : "Gate", false, gate.number, gate.tip, width});
    }

    /// Whether a channel keeps clear of all outlines from `above` on, the inlet being +y.
    [[nodiscard]] bool wayIsFree(const PlanShape& shape, double above) const {
        PlanShape rest = shape;
        for (Vector2d& p : rest)
            p.y() = std::max(p.y(), above);
        rest.erase(std::unique(rest.begin(), rest.end()), rest.end());
        return rest.size() < 3 ||
               std::none_of(
                   m_outlines.begin(), m_outlines.end(),
                   [&](const CavityOutline& outline) { return planDistance(rest, outline.shape) == 0; });
    }

    /// `stub`: what is known of it but its prism.
    Result<void> add(PlanShape shape, double height, Stub stub) {
        const std::size_t top = shape.size() / 2;
        Result<DraftedPrism> prism = m_plan.rules.prism(std::move(shape), height, {{top, m_plan.slope}});
        if (!prism)
            return std::unexpected(prism.error());
        stub.prism = *std::move(prism);
        m_result.stubs.push_back(std::move(stub));
        return {};
    }

    Result<void> addOverflow(const Overflow& overflow) {
        Result<JoinedOverflow> bodies =
            overflowBodies(overflow, m_plan.settings->overflows, m_plan.rules, m_nudge);
        if (!bodies)
            return std::unexpected(bodies.error());
        for (const Stub& stub : m_result.stubs)
            if (planDistance(bodies->channel.base, stub.prism.base) == 0 ||
                planDistance(bodies->well.base, stub.prism.base) == 0) {
                Error error;
                error.code = ErrorCode::Impossible;
                error.message = {MW_TEXT("Mold", "Overflow {0} would stand where the cavity is filled. Move "
                                                 "it, or have it placed automatically."),
                                 {std::to_string(overflow.number + 1)}};
                error.places.emplace_back(overflow.tip.x(), overflow.tip.y(), 0);
                return std::unexpected(std::move(error));
            }
        m_result.overflows.push_back(*std::move(bodies));
        return {};
    }

    [[nodiscard]] bool standing() const {
        return m_plan.settings->spout.resting == Resting::Standing && m_plan.ventsInPlane;
    }

    Result<void> vent(const VentedTrap& trap) {
        // In the plane it may leave some air only where a hand put it and there is no other way.
        if ((standing() && ventInPlane(trap, false)) || ventThrough(trap) ||
            (standing() && trap.byHand && ventInPlane(trap, true)))
            return {};
        if (!trap.byHand) {
            m_result.remaining.push_back({trap.top, trap.trap.volume});
            return {};
        }
        Error error;
        error.code = ErrorCode::Impossible;
        error.message = {MW_TEXT("Mold",
                                 "Vent {0} has no way out of the cavity there: it needs room for a foot "
                                 "wholly inside the cast, and nothing in its way."),
                         {std::to_string(trap.number + 1)}};
        error.places.push_back(trap.top);
        return std::unexpected(std::move(error));
    }

    /// Where a channel has left the outline, which slants where a hand put it or the mold leans.
    [[nodiscard]] double exitInPlane(const Vector2d& tip, double width) const {
        constexpr double steepest = 1.5; // widths
        double exit = tip.y();
        for (const CavityOutline& outline : m_kind.outlines)
            exit = std::max(exit, exitOf(outline.shape, tip.x(), width, tip.y()));
        return std::min(exit, tip.y() + steepest * width);
    }

    /// From there straight up; `withAir`: also where that leaves more than may stay.
    bool ventInPlane(const VentedTrap& vented, bool withAir) {
        const VentSettings& vents = m_plan.settings->vents;
        const std::optional<Vector2d> tip = topInPlane(m_kind, vented, m_plan.up);
        if (!tip)
            return false;
        const double left = airAbove(m_kind.cast, m_plan.up, vented.trap, tip->dot(m_plan.up.head<2>()));
        if (left > vents.smallestTrap && !withAir)
            return false;
        const double width = vents.diameter * (1 + 0.02 * m_nudge);
        const double axis = nudged(tip->x(), width);
        PlanShape shape =
            planRectangle({axis - width / 2, tip->y() - width}, {axis + width / 2, m_plan.line});
        // An outline's top is left at once, where that is up: what slants joins less soundly.
        const bool slants = vented.byHand || m_plan.up != Eigen::Vector3d::UnitY();
        const double exit = slants ? exitInPlane(*tip, width) : tip->y();
        if (!wayIsFree(shape, exit + 0.3) || !(vented.byHand || keepsClear(shape)))
            return false;
        const double height = vents.depth > 0 ? vents.depth / sidesOfChannels() : heightOverWidth * width;
        if (!add(std::move(shape), height, {{}, "Vent", true, vented.number, *tip, width}))
            return false;
        if (left > vents.smallestTrap)
            m_result.remaining.push_back({m_kind.cast.point(vented.trap.point), left});
        return true;
    }

    /// A vent's depth is shared by the halves that channels stand in.
    [[nodiscard]] double sidesOfChannels() const {
        return m_plan.rules.sides[0] && m_plan.rules.sides[1] ? 2 : 1;
    }

    /// Of the channels there are so far.
    [[nodiscard]] bool keepsClear(const PlanShape& shape) const {
        const double steel = m_plan.settings->leastSteel;
        const auto clear = [&](const PlanShape& other) { return planDistance(shape, other) >= steel; };
        return std::all_of(m_result.stubs.begin(), m_result.stubs.end(),
                           [&](const Stub& stub) { return clear(stub.prism.base); }) &&
               std::all_of(m_plan.others.begin(), m_plan.others.end(), clear) &&
               std::all_of(m_result.overflows.begin(), m_result.overflows.end(),
                           [&](const JoinedOverflow& other) {
                               return clear(other.channel.base) && clear(other.well.base);
                           }) &&
               std::all_of(m_result.vents.begin(), m_result.vents.end(),
                           [&](const CavityVent& other) { return clear(other.body.base); }) &&
               std::all_of(m_features.bores.begin(), m_features.bores.end(), [&](const HalfBore& bore) {
                   return clear(planCircle(bore.axis, bore.stations.back().radius, circleCorners));
               });
    }

    /// A vent through a half, and the place of the cavity that it lets the air out of.
    struct FoundVent {
        ThroughVent vent;
        Vector3d top;
    };

    bool ventThrough(const VentedTrap& vented) {
        std::optional<FoundVent> found = throughFrom(vented.top);
        if (!vented.byHand && (!found || !keepsClear(found->vent.body.base)))
            found = throughBeside(vented);
        if (!found)
            return false;
        const double left = airAbove(m_kind.cast, m_plan.up, vented.trap, found->vent.reach);
        if (left > m_plan.settings->vents.smallestTrap)
            m_result.remaining.push_back({vented.top, left});
        m_result.vents.push_back({std::move(found->vent), vented.number, found->top.head<2>()});
        return true;
    }

    [[nodiscard]] std::optional<FoundVent> throughFrom(const Vector3d& top, int quartersMost = 16) {
        const int side = top.z() >= 0 ? 1 : 2;
        ThroughVentRequest request;
        request.diameter = m_plan.settings->vents.diameter * (1 + 0.02 * m_nudge);
        request.end = m_plan.blockEnd[side == 1 ? 0 : 1];
        // More than the mold's draft, so that rounding at the joint cannot take it away.
        request.draftDegrees = m_plan.draftDegrees + 0.5;
        request.grid = m_plan.rules.grid;
        // Where joints near the high points come out unsound, a radius beside them they hardly do.
        request.quartersAway = m_nudge > 4 ? 4 : 0;
        request.quartersMost = quartersMost;
        std::optional<ThroughVent> vent = m_through.from(side, top, m_plan.up, request);
        return vent ? std::optional(FoundVent{*std::move(vent), top}) : std::nullopt;
    }

    /// Where the trap's highest place is taken, as beside a spout: the highest of its other places from which
    /// a vent keeps clear and lets some of the air out.
    [[nodiscard]] std::optional<FoundVent> throughBeside(const VentedTrap& vented) {
        constexpr std::size_t most = 24; // a diameter apart
        constexpr int quarters = 4;      // the next is looked at by itself
        const IndexedMesh& cast = m_kind.cast;
        const double diameter = m_plan.settings->vents.diameter;
        std::vector<std::pair<double, int>> downwards;
        for (const int v : vented.trap.points)
            downwards.emplace_back(-cast.point(v).dot(m_plan.up), v);
        std::sort(downwards.begin(), downwards.end());
        std::vector<Vector2d> tried{vented.top.head<2>()};
        for (const auto& [depth, v] : downwards) {
            const Vector3d p = cast.point(v);
            const Vector2d place = p.head<2>();
            const bool near = std::any_of(tried.begin(), tried.end(), [&](const Vector2d& other) {
                return (other - place).norm() < diameter;
            });
            if (near || !keepsClear(planCircle(place, diameter / 2, circleCorners)))
                continue;
            if (tried.size() > most)
                break;
            tried.push_back(place);
            std::optional<FoundVent> found = throughFrom(p, quarters);
            if (found && keepsClear(found->vent.body.base) &&
                airAbove(cast, m_plan.up, vented.trap, found->vent.reach) < vented.trap.volume)
                return found;
        }
        return std::nullopt;
    }

    void addBore(HalfBore bore) {
        bore.axis += 0.011 * m_nudge * bore.stations.front().radius * Vector2d(1, 0.7);
        bore.stations.front().height *= 1 - 0.01 * m_nudge;
        const double end = m_plan.blockEnd[bore.side == 1 ? 0 : 1];
        bore.stations.pop_back();
        constexpr double least = 0.2; // mm of the last piece
        while (bore.stations.size() > 2 && bore.stations.back().height > end - least)
            bore.stations.pop_back();
        const HalfBore::Station& last = bore.stations.back();
        bore.stations.push_back({end, last.radius + bore.flare * (end - last.height)});
        m_result.bores.push_back(std::move(bore));
    }

    bool joinAll() {
        JointRequest request{m_plan.rules.directions, m_plan.draftDegrees, m_plan.rules.grid, {}};
        std::vector<IndexedMesh> bodies;
        const auto addOpen = [&](const DraftedPrism& prism) {
            bodies.push_back(*prismSolid(prism));
            const std::vector<Vector3d> points = openingPoints(prism);
            request.openings.insert(request.openings.end(), points.begin(), points.end());
        };
        for (const Stub& stub : m_result.stubs)
            addOpen(stub.prism);
        for (const JoinedOverflow& overflow : m_result.overflows)
            addOpen(overflow.channel);
        for (const CavityVent& vent : m_result.vents)
            bodies.push_back(vent.solid());
        // They keep clear of each other: one joint for all.
        const std::optional<IndexedMesh> joined =
            bodies.empty() ? m_kind.cast : joinedSolid(m_kind.cast, {inOne(bodies)}, request);
        if (!joined)
            return false;
        m_result.stubVolume = volume(*joined) - m_kind.volume;
        m_result.solid = m_result.hollow = openedAt(*joined, request.openings);
        IndexedMesh cut = *joined;
        return cutBores(cut, HalfBore::Use::Spout, m_result.spoutVolume, request) &&
               cutBores(cut, HalfBore::Use::Pin, m_result.pinVolume, request);
    }

    /// The bores of one use; `taken`: mm³ that they take away.
    bool cutBores(IndexedMesh& solid, HalfBore::Use use, double& taken, JointRequest request) {
        std::vector<IndexedMesh> bodies;
        for (const HalfBore& bore : m_result.bores)
            if (bore.use == use)
                bodies.push_back(bore.solid(m_plan.rules.directions.of(bore.side), m_plan.rules.grid));
        if (bodies.empty())
            return true;
        request.bores = true;
        std::optional<IndexedMesh> cut = joinedSolid(solid, {inOne(bodies)}, request);
        if (!cut)
            return false;
        taken = volume(*cut) - volume(solid);
        solid = *std::move(cut);
        m_result.hollow = openedAt(solid, request.openings);
        return true;
    }

    const CavityKind& m_kind;
    const CavityFeatures& m_features;
    const JointPlan& m_plan;
    std::vector<CavityOutline> m_outlines; ///< the inlet being +y
    ThroughVents m_through;
    int m_nudge = 0;
    JoinedCavity m_result;
};

} // namespace

Result<JoinedCavity> plannedCavity(const CavityKind& kind, const CavityFeatures& features,
                                   const JointPlan& plan) {
    return Joiner(kind, features, plan).planned(0);
}

Result<JoinedCavity> joinedCavity(const CavityKind& kind, const CavityFeatures& features,
                                  const JointPlan& plan) {
    return Joiner(kind, features, plan).joined();
}

} // namespace moldwright
