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
    const char* text; ///< {0}: value and unit
    const char* unit;
};
constexpr Size kSizes[] = {{"volume", "{0}", " mm³"},
                           {"diameter", "⌀ {0}", " mm"},
                           {"length", MW_TEXT("Report", "length {0}"), " mm"},
                           {"width", MW_TEXT("Report", "width {0}"), " mm"},
                           {"depth", MW_TEXT("Report", "depth {0}"), " mm"},
                           {"height", MW_TEXT("Report", "height {0}"), " mm"},
                           {"height_1", MW_TEXT("Report", "{0} into half 1"), " mm"},
                           {"height_2", MW_TEXT("Report", "{0} into half 2"), " mm"},
                           {"clearance", MW_TEXT("Report", "clearance {0}"), " mm"},
                           {"neck", MW_TEXT("Report", "neck ⌀ {0}"), " mm"},
                           {"lean_deg", MW_TEXT("Report", "lean {0}"), "°"}};

/// Names that the builder gives features and steel, so that the translation tools find them.
[[maybe_unused]] constexpr const char* kNames[] = {MW_TEXT("Report", "Cavity"),
                                                   MW_TEXT("Report", "Cavity, mirrored"),
                                                   MW_TEXT("Report", "Spout"),
                                                   MW_TEXT("Report", "Spout through half 1"),
                                                   MW_TEXT("Report", "Runner"),
                                                   MW_TEXT("Report", "Gate"),
                                                   MW_TEXT("Report", "Vent"),
                                                   MW_TEXT("Report", "Key"),
                                                   MW_TEXT("Report", "Wedge slit"),
                                                   MW_TEXT("Report", "Bolt hole"),
                                                   MW_TEXT("Report", "Ejector hole in half 1"),
                                                   MW_TEXT("Report", "Ejector hole in half 2"),
                                                   MW_TEXT("Report", "Air that stays"),
                                                   MW_TEXT("Report", "Overflow"),
                                                   MW_TEXT("Report", "Insert pocket in both halves"),
                                                   MW_TEXT("Report", "Insert pocket in half 1"),
                                                   MW_TEXT("Report", "Insert pocket in half 2"),
                                                   MW_TEXT("Report", "Plaque on half 1"),
                                                   MW_TEXT("Report", "Plaque on half 2"),
                                                   MW_TEXT("Report", "overflow"),
                                                   MW_TEXT("Report", "overflow's channel"),
                                                   MW_TEXT("Report", "pocket"),
                                                   MW_TEXT("Report", "plaque"),
                                                   MW_TEXT("Report", "the right"),
                                                   MW_TEXT("Report", "the left"),
                                                   MW_TEXT("Report", "half 1"),
                                                   MW_TEXT("Report", "half 2"),
                                                   MW_TEXT("Report", "half 1 and the right"),
                                                   MW_TEXT("Report", "half 1 and the left"),
                                                   MW_TEXT("Report", "half 2 and the left"),
                                                   MW_TEXT("Report", "half 2 and the right"),
                                                   MW_TEXT("Report", "the back"),
                                                   MW_TEXT("Report", "the front"),
                                                   MW_TEXT("Report", "the back and the right"),
                                                   MW_TEXT("Report", "the back and the left"),
                                                   MW_TEXT("Report", "the front and the left"),
                                                   MW_TEXT("Report", "the front and the right"),
                                                   MW_TEXT("Report", "cavity"),
                                                   MW_TEXT("Report", "spout"),
                                                   MW_TEXT("Report", "runner"),
                                                   MW_TEXT("Report", "gate"),
                                                   MW_TEXT("Report", "vent"),
                                                   MW_TEXT("Report", "key"),
                                                   MW_TEXT("Report", "slit"),
                                                   MW_TEXT("Report", "bolt hole"),
                                                   MW_TEXT("Report", "ejector hole"),
                                                   MW_TEXT("Report", "outside")};

/// All features of one name and part.
struct Kind {
    std::string name;
    std::string part;
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
        auto kind = std::ranges::find_if(kinds, [&](const Kind& known) {
            return known.name == feature.name && known.part == feature.part;
        });
        if (kind == kinds.end())
            kind = kinds.insert(kinds.end(), {feature.name, feature.part, 0, {}});
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
    return (from == to ? from : from + " – " + to) + unit;
}

std::string sizesOf(const Kind& kind, const Phrases& say) {
    std::string text;
    for (const Size& size : kSizes)
        if (const auto range = kind.range.find(size.key); range != kind.range.end())
            text += (text.empty() ? "" : ", ") + say(size.text, {rangeText(range->second, size.unit)});
    return text;
}

/// How long the ways through runners are: of one length the cavities fill together. Empty without runners.
std::string waysText(const Mold& mold, const Phrases& say) {
    if (mold.settings.spout.resting != Resting::Standing || mold.pathLengths.size() < 2)
        return {};
    const auto [least, most] = std::ranges::minmax(mold.pathLengths);
    constexpr double equal = 0.001; // of the longest
    if (most - least > equal * most)
        return rangeText({least, most}, " mm");
    return say(MW_TEXT("Report", "equally long, {0}"), {readable(most, 3) + " mm"});
}

} // namespace

std::optional<ReportTable> featureTable(const Mold& mold, const Phrases& say) {
    ReportTable table{say(MW_TEXT("Report", "Cavities and features")),
                      {say(MW_TEXT("Report", "Feature")), say(MW_TEXT("Report", "How many")),
                       say(MW_TEXT("Report", "Each"))},
                      {},
                      SIZE_MAX,
                      {},
                      {4, 1, 7}};
    bool more = false;
    for (const Kind& kind : kindsOf(mold)) {
        table.rows.push_back({say(kind.name) + (kind.part.empty() ? "" : " (" + kind.part + ")"),
                              std::to_string(kind.count), sizesOf(kind, say)});
        more = more || !kind.name.starts_with("Cavity") || !kind.part.empty();
    }
    if (!more)
        return std::nullopt;
    if (const std::string ways = waysText(mold, say); !ways.empty())
        table.rows.push_back({say(MW_TEXT("Report", "Way from the spout to each cavity")),
                              std::to_string(mold.pathLengths.size()), ways});
    return table;
}

std::vector<std::string> notesOf(const Mold& mold, const Phrases& say) {
    // Names of features are arguments too.
    const auto told = [&](Message note) {
        std::ranges::transform(note.arguments, note.arguments.begin(),
                               [&](const std::string& argument) { return say(argument); });
        return say(note.text, note.arguments);
    };
    std::vector<std::string> notes;
    for (const Message& note : mold.notes)
        notes.push_back(told(note));
    for (const MoldFeature& feature : mold.features) {
        const std::string note = say(feature.name) + ": " + told(feature.note);
        if (!feature.note.text.empty() && std::ranges::find(notes, note) == notes.end())
            notes.push_back(note);
    }
    return notes;
}

} // namespace moldwright
