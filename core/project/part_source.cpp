// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/part_source.h"

#include <nlohmann/json.hpp>

namespace moldwright {

using Json = nlohmann::ordered_json;

Result<void> PartSource::require(const Json& names) const {
    for (const Json& name : names)
        if (!name.is_string() || !m_archive.has(name.get<std::string>()))
            return damaged(name.dump());
    return {};
}

Result<std::string> PartSource::bytes(const std::string& name, std::size_t limit) const {
    if (std::optional<std::string> part = m_archive.read(name, limit))
        return *std::move(part);
    return damaged(name);
}

Result<Json> PartSource::json(const std::string& name) const {
    const Result<std::string> text = bytes(name, textLimit);
    if (!text)
        return std::unexpected(text.error());
    Json parsed = Json::parse(*text, nullptr, false);
    if (!parsed.is_object())
        return damaged(name);
    return parsed;
}

std::unexpected<Error> PartSource::damaged(const std::string& part) const {
    return failure(ErrorCode::BadInput,
                   MW_TEXT("Project", "{0} is damaged: its part {1} is missing or cannot be read. Open an "
                                      "older copy of the project."),
                   {m_fileName, part});
}

} // namespace moldwright
