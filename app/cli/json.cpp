// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/json.h"

namespace moldwright::cli {

std::string textOf(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json jsonOf(const Eigen::Vector3d& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json jsonOf(const Eigen::AlignedBox3d& box) {
    return Json::array({jsonOf(Eigen::Vector3d(box.min())), jsonOf(Eigen::Vector3d(box.max()))});
}

Json jsonOf(const std::vector<Message>& messages) {
    Json sentences = Json::array();
    for (const Message& message : messages)
        sentences.push_back(message.english());
    return sentences;
}

} // namespace moldwright::cli
