// SPDX-License-Identifier: AGPL-3.0-or-later
// The builder's stage that finds wells beside the cavities, and what of them goes into the list of features.
#include "mesh/measures.h"
#include "mold/channel_room.h"
#include "mold/mold_builder.h"
#include "mold/overflows.h"

#include <numeric>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr const char* overflowName = "Overflow";
constexpr double far = 1e4; // mm: beyond any mold

std::vector<std::pair<std::string, double>> sizesOf(const JoinedOverflow& overflow, double diameter) {
    return {{"volume", volume(*prismSolid(overflow.well))},
            {"diameter", diameter},
            {"height_1", overflow.well.height[0]},
            {"height_2", overflow.well.height[1]}};
}

} // namespace

Result<void> MoldBuilder::findOverflows() {
    const MoldSettings& settings = m_mold.settings;
    m_overflows.assign(kinds().size(), {});
    if (settings.overflows.count == 0)
        return {};
    if (!settings.spout.on)
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold", "Overflows need a spout: without one nothing tells where material "
                                       "arrives last."));
    int number = 0;
    for (std::size_t kind = 0; kind < kinds().size(); ++kind) {
        Result<std::vector<Overflow>> found =
            overflowsOf(kinds()[kind], (*m_entries)[kind], {&settings, number, besideOverflows(kind)});
        if (!found)
            return std::unexpected(found.error());
        m_overflows[kind] = *std::move(found);
        number += overflowCount(kinds()[kind], settings.overflows);
    }
    return {};
}

/// Channels, vents, other cavities and what stands by hand, in the kind's coordinates.
std::vector<PlanShape> MoldBuilder::besideOverflows(std::size_t kind) const {
    const MoldSettings& settings = m_mold.settings;
    std::vector<PlanShape> beside;
    const double half = (spoutEach() ? widestOfSpout() : star() ? m_widths.runner : m_widths.gate) / 2;
    const auto addWays = [&](std::size_t of, const Vector2d& by) {
        const CavityFeatures& entries = (*m_entries)[of];
        for (const Gate& gate : entries.gates) {
            beside.push_back(movedPlan(gateFoot(kinds()[of], gate), by));
            beside.push_back(movedPlan(wayFrom(kinds()[of], gate.tip, half, far), by));
        }
        for (const VentedTrap& vented : entries.traps)
            if (const auto top = topInPlane(kinds()[of], vented, up()); top && inPlane() && !inOnePrism())
                beside.push_back(movedPlan(wayFrom(kinds()[of], *top, settings.vents.diameter / 2, far), by));
    };
    addWays(kind, Vector2d::Zero());
    for (const CavityCopy& copy : m_layout.copies) {
        if (isFree() && copy.kind != kind) {
            const Vector2d by = copy.offset - m_layout.copies[kind].offset;
            beside.push_back(movedPlan(kinds()[copy.kind].hull, by));
            for (const Overflow& other : m_overflows[copy.kind])
                beside.push_back(movedPlan(overflowWell(other, settings.overflows), by));
            addWays(copy.kind, by);
        }
        for (const PlacedFeature& feature : settings.placed)
            if (copy.kind != kind)
                continue;
            else if (feature.kind == Placeable::Bolt && feature.number < settings.bolts.count)
                beside.push_back(movedPlan(boltRoom(settings.bolts, feature.place), -copy.offset));
            else if (feature.kind == Placeable::Key && feature.number < settings.keys.count)
                beside.push_back(movedPlan(
                    keyRoom(settings.keys, m_mold.directions, feature.number, feature.place), -copy.offset));
    }
    return beside;
}

std::vector<PlanShape> MoldBuilder::overflowShapes(const CavityCopy& copy) const {
    std::vector<PlanShape> shapes;
    for (const Overflow& overflow : m_overflows[copy.kind])
        for (const PlanShape& shape : {overflowChannel(overflow, m_mold.settings.overflows),
                                       overflowWell(overflow, m_mold.settings.overflows)})
            shapes.push_back(movedPlan(shape, copy.offset));
    return shapes;
}

void MoldBuilder::listOverflows(const CavityCopy& copy) {
    const double diameter = m_mold.settings.overflows.diameter;
    for (const JoinedOverflow& overflow : m_joined[copy.kind].overflows) {
        const PlanShape& well = overflow.well.base;
        const Vector2d middle =
            std::accumulate(well.begin(), well.end(), Vector2d(0, 0)) / static_cast<double>(well.size()) +
            copy.offset;
        addPlaceable({"overflow", overflowName, {middle.x(), middle.y(), 0}, sizesOf(overflow, diameter), {}},
                     {Placeable::Overflow, overflow.number, overflow.stands}, movedPlan(well, copy.offset),
                     copy.offset);
    }
}

/// A well is measured against all but its own channel, and that against all but the cavity and the well.
void MoldBuilder::addOverflows(std::vector<Hollow>& all) const {
    int joint = static_cast<int>(m_layout.copies.size());
    for (std::size_t kind = 0; kind < kinds().size(); ++kind)
        for (const JoinedOverflow& overflow : m_joined[kind].overflows) {
            const auto channel = std::make_shared<const IndexedMesh>(*prismSolid(overflow.channel));
            const auto well = std::make_shared<const IndexedMesh>(*prismSolid(overflow.well));
            const bool byHand = isByHand(Placeable::Overflow, overflow.number);
            for (std::size_t c = 0; c < m_layout.copies.size(); ++c) {
                const CavityCopy& copy = m_layout.copies[c];
                if (copy.kind != kind)
                    continue;
                const int own = ++joint;
                all.push_back(
                    {overflowName, well, copy.offset, {own}, false, overflow.number + 1, true, byHand});
                all.push_back({"Overflow's channel",
                               channel,
                               copy.offset,
                               {own, static_cast<int>(c)},
                               false,
                               overflow.number + 1,
                               true,
                               byHand});
            }
        }
}

Result<void> MoldBuilder::addOverflowSurfaces(int side, HalfSurfaces& half,
                                              std::vector<PlacedSurface>& solids) const {
    for (std::size_t kind = 0; kind < kinds().size(); ++kind)
        for (const JoinedOverflow& overflow : m_joined[kind].overflows) {
            std::optional<IndexedMesh> surface = prismSurface(overflow.well, side, {{0, &overflow.channel}});
            if (!surface)
                return failure(ErrorCode::Impossible,
                               MW_TEXT("Mold", "The channel of overflow {0} has no room in the wall of its "
                                               "well. Make the channel narrower or the well wider."),
                               {std::to_string(overflow.number + 1)});
            const auto mesh = std::make_shared<const IndexedMesh>(*std::move(surface));
            for (const CavityCopy& copy : m_layout.copies)
                if (copy.kind == kind) {
                    half.voids.push_back({mesh, copy.offset});
                    solids.push_back(half.voids.back());
                }
        }
    return {};
}

} // namespace moldwright
