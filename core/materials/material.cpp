// SPDX-License-Identifier: AGPL-3.0-or-later
#include "materials/material.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace moldwright {

namespace {

using Json = nlohmann::json;

MaterialValue value(const Json& j) {
    return {j.at("value").get<double>(), j.value("range", ""), j.at("source").get<std::string>(),
            j.value("status", "sourced")};
}

Material material(const Json& j) {
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
    m.preparation = j.value("preparation", "");
    return m;
}

/// Whether the numbers can be a material's.
bool plausible(const Material& m) {
    return std::abs(m.shrinkPercent.value) < 50 && m.draftDegrees.value >= 0 && m.draftDegrees.value < 45 &&
           m.density.value > 0 && m.density.value < 30 && !m.id.empty();
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace

Result<std::vector<Material>> materialsFrom(const std::string& json, const std::string& name) try {
    std::vector<Material> table;
    const Json whole = Json::parse(json);
    for (const Json& entry : whole.at("materials")) {
        table.push_back(material(entry));
        if (!plausible(table.back()))
            return failure(ErrorCode::BadInput,
                           MW_TEXT("Materials", "{0}: the numbers of the material {1} cannot be right."),
                           {name, table.back().id});
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
