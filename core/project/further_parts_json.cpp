// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/further_parts_json.h"

#include "project/further_parts.h"
#include "project/state_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

Json json(const std::vector<TrayPart>& parts, const std::vector<SharedCast>& casts) {
    Json list = Json::array();
    for (const TrayPart& part : parts)
        list.push_back({{"name", part.name},
                        {"source", part.source},
                        {"count", part.count},
                        {"cast", std::ranges::find(casts, part.cast) - casts.begin()}});
    return list;
}

[[noreturn]] void refuse(const char* why, const Json& where) {
    throw Json::other_error::create(501, why, &where);
}

std::vector<TrayPart> partsFrom(const Json& variant, const std::vector<SharedCast>& casts) {
    std::vector<TrayPart> parts;
    for (const Json& entry : variant.value("further_parts", Json::array())) {
        const auto cast = entry.at("cast").get<std::size_t>();
        if (cast >= casts.size())
            refuse("a further part whose cast is not there", entry);
        const int count = entry.at("count").get<int>();
        if (count < 1 || count > mostCavities)
            refuse("a number of cavities that no mold can have", entry);
        parts.push_back(
            {casts[cast], entry.at("name").get<std::string>(), entry.at("source").get<std::string>(), count});
    }
    return parts;
}

} // namespace

std::vector<SharedCast> furtherCasts(const Project& project) {
    std::vector<SharedCast> casts;
    const auto add = [&](const Variant& variant) {
        for (const TrayPart& part : variant.furtherParts)
            if (std::ranges::find(casts, part.cast) == casts.end())
                casts.push_back(part.cast);
    };
    add(project);
    std::ranges::for_each(project.others, add);
    return casts;
}

void addFurtherParts(Json& document, const Project& project) {
    const std::vector<SharedCast> casts = furtherCasts(project);
    for (const SharedCast& cast : casts)
        document["further_casts"].push_back({{"state", stateJson(cast->state)}});
    if (!project.furtherParts.empty())
        document["further_parts"] = json(project.furtherParts, casts);
    for (std::size_t i = 0; i < project.others.size(); ++i)
        if (const auto& parts = project.others[i].furtherParts; !parts.empty())
            document["variants"][i]["further_parts"] = json(parts, casts);
}

void readFurtherParts(const Json& document, Project& project) {
    std::vector<SharedCast> casts;
    for (const Json& cast : document.value("further_casts", Json::array()))
        casts.push_back(
            std::make_shared<const CertifiedCast>(CertifiedCast{nullptr, {}, stateFrom(cast.at("state"))}));
    project.furtherParts = partsFrom(document, casts);
    for (std::size_t i = 0; i < project.others.size(); ++i)
        project.others[i].furtherParts = partsFrom(document.at("variants").at(i), casts);
    // Their meshes are found by this order.
    if (furtherCasts(project) != casts)
        refuse("casts of further parts in another order than the parts", document);
}

} // namespace moldwright
