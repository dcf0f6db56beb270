// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/project_json.h"

#include "project/further_parts_json.h"
#include "project/mold_settings_json.h"
#include "project/state_json.h"
#include "project/variants.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

// Names in files, in the order of the enumerations.
constexpr std::array<std::string_view, 4> unitNames = {"mm", "cm", "m", "in"};
constexpr std::array<std::string_view, 3> directionsNames = {"automatic", "normal", "given"};
constexpr std::array<std::string_view, 2> methodNames = {"default", "paper"};
constexpr std::array<std::string_view, 2> fillNames = {"none", "auto"};
constexpr std::array<std::string_view, 2> treatmentNames = {"bend", "fill"};

template <class E, std::size_t N>
Json nameOf(E value, const std::array<std::string_view, N>& names) {
    return names.at(static_cast<std::size_t>(value));
}

template <class E, std::size_t N>
E valueOf(const Json& name, const std::array<std::string_view, N>& names) {
    const auto found = std::find(names.begin(), names.end(), name.get<std::string>());
    if (found == names.end())
        throw Json::other_error::create(501, "unknown name " + name.get<std::string>(), &name);
    return static_cast<E>(found - names.begin());
}

Json json(const Placement& placement) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            rows.push_back(placement.motion.matrix()(row, column));
    return {{"unit", nameOf(placement.unit, unitNames)}, {"scale", placement.scale}, {"motion", rows}};
}
Placement placement(const Json& j) {
    Placement result;
    result.unit = valueOf<Unit>(j.at("unit"), unitNames);
    result.scale = j.at("scale").get<double>();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            result.motion.matrix()(row, column) =
                j.at("motion").at(static_cast<std::size_t>(4 * row + column)).get<double>();
    return result;
}

Json json(const DesignSettings& design) {
    Json result = {{"draft_deg", design.draftDegrees},
                   {"max_tilt_deg", design.limits.maxTiltDegrees},
                   {"directions", nameOf(design.directionsChoice, directionsNames)},
                   {"method", nameOf(design.method, methodNames)},
                   {"fill", nameOf(design.fill, fillNames)},
                   {"seed", design.seed},
                   {"smoothing", design.smoothing},
                   {"follow_directions", design.followDirections}};
    if (design.limits.axis) {
        result["axis"] = vectorJson(*design.limits.axis);
        result["cone_deg"] = design.limits.coneDegrees;
    }
    return result;
}
DesignSettings designSettings(const Json& j) {
    DesignSettings design{j.at("draft_deg").get<double>(),
                          {j.at("max_tilt_deg").get<double>()},
                          valueOf<DirectionsChoice>(j.at("directions"), directionsNames),
                          valueOf<DeformationMethod>(j.at("method"), methodNames),
                          {},
                          j.at("seed").get<unsigned>()};
    // Files written before filling existed do not name it.
    design.fill = j.contains("fill") ? valueOf<FillChoice>(j.at("fill"), fillNames) : FillChoice::Auto;
    design.smoothing = j.value("smoothing", design.smoothing);
    design.followDirections = j.value("follow_directions", design.followDirections);
    if (j.contains("axis")) {
        design.limits.axis = vectorFrom(j.at("axis"));
        design.limits.coneDegrees = j.at("cone_deg").get<double>();
    }
    return design;
}

Json json(const CastResult& cast) {
    Json limbs = Json::array();
    for (const LimbMeasure& limb : cast.limbs)
        limbs.push_back({{"tip", vectorJson(limb.tip)},
                         {"length_ratio", limb.lengthRatio},
                         {"volume_ratio", limb.volumeRatio}});
    Json regions = Json::array();
    for (const RegionMeasure& region : cast.regions)
        regions.push_back({{"name", region.name},
                           {"max_distance", region.maxDistance},
                           {"rms_distance", region.rmsDistance},
                           {"strain_rms", region.strain},
                           {"kept", region.kept}});
    return {{"state", stateJson(cast.state)},
            {"draft_deg", cast.draftDegrees},
            {"change",
             {{"mean_distance", cast.change.meanDistance},
              {"max_distance", cast.change.maxDistance},
              {"volume_ratio", cast.change.volumeRatio},
              {"filled_volume_fraction", cast.change.filledVolumeFraction}}},
            {"limbs", limbs},
            {"regions", regions},
            {"steps", cast.steps}};
}
CastResult castResult(const Json& j) {
    CastResult cast;
    cast.state = stateFrom(j.at("state"));
    cast.draftDegrees = j.at("draft_deg").get<double>();
    const Json& change = j.at("change");
    cast.change = {change.at("mean_distance").get<double>(), change.at("max_distance").get<double>(),
                   change.at("volume_ratio").get<double>(),
                   change.at("filled_volume_fraction").get<double>()};
    for (const Json& limb : j.at("limbs"))
        cast.limbs.push_back({vectorFrom(limb.at("tip")), limb.at("length_ratio").get<double>(),
                              limb.at("volume_ratio").get<double>()});
    // Files written before regions were measured have none.
    for (const Json& region : j.value("regions", Json::array()))
        cast.regions.push_back({region.at("name").get<std::string>(), region.at("max_distance").get<double>(),
                                region.at("rms_distance").get<double>(),
                                region.at("strain_rms").get<double>(), region.at("kept").get<bool>()});
    cast.steps = j.value("steps", 0);
    return cast;
}

Json json(const Variant& variant) {
    Json result = {{"plane_chosen_by_hand", variant.planeChosenByHand},
                   {"design", json(variant.design)},
                   {"mold", moldSettingsJson(variant.mold)},
                   {"pins", Json::array()}};
    for (const NamedPin& pin : variant.pins)
        result["pins"].push_back(vectorJson(pin.point));
    // Beside the points, where programs that know no names do not look.
    if (std::ranges::any_of(variant.pins, [](const NamedPin& pin) { return !pin.name.empty(); }))
        for (const NamedPin& pin : variant.pins)
            result["pin_names"].push_back(pin.name);
    if (!variant.undercuts.empty())
        result["undercuts"] = Json::array();
    for (const UndercutChoice& choice : variant.undercuts)
        result["undercuts"].push_back(
            {{"place", vectorJson(choice.place)}, {"treatment", nameOf(choice.treatment, treatmentNames)}});
    if (!variant.importance.empty())
        result["importance"] = Json::array();
    for (const ImportantRegion& region : variant.importance)
        result["importance"].push_back({{"name", region.name}, {"keep_within", region.keepWithin}});
    if (variant.state)
        result["state"] = stateJson(*variant.state);
    return result;
}
void readVariant(const Json& j, Variant& variant) {
    variant.planeChosenByHand = j.at("plane_chosen_by_hand").get<bool>();
    variant.design = designSettings(j.at("design"));
    variant.mold = moldSettingsFrom(j.at("mold"));
    const Json names = j.value("pin_names", Json::array());
    for (const Json& pin : j.at("pins")) {
        const std::size_t number = variant.pins.size();
        variant.pins.push_back(
            {{vectorFrom(pin)}, number < names.size() ? names[number].get<std::string>() : std::string()});
    }
    for (const Json& choice : j.value("undercuts", Json::array()))
        variant.undercuts.push_back(
            {vectorFrom(choice.at("place")),
             valueOf<UndercutChoice::Treatment>(choice.at("treatment"), treatmentNames)});
    for (const Json& region : j.value("importance", Json::array()))
        variant.importance.push_back(
            {region.at("name").get<std::string>(), {}, {}, region.at("keep_within").get<double>()});
    if (j.contains("state"))
        variant.state = stateFrom(j.at("state"));
}

DescribedCast describedCast(const Json& j, std::size_t number) {
    DescribedCast cast;
    if (j.contains("cast"))
        cast.own = castResult(j.at("cast"));
    if (j.contains("cast_of")) {
        cast.sameAs = j.at("cast_of").get<std::size_t>();
        if (*cast.sameAs >= number)
            throw Json::other_error::create(501, "a cast of a variant that is not read yet", &j);
    }
    return cast;
}

/// Names are what variants are told apart by.
void requireNames(const Project& project, const Json& document) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < variantCount(project); ++i)
        if (const std::string& name = variantAt(project, i).variantName;
            name.empty() || !names.insert(name).second)
            throw Json::other_error::create(501, "a name of two variants", &document);
}

void addVariants(Json& document, const Project& project) {
    document["variant"] = {{"name", project.variantName}, {"place", project.place}};
    document["variants"] = Json::array();
    for (std::size_t i = 0; i < project.others.size(); ++i) {
        const Variant& other = project.others[i];
        Json entry = {{"name", other.variantName}};
        entry.update(json(other));
        if (const auto shared = sharedCast(project, i))
            entry["cast_of"] = *shared;
        else if (other.cast)
            entry["cast"] = json(*other.cast);
        document["variants"].push_back(std::move(entry));
    }
}

} // namespace

std::optional<std::size_t> sharedCast(const Project& project, std::size_t other) {
    const auto& cast = project.others[other].cast;
    if (!cast)
        return std::nullopt;
    if (cast == project.cast)
        return 0;
    for (std::size_t i = 0; i < other; ++i)
        if (project.others[i].cast == cast)
            return i + 1;
    return std::nullopt;
}

nlohmann::ordered_json documentJson(const Project& project) {
    Json document = {
        {"name", project.name}, {"source_file", project.sourceFile}, {"placement", json(project.placement)}};
    if (!project.number.empty())
        document["part_number"] = project.number;
    if (!project.revision.empty())
        document["revision"] = project.revision;
    document.update(json(static_cast<const Variant&>(project)));
    if (project.cast)
        document["cast"] = json(*project.cast);
    if (!project.others.empty() || project.variantName != Variant().variantName)
        addVariants(document, project);
    addFurtherParts(document, project);
    return document;
}

std::vector<DescribedCast> readDocument(const nlohmann::ordered_json& document, Project& project) {
    project.name = document.at("name").get<std::string>();
    project.sourceFile = document.at("source_file").get<std::string>();
    project.number = document.value("part_number", "");
    project.revision = document.value("revision", "");
    project.placement = placement(document.at("placement"));
    readVariant(document, project);
    std::vector<DescribedCast> casts = {describedCast(document, 0)};
    // Files written before there were variants have one without a name.
    if (document.contains("variant"))
        project.variantName = document.at("variant").at("name").get<std::string>();
    for (const Json& entry : document.value("variants", Json::array())) {
        Variant& other = project.others.emplace_back();
        other.variantName = entry.at("name").get<std::string>();
        readVariant(entry, other);
        casts.push_back(describedCast(entry, casts.size()));
    }
    if (document.contains("variant"))
        project.place =
            std::min(document.at("variant").at("place").get<std::size_t>(), project.others.size());
    readFurtherParts(document, project);
    requireNames(project, document);
    return casts;
}

} // namespace moldwright
