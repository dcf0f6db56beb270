// SPDX-License-Identifier: AGPL-3.0-or-later
#include "materials/material.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

MaterialValue value(const Json& j) {
    return {j.at("value").get<double>(), j.value("range", ""), j.at("source").get<std::string>(),
            j.value("status", "sourced")};
}

void putText(Json& j, const char* key, const std::string& text) {
    if (!text.empty())
        j[key] = text;
}

Json valueJson(const MaterialValue& value) {
    Json j{{"value", value.value}};
    putText(j, "range", value.range);
    j["source"] = value.source;
    j["status"] = value.status;
    return j;
}

/// The texts of a preparation with their keys, so that writing and reading cannot disagree.
template <class Visitor, class P>
void visitPreparation(const Visitor& at, P& preparation) {
    at("sealing", preparation.sealing);
    at("release", preparation.release);
    at("filling", preparation.filling);
    at("setting", preparation.setting);
    at("source", preparation.source);
}

Preparation preparation(const Json& j) {
    Preparation read;
    if (j.is_string())
        read.filling = j.get<std::string>();
    else
        visitPreparation([&](const char* key, std::string& text) { text = j.value(key, ""); }, read);
    return read;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace

std::optional<Message> whyImplausible(const Material& m) {
    if (m.id.empty() || m.name.empty())
        return Message{MW_TEXT("Materials", "A material needs a name."), {}};
    if (std::abs(m.shrinkPercent.value) >= 50)
        return Message{MW_TEXT("Materials", "Shrink must be between −50 and 50 %."), {}};
    if (m.draftDegrees.value < 0 || m.draftDegrees.value >= 45)
        return Message{MW_TEXT("Materials", "Draft must be from 0 to less than 45°."), {}};
    if (m.density.value <= 0 || m.density.value >= 30)
        return Message{MW_TEXT("Materials", "Density must be between 0 and 30 g/cm³."), {}};
    if (m.ventDepth && (m.ventDepth->value <= 0 || m.ventDepth->value > 5))
        return Message{MW_TEXT("Materials", "Vents must be more than 0 and at most 5 mm deep."), {}};
    return std::nullopt;
}

Json materialJson(const Material& m) {
    Json j{{"id", m.id}, {"name", m.name}};
    putText(j, "process", m.process);
    j["shrink_percent"] = valueJson(m.shrinkPercent);
    j["formula"] = m.divide ? "divide" : "plus";
    j["draft_deg"] = valueJson(m.draftDegrees);
    j["density_g_cm3"] = valueJson(m.density);
    if (m.ventDepth)
        j["vent_depth_mm"] = valueJson(*m.ventDepth);
    putText(j, "notes", m.notes);
    Json steps = Json::object();
    visitPreparation([&](const char* key, const std::string& text) { putText(steps, key, text); },
                     m.preparation);
    if (!steps.empty())
        j["preparation"] = steps;
    return j;
}

Material materialFromJson(const Json& j) {
    Material m;
    m.id = j.at("id").get<std::string>();
    m.name = j.at("name").get<std::string>();
    m.process = j.value("process", "");
    m.shrinkPercent = value(j.at("shrink_percent"));
    m.divide = j.value("formula", "plus") == "divide";
    m.draftDegrees = value(j.at("draft_deg"));
    m.density = value(j.at("density_g_cm3"));
    if (j.contains("vent_depth_mm"))
        m.ventDepth = value(j.at("vent_depth_mm"));
    m.notes = j.value("notes", "");
    if (j.contains("preparation"))
        m.preparation = preparation(j.at("preparation"));
    return m;
}

Result<std::vector<Material>> materialsFrom(const std::string& json, const std::string& name) try {
    std::vector<Material> table;
    const Json whole = Json::parse(json);
    for (const Json& entry : whole.at("materials")) {
        table.push_back(materialFromJson(entry));
        if (const std::optional<Message> why = whyImplausible(table.back()))
            return failure(ErrorCode::BadInput,
                           MW_TEXT("Materials", "{0}: the material {1} cannot be right. {2}"),
                           {name, table.back().id, why->english()});
    }
    return table;
} catch (const Json::exception& error) {
    return failure(ErrorCode::BadInput, MW_TEXT("Materials", "{0} is not a table of materials: {1}."),
                   {name, error.what()});
}

Result<Material> materialNamed(const std::vector<Material>& table, const std::string& name) {
    std::string known;
    for (const Material& m : table) {
        if (lower(m.id) == lower(name) || lower(m.name) == lower(name))
            return m;
        known += (known.empty() ? "" : ", ") + m.id;
    }
    return failure(ErrorCode::Usage, MW_TEXT("Materials", "There is no material {0}. Known are: {1}."),
                   {name, known});
}

std::vector<Material> withOwn(std::vector<Material> base, const std::vector<Material>& own) {
    for (const Material& m : own) {
        const auto same =
            std::find_if(base.begin(), base.end(), [&](const Material& other) { return other.id == m.id; });
        if (same == base.end())
            base.push_back(m);
        else
            *same = m;
    }
    return base;
}

} // namespace moldwright
