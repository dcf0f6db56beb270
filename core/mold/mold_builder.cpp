// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_builder.h"

#include "castability/parting_curves.h"
#include "castability/placed_cast.h"
#include "mesh/measures.h"
#include "mold/balanced_runners.h"
#include "mold/circle_layout.h"
#include "mold/free_layout.h"
#include "mold/mold_proof.h"
#include "mold/overflows.h"
#include "mold/shrink.h"
#include "mold/star_runners.h"

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
    const double cell = castSize + 2 * spacingWithOverflows(settings) + 2 * settings.spout.diameter;
    double cavities = std::max(layout.rows, layout.columns) * cell / 2;
    if (layout.arrangement == Arrangement::Circle)
        cavities = (layout.rows * layout.columns / 2.0 + 2) * (cell + settings.spout.funnel);
    if (layout.arrangement == Arrangement::Free) {
        Eigen::AlignedBox2d box;
        for (const CavityPlace& place : layout.places)
            box.extend(Vector2d(place.x, place.y));
        cavities = cell + (box.isEmpty() ? 0 : box.sizes().maxCoeff());
    }
    return {cavities, settings.wall + settings.floor + settings.ceiling + settings.step +
                          2 * settings.spout.funnel + 4 * settings.keys.diameter + 40};
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
        m_mold.notes.push_back(
            {MW_TEXT("Mold",
                     "Shrinking differently along the axes turns faces: the draft falls to {0}°. Design the "
                     "cast with {1}°."),
             {readable(proof.worstDraftDegrees),
              readable(2 * m_mold.draftDegrees - proof.worstDraftDegrees, 3)}});
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

Result<std::vector<CavityKind>> MoldBuilder::kindsAsked() const {
    const LayoutSettings& layout = m_mold.settings.layout;
    const Directions& directions = m_mold.directions;
    const double draft = m_mold.draftDegrees;
    if ((star() || isFree()) && layout.alternation != Alternation::None)
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold",
                               "Every second cavity can be another one in rows only, not on a circle or "
                               "in a free layout."));
    if (isFree())
        return kindsAtPlaces(m_cast, m_labels, directions, draft, m_grid, layout.places);
    if (star())
        return kindsRound(m_cast, m_labels, directions, draft, m_grid, layout.rows * layout.columns);
    return cavityKinds(m_cast, m_labels, directions, draft, m_grid, layout.alternation);
}

Result<void> MoldBuilder::makeKinds() {
    const MoldSettings& settings = m_mold.settings;
    Result<std::vector<CavityKind>> kinds = kindsAsked();
    if (!kinds)
        return std::unexpected(kinds.error());
    if (star() && std::all_of(kinds->begin(), kinds->end(), [](const CavityKind& k) { return k.turn == 0; }))
        m_mold.notes.push_back(
            {MW_TEXT("Mold",
                     "The removal directions do not allow turned copies: on the circle they are only moved, "
                     "and each is filled on another of its sides."),
             {}});
    m_mold.partToMold.prerotate(Eigen::AngleAxisd(kinds->front().turn, Vector3d::UnitZ()));
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
    if (inPlane()) {
        const Result<ChannelWidths> widths = ChannelWidths::of(spout(), m_rules);
        if (!widths)
            return std::unexpected(widths.error());
        m_widths = *widths;
    }
    Result<Layout> layout = layoutAsked();
    if (!layout)
        return std::unexpected(layout.error());
    m_layout = *std::move(layout);
    if (const auto mouth = placeByHand(settings.placed, Placeable::Spout, 0); mouth && !single())
        m_layout.mainAxis = mouth->x();
    m_mold.cavities = static_cast<int>(m_layout.copies.size());
    m_mold.partToMold.pretranslate(
        Vector3d(m_layout.copies.front().offset.x(), m_layout.copies.front().offset.y(), 0));
    return {};
}

Result<Layout> MoldBuilder::layoutAsked() const {
    const LayoutSettings& settings = m_mold.settings.layout;
    if (star())
        return layoutOnCircle();
    if (isFree()) {
        std::vector<std::vector<Vector2d>> tips;
        for (const CavityKind& kind : kinds()) {
            tips.emplace_back();
            for (const Gate& gate : gatesAtInlet(kind, m_widths.gate))
                tips.back().push_back(gate.tip);
        }
        return freeLayout(kinds(), settings.places, tips, inPlane() ? widestOfSpout() : 0,
                          m_mold.settings.leastSteel);
    }
    LayoutSettings roomy = settings;
    roomy.spacing = spacingWithOverflows(m_mold.settings);
    if (balanced())
        return balancedLayout(kinds(), roomy, m_widths);
    RunnerRoom room;
    if (inPlane()) {
        room = m_widths.room();
        // A gate at a cavity's very edge stays clear of the main runner.
        room.main += 2 * std::max(0.0, m_widths.gate / 2 + m_widths.beside - settings.spacing + 1);
    }
    return layoutOf(kinds(), roomy, room);
}

Result<Layout> MoldBuilder::layoutOnCircle() const {
    std::vector<Vector2d> tips;
    for (const CavityKind& kind : kinds()) {
        const std::vector<Gate> gates = gatesAtInlet(kind, std::max(m_widths.gate, 1.0));
        if (inPlane() && gates.size() > 1)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "On a circle each cavity is filled at one place, from the middle. This "
                                   "cast is of {0} solids: arrange it in rows, or fill it through half 1."),
                           {std::to_string(gates.size())});
        tips.push_back(gates.front().tip);
    }
    StarRoom room;
    if (inPlane())
        room = {widestOfSpout(), m_widths.runner,
                starHub(static_cast<int>(kinds().size()), m_widths.runner, m_widths.main) +
                    2 * m_widths.beside};
    Layout layout = circleLayout(kinds(), tips, spacingWithOverflows(m_mold.settings), room);
    centreLayout(layout, kinds());
    return layout;
}

PlacedFeatures MoldBuilder::placedAtCavities() const {
    PlacedFeatures placed = m_mold.settings.placed;
    std::erase_if(placed, [this](const PlacedFeature& feature) {
        const bool spout = feature.kind == Placeable::Spout && (lying() || spoutEach());
        return !spout && feature.kind != Placeable::Vent && feature.kind != Placeable::Ejector;
    });
    return placed;
}

Result<void> MoldBuilder::findEntries() {
    EntryPlan plan;
    plan.settings = &m_mold.settings;
    plan.directions = m_mold.directions;
    plan.gate = m_widths.gate;
    plan.channelDraft = m_rules.draftDegrees;
    plan.up = up();
    plan.tellsAir = m_tellsAir;
    if (spoutEach())
        for (std::size_t kind = 0; kind < kinds().size(); ++kind)
            plan.cavityAt.push_back(m_layout.copies[std::min(kind, m_layout.copies.size() - 1)].offset);
    Result<std::vector<CavityFeatures>> entries = entriesOf(*m_shapes, plan);
    if (!entries)
        return std::unexpected(entries.error());
    m_entries = std::make_shared<const std::vector<CavityFeatures>>(*std::move(entries));
    return {};
}

double MoldBuilder::endOfStubs(std::size_t kind) const {
    if (spoutEach())
        return m_end.line - m_layout.copies[std::min(kind, m_layout.copies.size() - 1)].offset.y();
    if (!star())
        return m_layout.runnerOverKind - m_widths.runner / 2;
    const Vector2d armEnd = m_layout.hub + m_layout.armEnd * m_layout.arms[kind];
    return kinds()[kind].inlet.dot(armEnd - m_layout.copies[kind].offset);
}

/// In a free layout: the other cavities and what leads up from them, in the kind's coordinates.
std::vector<PlanShape> MoldBuilder::standingBeside(std::size_t kind) const {
    std::vector<PlanShape> others;
    for (const CavityCopy& copy : m_layout.copies) {
        if (copy.kind == kind)
            continue;
        const Vector2d by = copy.offset - m_layout.copies[kind].offset;
        others.push_back(movedPlan(kinds()[copy.kind].hull, by));
        const double half = widestOfSpout() / 2;
        for (const Gate& gate : (*m_entries)[copy.kind].gates)
            others.push_back(planRectangle({gate.tip.x() + by.x() - half, gate.tip.y() + by.y()},
                                           {gate.tip.x() + by.x() + half, endOfStubs(kind)}));
        if (copy.kind < m_stubs.size())
            for (const Stub& stub : m_stubs[copy.kind])
                others.push_back(movedPlan(stub.prism.base, by));
    }
    return others;
}

Result<JointPlan> MoldBuilder::jointPlan(std::size_t kind) const {
    JointPlan plan;
    plan.settings = &m_mold.settings;
    plan.rules = m_rules;
    plan.widths = m_widths;
    plan.draftDegrees = m_mold.draftDegrees;
    plan.up = up();
    plan.spout = spoutEach();
    plan.ventsInPlane = !inOnePrism();
    plan.overflows = m_overflows[kind];
    plan.blockEnd = {m_block.end(1), -m_block.end(2)};
    if (inPlane()) {
        const Result<std::array<double, 2>> slope = m_rules.slope(-kinds()[kind].inlet);
        if (!slope)
            return std::unexpected(slope.error());
        plan.line = endOfStubs(kind);
        plan.slope = spoutEach() ? std::array{0.0, 0.0} : *slope;
        if (isFree())
            plan.others = standingBeside(kind);
    }
    return plan;
}

Result<void> MoldBuilder::makeJoints(Result<JoinedCavity> (*joined)(const CavityKind&, const CavityFeatures&,
                                                                    const JointPlan&)) {
    for (std::size_t kind = 0; kind < kinds().size(); ++kind) {
        const Result<JointPlan> plan = jointPlan(kind);
        if (!plan)
            return std::unexpected(plan.error());
        Result<JoinedCavity> cavity = joined(kinds()[kind], (*m_entries)[kind], *plan);
        if (!cavity)
            return std::unexpected(cavity.error());
        m_joined.push_back(*std::move(cavity));
        m_stubs.push_back(m_joined.back().stubs);
    }
    if (inPlane() && !spoutEach()) {
        const auto lay = star() ? starNet : balanced() ? balancedNet : runnerNet;
        Result<RunnerNet> net = lay(m_layout, m_stubs, spout(), m_widths, m_rules, m_end);
        if (!net)
            return std::unexpected(net.error());
        m_net = *std::move(net);
    }
    return addTails();
}

/// What opens into the block's face: the spout, or each cavity's spouts and vents.
Result<void> MoldBuilder::addTails() {
    if (!inPlane())
        return {};
    std::vector<DraftedPrism> ends;
    if (spoutEach())
        for (const CavityCopy& copy : m_layout.copies)
            for (const Stub& stub : m_stubs[copy.kind])
                ends.push_back(movedPrism(stub.prism, copy.offset));
    else
        ends.push_back(m_net.channels.front().prism);
    for (const DraftedPrism& end : ends)
        for (const bool closed : {true, false}) {
            Result<DraftedPrism> tail = tailOf(end, m_rules, m_end, closed);
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
