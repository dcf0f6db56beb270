// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_builder.h"

#include "mold/balanced_runners.h"
#include "mold/circle_layout.h"
#include "mold/free_layout.h"
#include "mold/material_choice.h"
#include "mold/mold_proof.h"
#include "mold/overflows.h"
#include "mold/star_runners.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

using Eigen::Vector2d;
using Eigen::Vector3d;

MoldBuilder::MoldBuilder(const MoldSettings& settings, double draftDegrees)
    : m_trees(std::make_shared<SteelTrees>()) {
    m_mold.settings = settings;
    m_mold.draftDegrees = draftDegrees;
    m_mold.notes = materialNotes(settings, draftDegrees);
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
    if (const auto mouth = placeByHand(settings.placed, Placeable::Spout, 0);
        mouth && !single() && !inOnePrism())
        m_layout.mainAxis = mouth->x();
    tellOfSpoutByHand();
    m_mold.cavities = static_cast<int>(m_layout.copies.size());
    for (std::size_t part = 0; part < m_mold.parts.size(); ++part) {
        const auto first = std::ranges::find(m_layout.copies, part,
                                             [&](const CavityCopy& copy) { return kinds()[copy.kind].part; });
        m_mold.parts[part].toMold.pretranslate(Vector3d(first->offset.x(), first->offset.y(), 0));
    }
    m_mold.partToMold = m_mold.parts.front().toMold;
    return {};
}

Result<Layout> MoldBuilder::layoutAsked() const {
    const LayoutSettings& settings = m_seats.layout;
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
        return balancedLayout(kinds(), kindAt(), roomy, m_widths);
    RunnerRoom room;
    if (inPlane()) {
        room = m_widths.room();
        // A gate at a cavity's very edge stays clear of the main runner.
        room.main += 2 * std::max(0.0, m_widths.gate / 2 + m_widths.beside - settings.spacing + 1);
    }
    return layoutOf(kinds(), kindAt(), roomy, room);
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
    tellOfNarrowGates();
    return {};
}

void MoldBuilder::tellOfNarrowGates() {
    double narrowest = m_widths.gate;
    for (const CavityFeatures& features : *m_entries)
        for (const Gate& gate : features.gates)
            narrowest = std::min(narrowest, gate.width);
    if (narrowest < m_widths.gate)
        m_mold.notes.push_back(
            {MW_TEXT("Mold", "A gate {0} mm wide would be wider than the cavity where it is filled: there it "
                             "is {1} mm wide."),
             {readable(m_widths.gate, 3), readable(narrowest, 3)}});
}

/// All ways are of one length only from where the runners part.
void MoldBuilder::tellOfSpoutByHand() {
    if (!inOnePrism() || !inPlane() || !isByHand(Placeable::Spout, 0))
        return;
    m_mold.notes.push_back(
        {MW_TEXT("Mold",
                 "The spout stands at x = {0} mm, not where it was put: only from there all ways "
                 "to the cavities are of one length. It can be moved where rows have the shortest runners."),
         {readable(star() ? m_layout.hub.x() : m_layout.tree->at.x(), 3)}});
}

double MoldBuilder::endOfStubs(std::size_t kind) const {
    if (spoutEach())
        return m_end.line - m_layout.copies[std::min(kind, m_layout.copies.size() - 1)].offset.y();
    if (!star())
        return m_layout.runnerOverKind[kind] - m_widths.runner / 2;
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
