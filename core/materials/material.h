// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// A number that someone once measured or chose, with where it comes from.
struct MaterialValue {
    double value = 0;
    std::string range;  ///< as people write it; may be empty
    std::string source; ///< English
    /// "sourced", or what to beware of: "no source", "make a coupon", "ask the data sheet"
    std::string status = "sourced";

    bool operator==(const MaterialValue&) const = default;
};

/// What is done before and while it is cast, in the words of people; each may be empty.
struct Preparation {
    std::string sealing; ///< of the mold
    std::string release; ///< agent
    std::string filling;
    std::string setting; ///< time and temperature
    std::string source;

    bool operator==(const Preparation&) const = default;
};

/// What is cast, and what a mold for it should know.
struct Material {
    std::string id; ///< as it is named on the command line
    std::string name;
    std::string process;
    MaterialValue shrinkPercent; ///< linear; negative where it expands
    bool divide = false;         ///< factor 1/(1 − S) instead of 1 + S
    MaterialValue draftDegrees;
    MaterialValue density;                  ///< g/cm³
    std::optional<MaterialValue> ventDepth; ///< mm, of injection vents
    std::string notes;
    Preparation preparation;

    bool operator==(const Material&) const = default;
};

/// Why the numbers cannot be a material's; none where they can.
[[nodiscard]] std::optional<Message> whyImplausible(const Material& material);

/// A material as it stands in a table, and back. A preparation that is one text, as in tables of old, is read
/// as that of the filling. The second throws as the library does where a value is missing or has the wrong
/// type.
[[nodiscard]] nlohmann::ordered_json materialJson(const Material& material);
[[nodiscard]] Material materialFromJson(const nlohmann::ordered_json& json);

/// The materials of a table (JSON, `materials`: a list). Errors: BadInput, naming the table, the material and
/// what is missing or out of range.
[[nodiscard]] Result<std::vector<Material>> materialsFrom(const std::string& json, const std::string& name);

/// The material with that id or name, letters' case aside. Errors: Usage, with the ids there are.
[[nodiscard]] Result<Material> materialNamed(const std::vector<Material>& table, const std::string& name);

/// `base` with those of `own`: the same id replaces, others follow.
[[nodiscard]] std::vector<Material> withOwn(std::vector<Material> base, const std::vector<Material>& own);

} // namespace moldwright
