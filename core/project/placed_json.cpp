// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/placed_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr int mostFeatures = 10000; ///< of one kind

std::optional<Placeable> kindIn(const Json& entry) {
    if (!entry.contains("kind") || !entry["kind"].is_string())
        return std::nullopt;
    const auto name =
        std::find(placeableNames.begin(), placeableNames.end(), entry["kind"].get<std::string>());
    return name == placeableNames.end()
               ? std::nullopt
               : std::optional(static_cast<Placeable>(name - placeableNames.begin()));
}

/// The entry as a feature; none where anything of it is wrong.
std::optional<PlacedFeature> featureIn(const Json& entry) {
    const std::optional<Placeable> kind = kindIn(entry);
    const bool numbered = entry.contains("number") && entry["number"].is_number_integer() &&
                          entry["number"].get<std::int64_t>() >= 1 &&
                          entry["number"].get<std::int64_t>() <= mostFeatures;
    const Json& at = entry["at"];
    const bool placed = at.is_array() && at.size() == 2 && at[0].is_number() && at[1].is_number();
    if (!kind || !numbered || !placed)
        return std::nullopt;
    const PlacedFeature feature{
        *kind, entry["number"].get<int>() - 1, {at[0].get<double>(), at[1].get<double>()}};
    return feature.place.allFinite() ? std::optional(feature) : std::nullopt;
}

} // namespace

Json placedJson(const PlacedFeatures& placed) {
    Json list = Json::array();
    for (const PlacedFeature& feature : placed)
        list.push_back({{"kind", placeableNames.at(static_cast<std::size_t>(feature.kind))},
                        {"number", feature.number + 1},
                        {"at", {feature.place.x(), feature.place.y()}}});
    return list;
}

Result<PlacedFeatures> placedFrom(const Json& list, const std::string& where) {
    PlacedFeatures placed;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Json& entry = list[i];
        if (!entry.is_object() || !entry.contains("at"))
            continue;
        const std::string which = std::to_string(i + 1);
        const std::optional<PlacedFeature> feature = featureIn(entry);
        if (!feature)
            return failure(
                ErrorCode::BadInput,
                MW_TEXT(
                    "Guides",
                    "{0}: entry {1} needs a \"kind\" (spout, vent, key, slit, bolt, "
                    "ejector, overflow or pocket), a \"number\" from 1, and \"at\" with two numbers, mm."),
                {where, which});
        const auto before = placeByHand(placed, feature->kind, feature->number);
        if (before && *before != feature->place)
            return failure(ErrorCode::BadInput,
                           MW_TEXT("Guides", "{0}: entry {1} puts a feature to another place than an entry "
                                             "before it."),
                           {where, which});
        placed = withPlaced(std::move(placed), *feature);
    }
    return placed;
}

} // namespace moldwright
