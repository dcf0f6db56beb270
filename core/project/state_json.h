// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

namespace moldwright {

/// Points and mold states in a project file's document; doubles keep every bit. Reading throws
/// nlohmann::json::exception where something is missing or of another kind.

[[nodiscard]] nlohmann::ordered_json vectorJson(const Eigen::Vector3d& v);
[[nodiscard]] Eigen::Vector3d vectorFrom(const nlohmann::ordered_json& j);

[[nodiscard]] nlohmann::ordered_json stateJson(const MoldState& state);
[[nodiscard]] MoldState stateFrom(const nlohmann::ordered_json& j);

} // namespace moldwright
