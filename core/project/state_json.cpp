// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/state_json.h"

#include <nlohmann/json.hpp>

namespace moldwright {

using Json = nlohmann::ordered_json;
using Eigen::Vector3d;

Json vectorJson(const Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

Vector3d vectorFrom(const Json& j) {
    return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

Json stateJson(const MoldState& state) {
    return {{"normal", vectorJson(state.plane.normal)},
            {"offset", state.plane.offset},
            {"d1", vectorJson(state.directions.d1)},
            {"d2", vectorJson(state.directions.d2)}};
}

MoldState stateFrom(const Json& j) {
    return {{vectorFrom(j.at("normal")), j.at("offset").get<double>()},
            {vectorFrom(j.at("d1")), vectorFrom(j.at("d2"))}};
}

} // namespace moldwright
