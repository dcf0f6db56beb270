// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/placed_feature.h"

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

auto find(auto& placed, Placeable kind, int number) {
    return std::lower_bound(placed.begin(), placed.end(), std::pair(kind, number),
                            [](const PlacedFeature& feature, const std::pair<Placeable, int>& key) {
                                return std::pair(feature.kind, feature.number) < key;
                            });
}

bool is(const PlacedFeature& feature, Placeable kind, int number) {
    return feature.kind == kind && feature.number == number;
}

} // namespace

std::optional<Eigen::Vector2d> placeByHand(const PlacedFeatures& placed, Placeable kind, int number) {
    const auto at = find(placed, kind, number);
    return at != placed.end() && is(*at, kind, number) ? std::optional(at->place) : std::nullopt;
}

PlacedFeatures withPlaced(PlacedFeatures placed, const PlacedFeature& feature) {
    const auto at = find(placed, feature.kind, feature.number);
    if (at != placed.end() && is(*at, feature.kind, feature.number))
        *at = feature;
    else
        placed.insert(at, feature);
    return placed;
}

PlacedFeatures withoutPlaced(PlacedFeatures placed, Placeable kind, int number) {
    std::erase_if(placed, [&](const PlacedFeature& feature) { return is(feature, kind, number); });
    return placed;
}

} // namespace moldwright
