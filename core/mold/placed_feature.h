// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace moldwright {

/// A kind of feature that can be placed by hand.
enum class Placeable { Spout, Vent, Key, Slit, Bolt, Ejector, Overflow, Pocket };

/// Their names in files, in the order of the enumeration.
inline constexpr std::array<std::string_view, 8> placeableNames = {"spout", "vent",    "key",      "slit",
                                                                   "bolt",  "ejector", "overflow", "pocket"};

/// A feature that stands where a hand put it.
struct PlacedFeature {
    Placeable kind = Placeable::Key;
    int number = 0; ///< from 0, among those of its kind
    /// mm in the parting plane. Of a key, a bolt, a pocket, and a spout in the plane (only its x counts): in
    /// the mold's frame. Of a slit: of its mouth; x < 0 is the block's left face, else the right one. Of a
    /// vent, an ejector pin and a spout through a half: from the middle of its cavity, the same in all
    /// copies. Of an overflow likewise: it stands where the parting line is nearest.
    Eigen::Vector2d place = Eigen::Vector2d::Zero();

    bool operator==(const PlacedFeature&) const = default;
};

/// At most one of each kind and number, ascending by these.
using PlacedFeatures = std::vector<PlacedFeature>;

/// Where a feature was put; none: the program finds it a place.
[[nodiscard]] std::optional<Eigen::Vector2d> placeByHand(const PlacedFeatures& placed, Placeable kind,
                                                         int number);

/// The same with this one put elsewhere, and without it.
[[nodiscard]] PlacedFeatures withPlaced(PlacedFeatures placed, const PlacedFeature& feature);
[[nodiscard]] PlacedFeatures withoutPlaced(PlacedFeatures placed, Placeable kind, int number);

} // namespace moldwright
