// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_sketch.h"

#include "mold/mold_builder.h"

#include <algorithm>
#include <array>

namespace moldwright {

struct MoldSketcher::State {
    MoldBuilder prepared;
    MoldSettings settings;
    PlacedFeatures entriesPlaced;
    MoldBuilder::Entries entries; ///< of entriesPlaced; null before the first
};

MoldSketcher::MoldSketcher(std::unique_ptr<State> state) : m_state(std::move(state)) {}
MoldSketcher::~MoldSketcher() = default;
MoldSketcher::MoldSketcher(MoldSketcher&&) noexcept = default;
MoldSketcher& MoldSketcher::operator=(MoldSketcher&&) noexcept = default;

Result<MoldSketcher> MoldSketcher::prepared(const Tray& tray, double draftDegrees,
                                            const MoldSettings& settings) {
    MoldSettings unplaced = settings;
    unplaced.placed.clear();
    MoldBuilder builder(unplaced, draftDegrees);
    Result<void> done = builder.place(tray);
    if (done)
        done = builder.makeKinds();
    if (done)
        done = builder.findTilt();
    if (!done)
        return std::unexpected(done.error());
    return MoldSketcher(std::make_unique<State>(State{std::move(builder), std::move(unplaced), {}, {}}));
}

bool MoldSketcher::serves(const MoldSettings& settings) const {
    MoldSettings unplaced = settings;
    unplaced.placed.clear();
    return unplaced == m_state->settings;
}

Result<MoldSketch> MoldSketcher::sketch(const PlacedFeatures& placed) {
    MoldBuilder builder = m_state->prepared;
    Result<void> done = builder.setPlaced(placed);
    if (done)
        done = builder.layOut();
    const PlacedFeatures ofEntries = builder.placedAtCavities();
    if (done && m_state->entries && m_state->entriesPlaced == ofEntries)
        builder.useEntries(m_state->entries);
    else if (done) {
        done = builder.findEntries();
        m_state->entries = builder.entries();
        m_state->entriesPlaced = ofEntries;
    }
    for (Result<void> (MoldBuilder::*work)() : {&MoldBuilder::findOverflows, &MoldBuilder::fitBlock,
                                                &MoldBuilder::planJoints, &MoldBuilder::measureSteel})
        if (done)
            done = (builder.*work)();
    if (!done)
        return std::unexpected(done.error());
    MoldSketch sketch;
    sketch.block = builder.block();
    sketch.partingLines = builder.partingLines();
    Mold mold = builder.mold();
    sketch.settings = std::move(mold.settings);
    sketch.features = std::move(mold.features);
    sketch.steel = std::move(mold.steelOfEach);
    sketch.trappedAir = mold.trappedAir;
    sketch.partToMold = mold.partToMold;
    sketch.shrinkFactors = mold.shrinkFactors;
    return sketch;
}

const char* steelName(Placeable kind) {
    constexpr std::array names = {"Spout",     "Vent",         "Key",      "Slit",
                                  "Bolt hole", "Ejector hole", "Overflow", "Pocket"};
    return names.at(static_cast<std::size_t>(kind));
}

const ThinSteel* thinnestAbout(const std::vector<ThinSteel>& steel, Placeable kind, int number) {
    const auto is = [&](const std::string& name, int its) {
        return its == number + 1 && name == steelName(kind);
    };
    const auto found = std::find_if(steel.begin(), steel.end(), [&](const ThinSteel& thin) {
        return is(thin.first, thin.firstNumber) || is(thin.second, thin.secondNumber);
    });
    return found == steel.end() ? nullptr : &*found;
}

double steelAsked(const ThinSteel& steel, const MoldSettings& settings) {
    const std::string bolt = steelName(Placeable::Bolt);
    if (steel.first != bolt && steel.second != bolt)
        return settings.leastSteel;
    return steel.second == "outside" ? settings.bolts.wall : settings.bolts.clear;
}

} // namespace moldwright
