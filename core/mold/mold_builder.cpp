// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_builder.h"

#include "castability/parting_curves.h"
#include "castability/placed_cast.h"
#include "mesh/measures.h"
#include "mold/mold_proof.h"
#include "mold/shrink.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A power of two that all coordinates of a mold of this half size are multiples of, as floats.
double gridFor(double halfSize) {
    return std::ldexp(1.0, static_cast<int>(std::ceil(std::log2(halfSize))) - 24);
}

/// More than a mold can reach from its middle, mm.
double farthestReach(const MoldSettings& settings, double castSize) {
    const LayoutSettings& layout = settings.layout;
    const double cell = castSize + 2 * layout.spacing + 2 * settings.spout.diameter;
    const double across = std::max(layout.rows, layout.columns) * cell / 2;
    const double round = settings.wall + settings.floor + settings.ceiling + settings.step +
                         2 * settings.spout.funnel + 4 * settings.keys.diameter + 40;
    return across + round;
}

} // namespace

MoldBuilder::MoldBuilder(const MoldSettings& settings, double draftDegrees) {
    m_mold.settings = settings;
    m_mold.draftDegrees = draftDegrees;
}

Result<void> MoldBuilder::place(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state) {
    const MoldSettings& settings = m_mold.settings;
    if (settings.vents.on && !settings.spout.on)
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold",
                               "Vents need a spout: without one nothing tells which way is up while the "
                               "mold is filled."));
    const Result<CompensatedCast> larger = compensated(cast, state, settings.shrink);
    if (!larger)
        return std::unexpected(larger.error());
    m_mold.shrinkFactors = larger->factors;
    m_grid = gridFor(farthestReach(settings, diagonal(larger->mesh)));
    PlacedCast placed = placeCast(larger->mesh, labels, larger->state, m_mold.draftDegrees, m_grid);
    m_mold.castCertificate = certify(placed.mesh, labels, placed.state, m_mold.draftDegrees);
    const Certificate& proof = m_mold.castCertificate;
    if (!proof.closedAndOutward || !proof.curvesSimpleAndNested)
        return failure(ErrorCode::BadInput,
                       MW_TEXT("Mold", "No mold can be built round this cast. {0} Finish the cast first."),
                       {proof.reason});
    if (larger->factors.minCoeff() != larger->factors.maxCoeff() && !proof.draftHolds)
        m_mold.notes.push_back("Shrinking differently along the axes turns faces: the draft falls to " +
                               readable(proof.worstDraftDegrees) + "°. Design the cast with " +
                               readable(2 * m_mold.draftDegrees - proof.worstDraftDegrees, 3) + "°.");
    int quarters = 0;
    if (inPlane())
        quarters = spout().pour == PourDirection::Automatic
                       ? bestQuarterTurn(placed.mesh, labels, spout().gate, settings.vents.smallestTrap)
                       : static_cast<int>(spout().pour) - 1;
    m_cast = quarterTurned(placed.mesh, quarters);
    m_labels = labels;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(radians(90.0 * quarters), Vector3d::UnitZ()));
    const auto turned = [&](const Vector3d& d) -> Vector3d {
        return quarterTurned({d.transpose(), {}}, quarters).point(0);
    };
    m_mold.directions = {turned(placed.state.directions.d1), turned(placed.state.directions.d2)};
    m_mold.partToMold = turn * placed.fromPart;
    return {};
}

Result<void> MoldBuilder::layOut() {
    const MoldSettings& settings = m_mold.settings;
    Result<std::vector<CavityKind>> kinds = cavityKinds(
        m_cast, m_labels, m_mold.directions, m_mold.draftDegrees, m_grid, settings.layout.alternation);
    if (!kinds)
        return std::unexpected(kinds.error());
    m_kinds = *std::move(kinds);
    const double depth = onPlaneTolerance(m_cast);
    const bool flips = settings.layout.alternation == Alternation::Flip;
    m_rules = {m_mold.directions,
               std::max(spout().draft, m_mold.draftDegrees + 1),
               {flips || m_cast.V.col(2).maxCoeff() > depth, flips || m_cast.V.col(2).minCoeff() < -depth},
               m_grid};
    RunnerRoom room;
    if (inPlane()) {
        const Result<ChannelWidths> widths = ChannelWidths::of(spout(), m_rules);
        if (!widths)
            return std::unexpected(widths.error());
        m_widths = *widths;
        room = m_widths.room();
        // A gate at a cavity's very edge stays clear of the main runner.
        room.main += 2 * std::max(0.0, m_widths.gate / 2 + m_widths.beside - settings.layout.spacing + 1);
    }
    for (std::size_t kind = 0; kind < m_kinds.size(); ++kind)
        if (Result<void> done = placeEntries(kind); !done)
            return done;
    m_layout = layoutOf(m_kinds, settings.layout, room);
    m_mold.cavities = static_cast<int>(m_layout.copies.size());
    m_mold.partToMold.pretranslate(
        Vector3d(m_layout.copies.front().offset.x(), m_layout.copies.front().offset.y(), 0));
    return {};
}

/// Where the kind is filled, what air stays then, and where it is pushed out.
Result<void> MoldBuilder::placeEntries(std::size_t kind) {
    const IndexedMesh& cast = m_kinds[kind].cast;
    m_gates.emplace_back();
    m_traps.emplace_back();
    m_bores.emplace_back();
    std::vector<int> drains;
    if (inPlane()) {
        m_gates.back() = gatesOf(cast, m_kinds[kind].labels, Vector2d::UnitY(), m_widths.gate);
        drains = drainsOf(m_gates.back());
    }
    if (lying()) {
        Result<std::vector<int>> points = placeSpouts(kind);
        if (!points)
            return std::unexpected(points.error());
        drains = *std::move(points);
    }
    if (m_mold.settings.vents.on)
        m_traps.back() = trapsOf(cast, drains, up(), m_mold.settings.vents.smallestTrap);
    return m_mold.settings.ejectors.count > 0 ? placeEjectors(kind) : Result<void>();
}

Result<std::vector<int>> MoldBuilder::placeSpouts(std::size_t kind) {
    const Result<std::vector<BorePlace>> places = spoutPlaces(m_kinds[kind], m_mold.directions, spout().neck);
    if (!places)
        return std::unexpected(places.error());
    std::vector<int> drains;
    for (const BorePlace& place : *places) {
        // Thinnest where it meets the cavity; from there on it widens, so that it can be pushed out.
        const double neck = spout().neck / 2;
        const double full = std::max(spout().diameter / 2, neck + 0.5);
        constexpr double neckLength = 1; // mm
        HalfBore bore{"Spout", 1, place.axis, {}, std::tan(radians(m_rules.draftDegrees)), place.tip};
        bore.stations = {{place.inside, 0.8 * neck},
                         {place.tip, neck},
                         {place.tip + neckLength, neck + 0.2},
                         {place.tip + neckLength + full - neck, full},
                         {0, full}};
        const Vector3d entry = bore.at(place.tip, m_mold.directions.d1);
        Eigen::Index nearest = 0;
        (m_kinds[kind].cast.V.rowwise() - entry.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
        drains.push_back(static_cast<int>(nearest));
        m_bores[kind].push_back(std::move(bore));
    }
    return drains;
}

Result<void> MoldBuilder::placeEjectors(std::size_t kind) {
    const EjectorSettings& ejectors = m_mold.settings.ejectors;
    const auto plan = [&](int v) -> Vector2d { return m_kinds[kind].cast.V.row(v).head<2>(); };
    std::vector<std::pair<Vector2d, double>> keepOff;
    for (const Gate& gate : m_gates[kind])
        keepOff.emplace_back(plan(gate.point), gate.drop + m_widths.gate / 2);
    for (const AirTrap& trap : m_traps[kind])
        keepOff.emplace_back(plan(trap.point), 2 * m_mold.settings.vents.diameter);
    for (const HalfBore& bore : m_bores[kind])
        if (bore.side == ejectors.side)
            keepOff.emplace_back(bore.axis, spout().diameter);
    const Result<std::vector<BorePlace>> places =
        ejectorPlaces(m_kinds[kind], m_mold.directions, ejectors, m_mold.settings.leastSteel, keepOff);
    if (!places)
        return std::unexpected(places.error());
    for (const BorePlace& place : *places) {
        const double radius = ejectors.diameter / 2;
        m_bores[kind].push_back(
            {"Ejector hole", ejectors.side, place.axis, {{place.inside, radius}, {0, radius}}, 0, place.tip});
    }
    return {};
}

Result<void> MoldBuilder::join() {
    const MoldSettings& settings = m_mold.settings;
    JointPlan plan;
    plan.settings = &settings;
    plan.rules = m_rules;
    plan.widths = m_widths;
    plan.draftDegrees = m_mold.draftDegrees;
    plan.up = up();
    plan.spout = single();
    plan.blockEnd = {m_block.max().z(), -m_block.min().z()};
    if (inPlane()) {
        const Result<std::array<double, 2>> slope = m_rules.slope(-Vector2d::UnitY());
        if (!slope)
            return std::unexpected(slope.error());
        plan.line = single() ? m_end.line : m_layout.runnerOverKind - m_widths.runner / 2;
        plan.slope = single() ? std::array{0.0, 0.0} : *slope;
    }
    for (std::size_t kind = 0; kind < m_kinds.size(); ++kind) {
        Result<JoinedCavity> joined =
            joinedCavity(m_kinds[kind], {m_gates[kind], m_traps[kind], m_bores[kind]}, plan);
        if (!joined)
            return std::unexpected(joined.error());
        m_joined.push_back(*std::move(joined));
        m_stubs.push_back(m_joined.back().stubs);
    }
    if (inPlane() && !single()) {
        Result<RunnerNet> net = runnerNet(m_layout, m_stubs, spout(), m_widths, m_rules, m_end);
        if (!net)
            return std::unexpected(net.error());
        m_net = *std::move(net);
    }
    return addTails();
}

/// What opens into the block's face: the spout, and a single cavity's vents.
Result<void> MoldBuilder::addTails() {
    if (!inPlane())
        return {};
    std::vector<const DraftedPrism*> ends;
    if (single())
        for (const Stub& stub : m_stubs.front())
            ends.push_back(&stub.prism);
    else
        ends.push_back(&m_net.channels.front().prism);
    for (const DraftedPrism* end : ends)
        for (const bool closed : {true, false}) {
            Result<DraftedPrism> tail = tailOf(*end, m_rules, m_end, closed);
            if (!tail)
                return std::unexpected(tail.error());
            (closed ? m_closedTails : m_openTails).push_back(*std::move(tail));
        }
    return {};
}

Result<void> MoldBuilder::prove() {
    proveMold(m_mold);
    return {};
}

} // namespace moldwright
