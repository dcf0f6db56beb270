// SPDX-License-Identifier: AGPL-3.0-or-later
// The builder's list of what it made, for mold.json, the report, and the places that a view points at.
#include "mesh/measures.h"
#include "mold/mold_builder.h"

#include <algorithm>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d middleOf(const DraftedPrism& prism) {
    Vector2d sum = Vector2d::Zero();
    for (const Vector2d& p : prism.base)
        sum += p / static_cast<double>(prism.base.size());
    return {sum.x(), sum.y(), 0};
}

std::vector<std::pair<std::string, double>> sizesOf(const DraftedPrism& prism) {
    return {
        {"volume", volume(*prismSolid(prism))}, {"height_1", prism.height[0]}, {"height_2", prism.height[1]}};
}

} // namespace

void MoldBuilder::listFeatures() {
    const MoldSettings& settings = m_mold.settings;
    const Vector3d size = m_block.box().sizes();
    m_mold.features.push_back({"block",
                               "Block",
                               m_block.box().center(),
                               {{"size_x", size.x()},
                                {"size_y", size.y()},
                                {"size_z", size.z()},
                                {"wall", settings.wall},
                                {"floor", settings.floor},
                                {"ceiling", settings.ceiling},
                                {"outer_draft_deg", settings.outerDraft},
                                {"saved_volume", m_mold.savedVolume}},
                               {}});
    for (std::size_t number = 0; number < m_layout.copies.size(); ++number)
        listCavity(number);
    listChannels();
    listRegistration();
    listBolts();
    listPockets();
    listPlaques();
}

void MoldBuilder::listCavity(std::size_t number) {
    std::vector<MoldFeature>& features = m_mold.features;
    const CavityCopy& copy = m_layout.copies[number];
    const CavityKind& kind = kinds()[copy.kind];
    const JoinedCavity& joined = m_joined[copy.kind];
    const Vector3d by(copy.offset.x(), copy.offset.y(), 0);
    features.push_back({"cavity",
                        kind.mirrored ? "Cavity, mirrored" : "Cavity",
                        by,
                        {{"volume", kind.volume},
                         {"row", copy.row},
                         {"column", copy.column},
                         {"turn_deg", degrees(kind.turn)}},
                        {}});
    if (m_mold.parts.size() > 1) {
        features.back().part = m_mold.parts[kind.part].name;
        features.back().number = static_cast<int>(number) + 1;
    }
    listStubs(copy);
    listBores(copy);
    listOverflows(copy);
    for (const RemainingAir& air : joined.remaining) {
        m_mold.trappedAir += air.volume;
        features.push_back(
            {"trapped_air",
             "Air that stays",
             air.place + by,
             {{"volume", air.volume}},
             {MW_TEXT("Mold", "No vent can be placed here, or none that reaches higher."), {}}});
    }
}

void MoldBuilder::addPlaceable(MoldFeature feature, const PlacedFeature& stands, PlanShape outline,
                               const Vector2d& origin) {
    feature.stands = stands;
    feature.byHand = isByHand(stands.kind, stands.number);
    feature.outline = std::move(outline);
    feature.origin = origin;
    m_mold.features.push_back(std::move(feature));
}

void MoldBuilder::listStubs(const CavityCopy& copy) {
    const JoinedCavity& joined = m_joined[copy.kind];
    const Vector3d by(copy.offset.x(), copy.offset.y(), 0);
    for (const Stub& stub : joined.stubs) {
        MoldFeature feature{stub.vent     ? "vent"
                            : spoutEach() ? "spout"
                                          : "gate",
                            stub.name,
                            middleOf(stub.prism) + by,
                            sizesOf(stub.prism),
                            {}};
        if (feature.kind == "gate")
            feature.numbers.emplace_back("width", stub.width);
        if (stub.vent)
            addPlaceable(std::move(feature), {Placeable::Vent, stub.number, stub.tip},
                         movedPlan(stub.prism.base, copy.offset), copy.offset);
        else if (spoutEach())
            addPlaceable(std::move(feature),
                         {Placeable::Spout, stub.number, {stub.tip.x() + copy.offset.x(), m_end.face}},
                         movedPlan(stub.prism.base, copy.offset));
        else
            m_mold.features.push_back(std::move(feature));
    }
    for (const CavityVent& vent : joined.vents)
        addPlaceable({"vent",
                      "Vent through half " + std::to_string(vent.side),
                      vent.mouth + by,
                      {{"diameter", m_mold.settings.vents.diameter}, {"side", vent.side}},
                      {}},
                     {Placeable::Vent, vent.number, vent.top}, movedPlan(vent.body.base, copy.offset),
                     copy.offset);
}

void MoldBuilder::listChannels() {
    for (const Channel& channel : m_net.channels) {
        MoldFeature feature{channel.name == "Spout" ? "spout" : "runner",
                            channel.name,
                            middleOf(channel.prism),
                            sizesOf(channel.prism),
                            {}};
        if (channel.name == "Spout" && !inOnePrism())
            addPlaceable(std::move(feature), {Placeable::Spout, 0, {m_layout.mainAxis, m_end.face}},
                         channel.prism.base);
        else
            m_mold.features.push_back(std::move(feature));
    }
    if (inPlane())
        comparePaths();
}

void MoldBuilder::comparePaths() {
    m_mold.pathLengths = m_net.pathLengths;
    if (m_mold.pathLengths.empty())
        return;
    const auto [least, most] = std::minmax_element(m_mold.pathLengths.begin(), m_mold.pathLengths.end());
    constexpr double equal = 0.01; // of the longest
    if (*most - *least > equal * *most)
        m_mold.notes.push_back(
            {MW_TEXT("Mold", "The cavities do not fill at the same time: the ways to them are "
                             "{0} to {1} mm long."),
             {readable(*least, 3), readable(*most, 3)}});
}

void MoldBuilder::listRegistration() {
    const MoldSettings& settings = m_mold.settings;
    for (std::size_t i = 0; i < m_keys.size(); ++i) {
        const RegistrationKey& key = m_keys[i];
        const bool raised = key.leanDegrees > settings.keys.draft + 0.5;
        addPlaceable({"key",
                      "Key",
                      {key.place.x(), key.place.y(), 0},
                      {{"diameter", key.diameter},
                       {"height", settings.keys.height},
                       {"clearance", settings.keys.clearance},
                       {"lean_deg", key.leanDegrees}},
                      raised
                          ? Message{MW_TEXT("Mold", "Its walls lean up to {0}°: with less it would hold when "
                                                    "one half is opened first."),
                                    {readable(key.leanDegrees, 3)}}
                          : Message{}},
                     {Placeable::Key, static_cast<int>(i), key.place}, key.socket.base);
    }
    for (std::size_t i = 0; i < m_slits.size(); ++i) {
        const WedgeSlit& slit = m_slits[i];
        addPlaceable({"slit",
                      "Wedge slit",
                      {slit.place.x(), slit.place.y(), 0},
                      {{"depth", settings.slits.depth},
                       {"width", settings.slits.width},
                       {"height", settings.slits.height}},
                      {}},
                     {Placeable::Slit, static_cast<int>(i), slit.place}, slit.prism.base);
    }
}

void MoldBuilder::listBores(const CavityCopy& copy) {
    const Vector3d by(copy.offset.x(), copy.offset.y(), 0);
    for (const HalfBore& bore : m_joined[copy.kind].bores) {
        const Vector3d& d = m_mold.directions.of(bore.side);
        const Vector3d tip = bore.at(bore.tip, d);
        const double length = (bore.at(bore.stations.back().height, d) - tip).norm();
        const std::vector<std::pair<std::string, double>> common = {{"side", bore.side}, {"length", length}};
        MoldFeature feature{
            "ejector", "Ejector hole in half " + std::to_string(bore.side), tip + by, common, {}};
        const bool fills = bore.use == HalfBore::Use::Spout;
        if (fills) {
            feature.kind = "spout";
            feature.name = "Spout through half 1";
            feature.numbers.emplace_back("neck", spout().neck);
            feature.numbers.emplace_back("mouth", 2 * bore.stations.back().radius);
            feature.note.text =
                MW_TEXT("Mold", "Widens outwards: it breaks off at its neck when half 1 is taken "
                                "off, and is pushed out of it outwards.");
            m_mold.pathLengths.push_back(length);
        } else {
            feature.numbers.emplace_back("diameter", m_mold.settings.ejectors.diameter);
        }
        addPlaceable(
            std::move(feature), {fills ? Placeable::Spout : Placeable::Ejector, bore.number, bore.axis},
            planCircle(bore.axis + copy.offset,
                       fills ? spout().diameter / 2 : m_mold.settings.ejectors.diameter / 2, circleCorners),
            copy.offset);
    }
}

void MoldBuilder::listBolts() {
    for (std::size_t i = 0; i < m_boltPlaces.size(); ++i) {
        const Vector2d& place = m_boltPlaces[i];
        addPlaceable({"bolt",
                      "Bolt hole",
                      {place.x(), place.y(), 0},
                      {{"diameter", m_mold.settings.bolts.diameter}, {"length", m_block.box().sizes().z()}},
                      {}},
                     {Placeable::Bolt, static_cast<int>(i), place}, m_bolts[i]);
    }
}

void MoldBuilder::listPockets() {
    const PocketSettings& settings = m_mold.settings.pockets;
    for (std::size_t i = 0; i < m_pockets.size(); ++i) {
        const InsertPocket& pocket = m_pockets[i];
        std::vector<std::pair<std::string, double>> numbers = {{"width", settings.width},
                                                               {"depth", settings.depth},
                                                               {"clearance", settings.clearance},
                                                               {"side", settings.side},
                                                               {"volume", volume(*prismSolid(pocket.prism))}};
        if (settings.shape == PocketShape::Rectangle)
            numbers.insert(numbers.begin(), {"length", settings.length});
        addPlaceable({"pocket",
                      settings.side == 0 ? "Insert pocket in both halves"
                                         : "Insert pocket in half " + std::to_string(settings.side),
                      {pocket.place.x(), pocket.place.y(), 0},
                      std::move(numbers),
                      {}},
                     {Placeable::Pocket, static_cast<int>(i), pocket.place}, pocket.prism.base);
    }
}

void MoldBuilder::listPlaques() {
    for (const Plaque& plaque : m_plaques)
        m_mold.features.push_back({"plaque",
                                   "Plaque on half " + std::to_string(plaque.side),
                                   {plaque.place.x(), plaque.place.y(), plaque.back},
                                   {{"side", plaque.side},
                                    {"letter_height", plaque.letterHeight},
                                    {"stroke", plaque.strokeWidth()},
                                    {"depth", m_mold.settings.plaque.depth},
                                    {"volume", volume(plaque.solid())}},
                                   {MW_TEXT("Mold", "Reads: {0}"), {plaque.text}}});
}

} // namespace moldwright
