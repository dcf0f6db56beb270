// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/mold_settings_json.h"

#include "project/cavity_places.h"
#include "project/placed_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

// Names in files, in the order of the enumerations.
constexpr std::array<std::string_view, 2> formulaNames = {"plus", "divide"};
constexpr std::array<std::string_view, 2> shapeNames = {"box", "shell"};
constexpr std::array<std::string_view, 5> arrangementNames = {"grid", "staggered", "packed", "circle",
                                                              "free"};
constexpr std::array<std::string_view, 4> alternationNames = {"none", "turn", "flip", "mirror"};
constexpr std::array<std::string_view, 3> pocketNames = {"round", "hexagon", "rectangle"};
constexpr std::array<std::string_view, 2> restingNames = {"standing", "lying"};
constexpr std::array<std::string_view, 2> runnerNames = {"shortest", "balanced"};
constexpr std::array<std::string_view, 5> pourNames = {"auto", "0", "90", "180", "270"};

/// Visits each value of the settings with its key, so that writing and reading cannot disagree.
template <class Visitor, class Settings>
void visit(Visitor& at, Settings& mold) {
    at.value({"wall"}, mold.wall);
    at.value({"floor"}, mold.floor);
    at.value({"ceiling"}, mold.ceiling);
    at.value({"step"}, mold.step);
    at.name({"shape"}, mold.shape, shapeNames);
    at.value({"outer_draft_deg"}, mold.outerDraft);
    at.value({"pressure_bar"}, mold.pressure);
    at.value({"least_steel"}, mold.leastSteel);
    at.value({"density"}, mold.density);
    at.value({"block_density"}, mold.blockDensity);
    at.value({"layout", "rows"}, mold.layout.rows);
    at.value({"layout", "columns"}, mold.layout.columns);
    at.name({"layout", "arrangement"}, mold.layout.arrangement, arrangementNames);
    at.name({"layout", "alternation"}, mold.layout.alternation, alternationNames);
    at.value({"layout", "spacing"}, mold.layout.spacing);
    for (const auto& [axis, key] : {std::pair{0, "x"}, std::pair{1, "y"}, std::pair{2, "z"}}) {
        at.value({"shrink", "percent", key}, mold.shrink.percent[axis]);
        at.value({"shrink", "origin", key}, mold.shrink.origin[axis]);
    }
    at.name({"shrink", "formula"}, mold.shrink.formula, formulaNames);
    at.value({"spout", "on"}, mold.spout.on);
    at.value({"spout", "diameter"}, mold.spout.diameter);
    at.value({"spout", "funnel"}, mold.spout.funnel);
    at.value({"spout", "gate"}, mold.spout.gate);
    at.value({"spout", "draft_deg"}, mold.spout.draft);
    at.name({"spout", "pour"}, mold.spout.pour, pourNames);
    at.value({"vents", "on"}, mold.vents.on);
    at.value({"vents", "diameter"}, mold.vents.diameter);
    at.value({"vents", "depth"}, mold.vents.depth);
    at.value({"vents", "smallest_trap"}, mold.vents.smallestTrap);
    at.value({"overflows", "count"}, mold.overflows.count);
    at.value({"overflows", "diameter"}, mold.overflows.diameter);
    at.value({"overflows", "channel"}, mold.overflows.channel);
    at.value({"overflows", "length"}, mold.overflows.length);
    at.value({"keys", "count"}, mold.keys.count);
    at.value({"keys", "diameter"}, mold.keys.diameter);
    at.value({"keys", "height"}, mold.keys.height);
    at.value({"keys", "clearance"}, mold.keys.clearance);
    at.value({"keys", "draft_deg"}, mold.keys.draft);
    at.value({"keys", "odd_by"}, mold.keys.oddBy);
    at.value({"slits", "count"}, mold.slits.count);
    at.value({"slits", "depth"}, mold.slits.depth);
    at.value({"slits", "width"}, mold.slits.width);
    at.value({"slits", "height"}, mold.slits.height);
    at.value({"bolts", "count"}, mold.bolts.count);
    at.value({"bolts", "diameter"}, mold.bolts.diameter);
    at.value({"bolts", "wall"}, mold.bolts.wall);
    at.value({"bolts", "clear"}, mold.bolts.clear);
    at.name({"spout", "runners"}, mold.spout.runners, runnerNames);
    at.name({"spout", "resting"}, mold.spout.resting, restingNames);
    at.value({"spout", "neck"}, mold.spout.neck);
    at.value({"spout", "tilt", "automatic"}, mold.spout.tilt.automatic);
    at.value({"spout", "tilt", "degrees"}, mold.spout.tilt.degrees);
    at.value({"spout", "tilt", "towards_deg"}, mold.spout.tilt.towards);
    at.value({"hollow", "wall"}, mold.hollow.wall);
    at.value({"stock"}, mold.stock);
    at.material({"material"}, mold.material);
    at.features({"placed"}, mold.placed);
    at.places({"layout", "places"}, mold.layout.places);
    for (const auto& [axis, key] : {std::pair{0, "x"}, std::pair{1, "y"}, std::pair{2, "z"}})
        at.value({"machines", "bed", key}, mold.machines.bed[axis]);
    at.value({"machines", "clamp_kn"}, mold.machines.clamp);
    at.value({"ejectors", "count"}, mold.ejectors.count);
    at.value({"ejectors", "diameter"}, mold.ejectors.diameter);
    at.value({"ejectors", "side"}, mold.ejectors.side);
    at.value({"pockets", "count"}, mold.pockets.count);
    at.name({"pockets", "shape"}, mold.pockets.shape, pocketNames);
    at.value({"pockets", "width"}, mold.pockets.width);
    at.value({"pockets", "length"}, mold.pockets.length);
    at.value({"pockets", "depth"}, mold.pockets.depth);
    at.value({"pockets", "clearance"}, mold.pockets.clearance);
    at.value({"pockets", "side"}, mold.pockets.side);
    at.value({"plaque", "text"}, mold.plaque.text);
    at.value({"plaque", "height"}, mold.plaque.height);
    at.value({"plaque", "depth"}, mold.plaque.depth);
}

using Path = std::initializer_list<const char*>;

struct Writer {
    Json json = Json::object();

    template <class T>
    void value(Path path, const T& value) {
        Json* at = &json;
        for (const char* key : path)
            at = &(*at)[key];
        *at = value;
    }
    template <class E, std::size_t N>
    void name(Path path, E choice, const std::array<std::string_view, N>& names) {
        value(path, std::string(names.at(static_cast<std::size_t>(choice))));
    }
    void features(Path path, const PlacedFeatures& placed) { value(path, placedJson(placed)); }
    void material(Path path, const std::optional<Material>& material) {
        if (material)
            value(path, materialJson(*material));
    }
    void places(Path path, const std::vector<CavityPlace>& places) { value(path, cavityPlacesJson(places)); }
};

struct Reader {
    const Json& json;

    [[nodiscard]] const Json* find(Path path) const {
        const Json* at = &json;
        for (const char* key : path) {
            if (!at->is_object() || !at->contains(key))
                return nullptr;
            at = &at->at(key);
        }
        return at;
    }
    template <class T>
    void value(Path path, T& value) const {
        if (const Json* found = find(path))
            value = found->get<T>();
    }
    template <class E, std::size_t N>
    void name(Path path, E& choice, const std::array<std::string_view, N>& names) const {
        const Json* found = find(path);
        if (found == nullptr)
            return;
        const auto at = std::find(names.begin(), names.end(), found->get<std::string>());
        if (at == names.end())
            throw Json::other_error::create(501, "unknown name " + found->get<std::string>(), found);
        choice = static_cast<E>(at - names.begin());
    }
    void features(Path path, PlacedFeatures& placed) const {
        const Json* found = find(path);
        if (found == nullptr)
            return;
        const Result<PlacedFeatures> read = placedFrom(*found, "placed");
        if (!read)
            throw Json::other_error::create(501, read.error().english(), found);
        placed = *read;
    }
    void material(Path path, std::optional<Material>& material) const {
        if (const Json* found = find(path))
            material = materialFromJson(*found);
    }
    void places(Path path, std::vector<CavityPlace>& places) const {
        const Json* found = find(path);
        if (found == nullptr)
            return;
        Result<std::vector<CavityPlace>> read = cavityPlacesFrom(*found);
        if (!read)
            throw Json::other_error::create(501, read.error().english(), found);
        places = *std::move(read);
    }
};

} // namespace

Json moldSettingsJson(const MoldSettings& settings) {
    Writer writer;
    visit(writer, settings);
    return std::move(writer.json);
}

MoldSettings moldSettingsFrom(const Json& json, const MoldSettings& otherwise) {
    MoldSettings settings = otherwise;
    const Reader reader{json};
    visit(reader, settings);
    return settings;
}

} // namespace moldwright
