// SPDX-License-Identifier: AGPL-3.0-or-later
#include "report/mold_features.h"

#include <algorithm>
#include <map>
#include <utility>

namespace moldwright {

namespace {

/// How a number of mold.json is printed; those that are not named here tell a place or a number, not a size.
struct Size {
    const char* key;
    const char* before;
    const char* unit;
    const char* after;
};
constexpr Size kSizes[] = {{"volume", "", " mm³", ""},
                           {"diameter", "⌀ ", " mm", ""},
                           {"length", "length ", " mm", ""},
                           {"width", "width ", " mm", ""},
                           {"depth", "depth ", " mm", ""},
                           {"height", "height ", " mm", ""},
                           {"height_1", "", " mm", " into half 1"},
                           {"height_2", "", " mm", " into half 2"},
                           {"clearance", "clearance ", " mm", ""},
                           {"neck", "neck ⌀ ", " mm", ""},
                           {"lean_deg", "lean ", "°", ""}};

/// All features of one name.
struct Kind {
    std::string name;
    int count = 0;
    std::map<std::string, std::pair<double, double>> range; ///< by key: the least and the greatest

    void add(const MoldFeature& feature) {
        ++count;
        for (const auto& [key, value] : feature.numbers) {
            const auto [place, isNew] = range.try_emplace(key, value, value);
            place->second.first = std::min(place->second.first, value);
            place->second.second = std::max(place->second.second, value);
        }
    }
};

std::vector<Kind> kindsOf(const Mold& mold) {
    std::vector<Kind> kinds;
    for (const MoldFeature& feature : mold.features) {
        if (feature.kind == "block")
            continue;
        auto kind = std::ranges::find(kinds, feature.name, &Kind::name);
        if (kind == kinds.end())
            kind = kinds.insert(kinds.end(), {feature.name, 0, {}});
        kind->add(feature);
    }
    return kinds;
}

std::string rangeText(const std::pair<double, double>& range, std::string unit) {
    auto [least, greatest] = range;
    if (unit == " mm³" && greatest >= 1000) {
        unit = " cm³";
        least /= 1000;
        greatest /= 1000;
    }
    const std::string from = readable(least, 3);
    const std::string to = readable(greatest, 3);
    return (from == to ? from : from + " to " + to) + unit;
}

std::string sizesOf(const Kind& kind) {
    std::string text;
    for (const Size& size : kSizes)
        if (const auto range = kind.range.find(size.key); range != kind.range.end())
            text +=
                (text.empty() ? "" : ", ") + (size.before + rangeText(range->second, size.unit)) + size.after;
    return text;
}

/// A row for a value that is as it comes.
class Defaults {
public:
    void add(const char* name, double value, double usual, const char* unit, const char* source) {
        if (value == usual)
            m_used.push_back({name, readable(value) + unit, source});
    }
    [[nodiscard]] std::vector<ReportDefault> used() && { return std::move(m_used); }

private:
    std::vector<ReportDefault> m_used;
};

constexpr const char* kOwn = "own choice";
constexpr const char* kOpen = "open mold generators";

void addFilling(Defaults& defaults, const MoldSettings& mold) {
    const MoldSettings usual;
    if (mold.spout.on) {
        defaults.add("Spout, diameter", mold.spout.diameter, usual.spout.diameter, " mm", kOpen);
        defaults.add("Spout, at the block’s face", mold.spout.funnel, usual.spout.funnel, " mm", kOwn);
        defaults.add("Gate, width", mold.spout.gate, usual.spout.gate, " mm", kOwn);
        defaults.add("Channels, draft", mold.spout.draft, usual.spout.draft, "°", kOpen);
    }
    if (mold.spout.on && mold.spout.resting == Resting::Lying)
        defaults.add("Neck of the spout", mold.spout.neck, usual.spout.neck, " mm", kOwn);
    if (mold.vents.on) {
        defaults.add("Vents, at the narrowest", mold.vents.diameter, usual.vents.diameter, " mm",
                     "gravity pour, shop practice");
        defaults.add("Air that may stay", mold.vents.smallestTrap, usual.vents.smallestTrap, " mm³", kOwn);
    }
}

void addFastening(Defaults& defaults, const MoldSettings& mold) {
    const MoldSettings usual;
    if (mold.keys.count > 0) {
        defaults.add("Keys, diameter", mold.keys.diameter, usual.keys.diameter, " mm", kOpen);
        defaults.add("Keys, height", mold.keys.height, usual.keys.height, " mm", kOpen);
        defaults.add("Keys, clearance", mold.keys.clearance, usual.keys.clearance, " mm", kOpen);
        defaults.add("Keys, draft at least", mold.keys.draft, usual.keys.draft, "°", kOpen);
        defaults.add("First key larger by", mold.keys.oddBy, usual.keys.oddBy, " mm", kOpen);
    }
    if (mold.slits.count > 0) {
        defaults.add("Wedge slits, depth", mold.slits.depth, usual.slits.depth, " mm", "mold makers");
        defaults.add("Wedge slits, width", mold.slits.width, usual.slits.width, " mm", kOwn);
        defaults.add("Wedge slits, height in each half", mold.slits.height, usual.slits.height, " mm", kOwn);
    }
    if (mold.bolts.count > 0) {
        defaults.add("Bolt holes, diameter", mold.bolts.diameter, usual.bolts.diameter, " mm",
                     "M6, ISO 273 medium");
        defaults.add("Bolt holes, steel to faces", mold.bolts.wall, usual.bolts.wall, " mm", "shop practice");
        defaults.add("Bolt holes, steel to the rest", mold.bolts.clear, usual.bolts.clear, " mm", kOwn);
    }
    if (mold.ejectors.count > 0)
        defaults.add("Ejector holes, diameter", mold.ejectors.diameter, usual.ejectors.diameter, " mm", kOwn);
}

} // namespace

std::optional<ReportTable> featureTable(const Mold& mold) {
    ReportTable table{"Cavities and features", {"Feature", "How many", "Each"}, {}, SIZE_MAX, {}, {4, 1, 7}};
    bool more = false;
    for (const Kind& kind : kindsOf(mold)) {
        table.rows.push_back({kind.name, std::to_string(kind.count), sizesOf(kind)});
        more = more || !kind.name.starts_with("Cavity");
    }
    if (!more)
        return std::nullopt;
    return table;
}

std::vector<ReportDefault> featureDefaults(const MoldSettings& settings) {
    Defaults defaults;
    addFilling(defaults, settings);
    addFastening(defaults, settings);
    return std::move(defaults).used();
}

std::vector<std::string> notesOf(const Mold& mold) {
    std::vector<std::string> notes = mold.notes;
    for (const MoldFeature& feature : mold.features) {
        const std::string note = feature.name + ": " + feature.note;
        if (!feature.note.empty() && std::ranges::find(notes, note) == notes.end())
            notes.push_back(note);
    }
    return notes;
}

} // namespace moldwright
