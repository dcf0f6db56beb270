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

/// How far the cavities of a mold reach from its middle, and its block beyond them, at most; mm.
struct Reach {
    double cavities = 0;
    double round = 0;
};
Reach farthestReach(const MoldSettings& settings, double castSize) {
    const LayoutSettings& layout = settings.layout;
    const double cell = castSize + 2 * layout.spacing + 2 * settings.spout.diameter;
    return {std::max(layout.rows, layout.columns) * cell / 2,
            settings.wall + settings.floor + settings.ceiling + settings.step + 2 * settings.spout.funnel +
                4 * settings.keys.diameter + 40};
}

} // namespace

MoldBuilder::MoldBuilder(const MoldSettings& settings, double draftDegrees)
    : m_trees(std::make_shared<SteelTrees>()) {
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
    const Reach reach = farthestReach(settings, diagonal(larger->mesh));
    m_grid = gridFor(reach.cavities + reach.round);
    m_farthest = reach.cavities + reach.round / 2;
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

Result<void> MoldBuilder::makeKinds() {
    const MoldSettings& settings = m_mold.settings;
    Result<std::vector<CavityKind>> kinds = cavityKinds(
        m_cast, m_labels, m_mold.directions, m_mold.draftDegrees, m_grid, settings.layout.alternation);
    if (!kinds)
        return std::unexpected(kinds.error());
    const double depth = onPlaneTolerance(m_cast);
    const bool flips = settings.layout.alternation == Alternation::Flip;
    m_rules = {m_mold.directions,
               std::max(spout().draft, m_mold.draftDegrees + 1),
               {flips || m_cast.V.col(2).maxCoeff() > depth, flips || m_cast.V.col(2).minCoeff() < -depth},
               m_grid};
    m_cast = {};
    const auto shapes = std::make_shared<CavityShapes>();
    shapes->kinds = *std::move(kinds);
    shapes->findGrounds(settings, m_mold.directions);
    m_shapes = shapes;
    return setPlaced(settings.placed);
}

Result<void> MoldBuilder::setPlaced(const PlacedFeatures& placed) {
    for (const PlacedFeature& feature : placed)
        if (!(feature.place.cwiseAbs().maxCoeff() <= m_farthest))
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "No feature can stand {0} mm from the middle: blocks of this mold "
                                           "reach no farther than {1} mm."),
                           {readable(feature.place.cwiseAbs().maxCoeff()), readable(m_farthest)});
    m_mold.settings.placed = placed;
    return {};
}

bool MoldBuilder::isByHand(Placeable kind, int number) const {
    return placeByHand(m_mold.settings.placed, kind, number).has_value();
}

Result<void> MoldBuilder::layOut() {
    const MoldSettings& settings = m_mold.settings;
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
    m_layout = layoutOf(kinds(), settings.layout, room);
    if (const auto mouth = placeByHand(settings.placed, Placeable::Spout, 0); mouth && !single())
        m_layout.mainAxis = mouth->x();
    m_mold.cavities = static_cast<int>(m_layout.copies.size());
    m_mold.partToMold.pretranslate(
        Vector3d(m_layout.copies.front().offset.x(), m_layout.copies.front().offset.y(), 0));
    return {};
}

Result<void> MoldBuilder::findEntries() {
    EntryPlan plan;
    plan.settings = &m_mold.settings;
    plan.directions = m_mold.directions;
    plan.gate = m_widths.gate;
    plan.channelDraft = m_rules.draftDegrees;
    plan.up = up();
    plan.single = single();
    plan.cavityAt = m_layout.copies.front().offset;
    Result<std::vector<CavityFeatures>> entries = entriesOf(*m_shapes, plan);
    if (!entries)
        return std::unexpected(entries.error());
    m_entries = std::make_shared<const std::vector<CavityFeatures>>(*std::move(entries));
    return {};
}

Result<JointPlan> MoldBuilder::jointPlan() const {
    JointPlan plan;
    plan.settings = &m_mold.settings;
    plan.rules = m_rules;
    plan.widths = m_widths;
    plan.draftDegrees = m_mold.draftDegrees;
    plan.up = up();
    plan.spout = single();
    plan.blockEnd = {m_block.end(1), -m_block.end(2)};
    if (inPlane()) {
        const Result<std::array<double, 2>> slope = m_rules.slope(-Vector2d::UnitY());
        if (!slope)
            return std::unexpected(slope.error());
        plan.line = single() ? m_end.line : m_layout.runnerOverKind - m_widths.runner / 2;
        plan.slope = single() ? std::array{0.0, 0.0} : *slope;
    }
    return plan;
}

Result<void> MoldBuilder::makeJoints(Result<JoinedCavity> (*joined)(const CavityKind&, const CavityFeatures&,
                                                                    const JointPlan&)) {
    const Result<JointPlan> plan = jointPlan();
    if (!plan)
        return std::unexpected(plan.error());
    for (std::size_t kind = 0; kind < kinds().size(); ++kind) {
        Result<JoinedCavity> cavity = joined(kinds()[kind], (*m_entries)[kind], *plan);
        if (!cavity)
            return std::unexpected(cavity.error());
        m_joined.push_back(*std::move(cavity));
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

std::vector<PlanShape> MoldBuilder::partingLines() const {
    std::vector<PlanShape> lines;
    for (const CavityCopy& copy : m_layout.copies)
        for (const CavityOutline& outline : kinds()[copy.kind].outlines)
            lines.push_back(movedPlan(outline.shape, copy.offset));
    return lines;
}

Result<void> MoldBuilder::prove() {
    proveMold(m_mold, m_block);
    return {};
}

} // namespace moldwright
