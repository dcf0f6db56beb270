// SPDX-License-Identifier: AGPL-3.0-or-later
// The builder's stage that finds room: a block that has place for all that stands in the plane.
#include "mold/balanced_runners.h"
#include "mold/circle_layout.h"
#include "mold/mold_builder.h"
#include "mold/star_runners.h"

#include <algorithm>

namespace moldwright {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

std::vector<MoldBuilder::OutwardHole> MoldBuilder::outwardHoles(const CavityCopy& copy) const {
    std::vector<OutwardHole> holes;
    const Vector3d by(copy.offset.x(), copy.offset.y(), 0);
    for (const HalfBore& bore : (*m_entries)[copy.kind].bores) {
        double widest = 0;
        for (const HalfBore::Station& station : bore.stations)
            widest = std::max(widest, station.radius);
        const double foot = bore.stations.front().height;
        // A flare's end is known when the block is: twice as wide is more than it will be.
        holes.push_back({bore.at(foot, m_mold.directions.of(bore.side)) + by, bore.side,
                         bore.flare > 0 ? 2 * widest : widest});
    }
    if (m_mold.settings.vents.on)
        for (const VentedTrap& vented : (*m_entries)[copy.kind].traps)
            holes.push_back({vented.top + by, vented.top.z() >= 0 ? 1 : 2, m_mold.settings.vents.diameter});
    return holes;
}

Vector3d MoldBuilder::mouthOf(const OutwardHole& hole, double end) const {
    const Vector3d& d = m_mold.directions.of(hole.side);
    return hole.foot + d * ((end - hole.foot.z()) / d.z());
}

Obstacles MoldBuilder::planObstacles(const Block& block) const {
    Obstacles obstacles;
    for (const CavityCopy& copy : m_layout.copies) {
        obstacles.push_back(movedPlan(kinds()[copy.kind].hull, copy.offset));
        for (PlanShape& shape : overflowShapes(copy))
            obstacles.push_back(std::move(shape));
        for (const OutwardHole& hole : outwardHoles(copy)) {
            // Oblique ones pass over the plane beside the cavity.
            Points ends(2 * circleCorners, 3);
            int row = 0;
            for (const Vector3d& end : {hole.foot, mouthOf(hole, block.end(hole.side))})
                for (const Vector2d& p : planCircle(end.head<2>(), hole.radius, circleCorners))
                    ends.row(row++) << p.x(), p.y(), 0;
            obstacles.push_back(planHull(ends));
        }
    }
    if (inPlane())
        addChannelObstacles(obstacles, block.plan().max().y());
    return obstacles;
}

/// How far spout, runners, gates and overflows reach into each half at most, mm.
std::array<double, 2> MoldBuilder::depthOfChannels() const {
    const OverflowSettings& overflows = m_mold.settings.overflows;
    double widest = overflows.count > 0 ? overflows.diameter : 0;
    if (inPlane())
        widest = std::max({widest, m_widths.main, m_widths.gate, spoutEach() ? spout().diameter : 0});
    std::array<double, 2> depth{};
    for (const std::size_t side : {0UL, 1UL})
        depth[side] = m_rules.sides[side] ? heightOverWidth * widest : 0;
    return depth;
}

Result<Block> MoldBuilder::blockFor(double wallX, double wallY) const {
    BlockContent content;
    content.wallX = wallX;
    content.wallY = wallY;
    for (const CavityCopy& copy : m_layout.copies)
        content.cavities.extend(
            kinds()[copy.kind].box.translated(Vector3d(copy.offset.x(), copy.offset.y(), 0)));
    content.channels = depthOfChannels();
    const double depth = std::max(m_mold.settings.floor, m_mold.settings.ceiling) + m_mold.settings.step;
    const double behind = m_mold.settings.leastSteel + m_mold.settings.step;
    const std::array<double, 2> ends = {
        std::max(content.cavities.max().z() + depth, content.channels[0] + behind),
        std::min(content.cavities.min().z() - depth, -content.channels[1] - behind)};
    for (const CavityCopy& copy : m_layout.copies)
        for (const OutwardHole& hole : outwardHoles(copy)) {
            const Vector3d mouth = mouthOf(hole, ends[hole.side == 1 ? 0 : 1]);
            for (const double way : {-1.0, 1.0})
                content.cavities.extend(
                    Vector3d(mouth.x() + way * hole.radius, mouth.y() + way * hole.radius, 0));
        }
    for (const CavityCopy& copy : m_layout.copies)
        for (const PlanShape& shape : overflowShapes(copy))
            for (const Vector2d& p : shape)
                content.cavities.extend(Vector3d(p.x(), p.y(), 0));
    if (inPlane())
        addChannelContent(content, wallY);
    content.byHand = boxByHand();
    return blockAround(content, m_mold.settings, {m_mold.directions, m_grid});
}

void MoldBuilder::addChannelContent(BlockContent& content, double wallY) const {
    const ChannelWidths& widths = m_widths;
    for (const CavityCopy& copy : m_layout.copies)
        for (const PlanShape& shape : gateShapes(copy))
            for (const Vector2d& p : shape)
                content.cavities.extend(Vector3d(p.x(), p.y(), 0));
    const double tail = m_end.face - m_end.line;
    if (spoutEach()) {
        const double half = widestOfSpout() / 2;
        double narrowest = widths.gate;
        for (const CavityCopy& copy : m_layout.copies)
            for (const Gate& gate : (*m_entries)[copy.kind].gates) {
                narrowest = std::min(narrowest, gate.width);
                for (const double way : {-half, half})
                    content.cavities.extend(Vector3d(gate.tip.x() + copy.offset.x() + way, 0, 0));
            }
        content.spoutTop = content.cavities.max().y() + m_mold.settings.layout.spacing / 2 +
                           spoutLength(spout(), narrowest, widths.straight()) + tail;
    } else if (star()) {
        const double bottom =
            m_layout.hub.y() + starHub(static_cast<int>(m_layout.arms.size()), widths.runner, widths.main);
        content.spoutTop =
            bottom + widths.beside + spoutLength(spout(), widths.main, widths.straight()) + tail;
    } else if (balanced()) {
        addTreeContent(content, wallY);
    } else {
        addRunnerContent(content, wallY);
    }
}

void MoldBuilder::addRunnerContent(BlockContent& content, double wallY) const {
    const ChannelWidths& widths = m_widths;
    for (const double way : {-1.0, 1.0}) {
        content.cavities.extend(
            Vector3d(m_layout.mainAxis + way * std::max(widestOfSpout(), widths.main) / 2, 0, 0));
        // Runners reach beyond the outermost gates.
        for (const CavityCopy& copy : m_layout.copies)
            for (const Gate& gate : (*m_entries)[copy.kind].gates)
                content.cavities.extend(
                    Vector3d(gate.tip.x() + copy.offset.x() + way * (widths.gate / 2 + widths.beside), 0, 0));
    }
    const double top = m_layout.runnerAxes.back() + widths.runner / 2 + widths.beside;
    content.spoutTop = std::max(
        top + spoutLength(spout(), widths.main, widths.straight()) + m_end.face - m_end.line, top + wallY);
}

void MoldBuilder::addTreeContent(BlockContent& content, double wallY) const {
    const ChannelWidths& widths = m_widths;
    double top = m_layout.tree->at.y();
    for (const PlanShape& strip : stripsOf(*m_layout.tree, treeWidths(widths)))
        for (const Vector2d& p : strip) {
            content.cavities.extend(Vector3d(p.x(), std::min(p.y(), content.cavities.max().y()), 0));
            top = std::max(top, p.y());
        }
    for (const double way : {-1.0, 1.0})
        content.cavities.extend(Vector3d(m_layout.tree->at.x() + way * widestOfSpout() / 2, 0, 0));
    top += widths.beside;
    content.spoutTop = std::max(
        top + spoutLength(spout(), widths.main, widths.straight()) + m_end.face - m_end.line, top + wallY);
}

AlignedBox2d MoldBuilder::boxByHand() const {
    const MoldSettings& settings = m_mold.settings;
    AlignedBox2d box;
    const auto extend = [&](const PlanShape& shape, const Vector2d& steel) {
        for (const Vector2d& p : shape)
            box.extend(AlignedBox2d(p - steel, p + steel));
    };
    for (const PlacedFeature& feature : settings.placed) {
        const Vector2d steel = Vector2d::Constant(settings.leastSteel);
        if (feature.kind == Placeable::Bolt && feature.number < settings.bolts.count)
            extend(boltRoom(settings.bolts, feature.place), Vector2d::Constant(settings.bolts.wall));
        else if (feature.kind == Placeable::Key && feature.number < settings.keys.count)
            extend(keyRoom(settings.keys, m_mold.directions, feature.number, feature.place), steel);
        else if (feature.kind == Placeable::Pocket && feature.number < settings.pockets.count)
            extend(pocketRoom(settings.pockets, feature.place, m_mold.directions, m_mold.draftDegrees),
                   steel);
        else if (feature.kind == Placeable::Slit && feature.number < settings.slits.count)
            extend(slitShape(settings.slits, {0, feature.place.y()}), {0, steel.y()});
    }
    return box;
}

/// What stands by hand comes before all that finds its own place.
void MoldBuilder::addByHand(Obstacles& obstacles, const Block& block) const {
    const MoldSettings& settings = m_mold.settings;
    for (const PlacedFeature& feature : settings.placed) {
        if (feature.kind == Placeable::Bolt && feature.number < settings.bolts.count)
            obstacles.push_back(boltRoom(settings.bolts, feature.place));
        else if (feature.kind == Placeable::Key && feature.number < settings.keys.count)
            obstacles.push_back(keyRoom(settings.keys, m_mold.directions, feature.number, feature.place));
        else if (feature.kind == Placeable::Pocket && feature.number < settings.pockets.count)
            obstacles.push_back(
                pocketRoom(settings.pockets, feature.place, m_mold.directions, m_mold.draftDegrees));
        else if (feature.kind == Placeable::Slit && feature.number < settings.slits.count)
            obstacles.push_back(slitShape(settings.slits, onFace(feature.place, block)));
    }
}

bool MoldBuilder::placeOn(const Block& block) {
    const MoldSettings& settings = m_mold.settings;
    const auto wishes = [&](Placeable kind, int count) { return wishesFor(settings.placed, kind, count); };
    const auto all = [](const std::vector<Vector2d>& places, int count) {
        return static_cast<int>(places.size()) == count;
    };
    Obstacles obstacles = planObstacles(block);
    addByHand(obstacles, block);
    const Pull pull = settings.shape == BlockShape::Shell ? Pull::Inwards : Pull::Outwards;
    m_boltPlaces =
        boltPlaces(settings.bolts, block, obstacles, wishes(Placeable::Bolt, settings.bolts.count), pull);
    if (!all(m_boltPlaces, settings.bolts.count))
        return false;
    // What comes later keeps the bolts' steel to them, where that is more than its own.
    const double more = std::max(0.0, settings.bolts.clear - settings.leastSteel);
    for (const Vector2d& place : m_boltPlaces)
        obstacles.push_back(boltRoom(settings.bolts, place, more));
    m_slitPlaces = slitPlaces(settings.slits, block, obstacles, settings.leastSteel,
                              wishes(Placeable::Slit, settings.slits.count), pull);
    if (!all(m_slitPlaces, settings.slits.count))
        return false;
    for (const Vector2d& place : m_slitPlaces)
        obstacles.push_back(slitShape(settings.slits, place));
    m_keyPlaces = keyPlaces(settings.keys, m_mold.directions, block, obstacles, settings.leastSteel,
                            wishes(Placeable::Key, settings.keys.count), pull);
    if (!all(m_keyPlaces, settings.keys.count))
        return false;
    for (std::size_t k = 0; k < m_keyPlaces.size(); ++k)
        obstacles.push_back(keyRoom(settings.keys, m_mold.directions, static_cast<int>(k), m_keyPlaces[k]));
    m_pocketPlaces =
        pocketPlaces(settings.pockets, m_mold.directions, m_mold.draftDegrees, block, obstacles,
                     settings.leastSteel, wishes(Placeable::Pocket, settings.pockets.count), pull);
    return all(m_pocketPlaces, settings.pockets.count);
}

/// Length of the tails, with what a wall that is not upright takes from them.
Result<double> MoldBuilder::tail() const {
    const double height = 0.4 * std::max(spout().diameter, spout().gate);
    const Result<double> length = tailLength(height, m_rules);
    if (!length)
        return length;
    const Result<std::array<double, 2>> flare =
        outerFlare(Vector2d::UnitY(), m_mold.settings, m_mold.directions);
    if (!flare)
        return std::unexpected(flare.error());
    return upToSixteenth(*length + height * std::max({0.0, -(*flare)[0], -(*flare)[1]}));
}

Result<void> MoldBuilder::fitBlock() {
    const MoldSettings& settings = m_mold.settings;
    if (inPlane()) {
        const Result<double> length = tail();
        if (!length)
            return std::unexpected(length.error());
        m_end = {*length, 0, {}};
    }
    constexpr int growths = 60;
    bool fits = false;
    std::optional<Error> refused;
    // A band left and right makes room at the corners; what is wanted between them may need one all round.
    for (const bool allRound : {false, true})
        for (int growth = 0; growth < growths && !fits; ++growth) {
            Result<Block> block = blockFor(settings.wall + growth, settings.wall + (allRound ? growth : 0));
            if (!block) {
                refused = block.error();
                break;
            }
            m_block = *std::move(block);
            fits = placeOn(m_block);
        }
    if (m_block.empty())
        return std::unexpected(*refused);
    if (!fits)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold", "There is no room for {0} keys, {1} slits, {2} bolt holes and {3} "
                                       "pockets. Ask for fewer or smaller ones."),
                       {std::to_string(settings.keys.count), std::to_string(settings.slits.count),
                        std::to_string(settings.bolts.count), std::to_string(settings.pockets.count)});
    if (settings.shape == BlockShape::Shell)
        if (Result<void> done = cutShell(); !done)
            return done;
    const double length = m_end.face - m_end.line;
    const double face = m_block.plan().max().y();
    m_end = {face, face - length, m_block.flare(Vector2d::UnitY())};
    return makeRegistration();
}

/// Cuts the block down to what stands in it.
Result<void> MoldBuilder::cutShell() {
    const MoldSettings& settings = m_mold.settings;
    std::vector<KeptInside> content;
    for (PlanShape& shape : planObstacles(m_block))
        content.push_back({std::move(shape), settings.wall});
    for (const Vector2d& place : m_boltPlaces)
        content.push_back({boltOutline(settings.bolts, place, m_grid), settings.bolts.wall});
    for (const Vector2d& place : m_slitPlaces)
        content.push_back({slitShape(settings.slits, place), settings.leastSteel});
    for (std::size_t k = 0; k < m_keyPlaces.size(); ++k)
        content.push_back({keyRoom(settings.keys, m_mold.directions, static_cast<int>(k), m_keyPlaces[k]),
                           settings.leastSteel});
    for (const Vector2d& place : m_pocketPlaces)
        content.push_back({pocketRoom(settings.pockets, place, m_mold.directions, m_mold.draftDegrees),
                           settings.leastSteel});
    Result<Block> shell = shellOf(m_block, content, settings, {m_mold.directions, m_grid});
    if (!shell)
        return std::unexpected(shell.error());
    m_mold.savedVolume = m_block.volume() - shell->volume();
    m_block = *std::move(shell);
    return {};
}

Result<void> MoldBuilder::makeRegistration() {
    const MoldSettings& settings = m_mold.settings;
    for (const Vector2d& place : m_keyPlaces) {
        Result<RegistrationKey> key = registrationKey(settings.keys, m_keys.empty(), place, m_mold.directions,
                                                      m_mold.draftDegrees, m_grid);
        if (!key)
            return std::unexpected(key.error());
        m_keys.push_back(*std::move(key));
    }
    for (const Vector2d& place : m_slitPlaces) {
        Result<WedgeSlit> slit =
            wedgeSlit(settings.slits, place, m_block, m_mold.directions, m_mold.draftDegrees, m_grid);
        if (!slit)
            return std::unexpected(slit.error());
        m_slits.push_back(*std::move(slit));
    }
    for (const Vector2d& place : m_boltPlaces)
        m_bolts.push_back(boltOutline(settings.bolts, place, m_grid));
    for (const int side : {1, 2})
        if (const double room = std::abs(m_block.end(side)) - settings.leastSteel;
            settings.pockets.count > 0 && settings.pockets.isIn(side) && settings.pockets.depth > room)
            return failure(
                ErrorCode::Impossible,
                MW_TEXT("Mold", "Pockets {0} mm deep leave less than {1} mm of steel at the back "
                                "of half {2}. Make them shallower, or the half thicker."),
                {readable(settings.pockets.depth), readable(settings.leastSteel), std::to_string(side)});
    for (const Vector2d& place : m_pocketPlaces) {
        Result<InsertPocket> pocket =
            insertPocket(settings.pockets, place, m_mold.directions, m_mold.draftDegrees, m_grid);
        if (!pocket)
            return std::unexpected(pocket.error());
        m_pockets.push_back(*std::move(pocket));
    }
    return engrave();
}

} // namespace moldwright
