// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace moldwright::cli {

/// JSON that keeps its keys in the order in which they were set.
using Json = nlohmann::ordered_json;

/// The text of a JSON file: indented by two, one line break at the end, foreign bytes made legible.
[[nodiscard]] std::string textOf(const Json& json);

/// `v` as [x,y,z].
[[nodiscard]] Json jsonOf(const Eigen::Vector3d& v);

/// `box` as [[x,y,z],[x,y,z]]: its lowest and highest corner.
[[nodiscard]] Json jsonOf(const Eigen::AlignedBox3d& box);

/// The sentences in English, in order.
[[nodiscard]] Json jsonOf(const std::vector<Message>& messages);

} // namespace moldwright::cli
