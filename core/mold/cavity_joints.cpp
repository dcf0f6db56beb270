// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/cavity_joints.h"

#include "castability/parting_curves.h"
#include "features/joined_channel.h"
#include "mesh/measures.h"
#include "mold/free_place.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double heightOverWidth = 0.4;
constexpr int attempts = 10;

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
    Joiner(const CavityKind& kind, const JointPlan& plan) : m_kind(kind), m_plan(plan) {
        const auto curves = partingCurves(kind.cast, kind.labels);
        for (const PartingCurve& curve : *curves) {
            PlanShape outline;
            for (const int v : curve)
                outline.emplace_back(kind.cast.V.row(v).head<2>().transpose());
            m_outlines.push_back(std::move(outline));
        }
    }

    Result<JoinedCavity> join(const CavityFeatures& features) {
        m_bores = &features.bores;
        for (int attempt = 0; attempt < attempts; ++attempt) {
            m_nudge = attempt;
            m_result = {};
            for (const Gate& gate : features.gates)
                if (Result<void> done = addGate(gate); !done)
                    return std::unexpected(done.error());
            for (const AirTrap& trap : features.traps)
                vent(trap);
            for (const HalfBore& bore : features.bores)
                addBore(bore);
            if (joinAll())
                return std::move(m_result);
        }
        Error error;
        error.code = ErrorCode::Impossible;
        error.message = {
            MW_TEXT("Mold", "The channels could not be joined to the cavity soundly at any of {0} nearby "
                            "places. Another pour direction or gate width may help."),
            {std::to_string(attempts)}};
        for (const Gate& gate : features.gates)
            error.places.push_back(m_kind.cast.point(gate.point));
        return std::unexpected(error);
    }

private:
    [[nodiscard]] double nudged(double value, double width) const {
        return value + width * 0.011 * (m_nudge % 2 == 0 ? m_nudge : -m_nudge);
    }

    Result<void> addGate(const Gate& gate) {
        const double width = m_plan.widths.gate * (1 - 0.013 * m_nudge);
        const Vector3d tip = m_kind.cast.point(gate.point);
        const double axis = nudged(tip.x(), width);
        const double bottom = tip.y() - gate.drop * (1 + 0.03 * m_nudge);
        PlanShape shape = m_plan.spout
                              ? spoutShape(axis, bottom, width, tip.y() + m_plan.settings->layout.spacing / 2,
                                           m_plan.line, m_plan.widths.straight(), m_plan.settings->spout)
                              : planRectangle({axis - width / 2, bottom}, {axis + width / 2, m_plan.line});
        if (!wayIsFree(shape, tip.y() + 0.5)) {
            Error error;
            error.code = ErrorCode::Impossible;
            error.message.text =
                MW_TEXT("Mold", "The way from a cavity's gate to the runner passes through another "
                                "part of the cavity. Choose another pour direction.");
            error.places.push_back(tip);
            return std::unexpected(std::move(error));
        }
        return add(std::move(shape), m_plan.spout ? m_plan.settings->spout.diameter : width,
                   m_plan.spout ? "Spout" : "Gate", false);
    }

    /// Whether a channel keeps clear of all outlines from `above` on.
    [[nodiscard]] bool wayIsFree(const PlanShape& shape, double above) const {
        PlanShape rest = shape;
        for (Vector2d& p : rest)
            p.y() = std::max(p.y(), above);
        rest.erase(std::unique(rest.begin(), rest.end()), rest.end());
        return rest.size() < 3 ||
               std::none_of(
                   m_outlines.begin(), m_outlines.end(),
                   [&](const PlanShape& outline) { return planDistance(rest, outline) == 0; });
    }

    Result<void> add(PlanShape shape, double width, const char* name, bool isVent) {
        const std::size_t top = shape.size() / 2;
        Result<DraftedPrism> prism =
            m_plan.rules.prism(std::move(shape), heightOverWidth * width, {{top, m_plan.slope}});
        if (!prism)
            return std::unexpected(prism.error());
        m_result.stubs.push_back({*std::move(prism), name, isVent});
        return {};
    }

    [[nodiscard]] bool standing() const { return m_plan.up.z() == 0; }

    void vent(const AirTrap& trap) {
        if (!(standing() && ventInPlane(trap)) && !ventThrough(trap))
            m_result.remaining.push_back({m_kind.cast.point(trap.point), trap.volume});
    }

    /// From the trap's highest point of the parting line straight up, where that leaves little air.
    bool ventInPlane(const AirTrap& trap) {
        const VentSettings& vents = m_plan.settings->vents;
        const IndexedMesh& cast = m_kind.cast;
        int best = -1;
        for (const int v : trap.points)
            if (cast.V(v, 2) == 0 && (best < 0 || cast.V(v, 1) > cast.V(best, 1)))
                best = v;
        if (best < 0 || airAbove(cast, Vector3d::UnitY(), trap, cast.V(best, 1)) > vents.smallestTrap)
            return false;
        const double width = vents.diameter * (1 + 0.02 * m_nudge);
        const double axis = nudged(cast.V(best, 0), width);
        PlanShape shape =
            planRectangle({axis - width / 2, cast.V(best, 1) - width}, {axis + width / 2, m_plan.line});
        if (!wayIsFree(shape, cast.V(best, 1) + 0.3) || !keepsClear(shape))
            return false;
        return add(std::move(shape), width, "Vent", true).has_value();
    }

    /// Of the channels there are so far.
    [[nodiscard]] bool keepsClear(const PlanShape& shape) const {
        const double steel = m_plan.settings->leastSteel;
        const auto clear = [&](const PlanShape& other) { return planDistance(shape, other) >= steel; };
        return std::all_of(m_result.stubs.begin(), m_result.stubs.end(),
                           [&](const Stub& stub) { return clear(stub.prism.base); }) &&
               std::all_of(m_result.vents.begin(), m_result.vents.end(),
                           [&](const ThroughVent& other) { return clear(other.body.base); }) &&
               std::all_of(m_bores->begin(), m_bores->end(), [&](const HalfBore& bore) {
                   return clear(planCircle(bore.axis, bore.stations.back().radius, circleCorners));
               });
    }

    bool ventThrough(const AirTrap& trap) {
        const Vector3d top = m_kind.cast.point(trap.point);
        const int side = top.z() >= 0 ? 1 : 2;
        ThroughVentRequest request;
        request.diameter = m_plan.settings->vents.diameter * (1 + 0.02 * m_nudge);
        request.end = m_plan.blockEnd[side == 1 ? 0 : 1];
        // More than the mold's draft, so that rounding at the joint cannot take it away.
        request.draftDegrees = m_plan.draftDegrees + 0.5;
        request.grid = m_plan.rules.grid;
        std::optional<ThroughVent> found =
            throughVent(m_kind.cast, m_kind.labels, m_plan.rules.directions, side, top, m_plan.up, request);
        if (!found || !keepsClear(found->body.base))
            return false;
        const double left = airAbove(m_kind.cast, m_plan.up, trap, found->reach);
        if (left > m_plan.settings->vents.smallestTrap)
            m_result.remaining.push_back({top, left});
        m_result.vents.push_back(*std::move(found));
        return true;
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
        for (const Stub& stub : m_result.stubs) {
            bodies.push_back(*prismSolid(stub.prism));
            const std::vector<Vector3d> points = openingPoints(stub.prism);
            request.openings.insert(request.openings.end(), points.begin(), points.end());
        }
        for (const ThroughVent& vent : m_result.vents)
            bodies.push_back(vent.solid());
        // They keep clear of each other: one joint for all.
        const std::optional<IndexedMesh> joined =
            bodies.empty() ? m_kind.cast : joinedSolid(m_kind.cast, {inOne(bodies)}, request);
        if (!joined)
            return false;
        m_result.stubVolume = volume(*joined) - volume(m_kind.cast);
        m_result.solid = m_result.hollow = openedAt(*joined, request.openings);
        IndexedMesh cut = *joined;
        return cutBores(cut, "Spout", m_result.spoutVolume, request) &&
               cutBores(cut, "Ejector hole", m_result.pinVolume, request);
    }

    /// The bores of one name; `taken`: mm³ that they take away.
    bool cutBores(IndexedMesh& solid, const std::string& name, double& taken, JointRequest request) {
        std::vector<IndexedMesh> bodies;
        for (const HalfBore& bore : m_result.bores)
            if (bore.name == name)
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
    const JointPlan& m_plan;
    std::vector<PlanShape> m_outlines;
    const std::vector<HalfBore>* m_bores = nullptr;
    int m_nudge = 0;
    JoinedCavity m_result;
};

} // namespace

Result<JoinedCavity> joinedCavity(const CavityKind& kind, const CavityFeatures& features,
                                  const JointPlan& plan) {
    return Joiner(kind, plan).join(features);
}

} // namespace moldwright
