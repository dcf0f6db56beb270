// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/cavity_places.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view blanks = " \t\r\n,";

/// The shortest text that reads as the same number, whatever the locale.
std::string written(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

/// The numbers of one place; none where anything else stands there.
std::optional<CavityPlace> placeIn(std::string_view text) {
    std::vector<double> numbers;
    while (true) {
        const std::size_t from = text.find_first_not_of(blanks);
        if (from == std::string_view::npos)
            break;
        text.remove_prefix(from);
        double number = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
        if (read.ec != std::errc() || !std::isfinite(number))
            return std::nullopt;
        numbers.push_back(number);
        text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
        if (!text.empty() && blanks.find(text.front()) == std::string_view::npos)
            return std::nullopt;
    }
    if (numbers.size() < 2 || numbers.size() > 3)
        return std::nullopt;
    return CavityPlace{numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0};
}

std::optional<CavityPlace> placeIn(const Json& entry) {
    if (!entry.is_object() || !entry.contains("at"))
        return std::nullopt;
    const Json& at = entry["at"];
    if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number())
        return std::nullopt;
    CavityPlace place{at[0].get<double>(), at[1].get<double>(), 0};
    if (entry.contains("turn_deg")) {
        if (!entry["turn_deg"].is_number())
            return std::nullopt;
        place.turn = entry["turn_deg"].get<double>();
    }
    return place;
}

} // namespace

std::string cavityPlacesText(const std::vector<CavityPlace>& places) {
    std::string text;
    for (const CavityPlace& place : places) {
        text += (text.empty() ? "" : "; ") + written(place.x) + ", " + written(place.y);
        if (place.turn != 0)
            text += ", " + written(place.turn);
    }
    return text;
}

Result<std::vector<CavityPlace>> cavityPlacesOf(std::string_view text) {
    std::vector<CavityPlace> places;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(";\n"), text.size());
        const std::string_view one = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (one.find_first_not_of(blanks) == std::string_view::npos)
            continue;
        const std::optional<CavityPlace> place = placeIn(one);
        if (!place)
            return failure(ErrorCode::BadInput,
                           MW_TEXT("Guides",
                                   "\"{0}\" is no place of a cavity: write x, y and, if it is turned, "
                                   "an angle in degrees; a semicolon between places."),
                           {std::string(one)});
        places.push_back(*place);
    }
    return places;
}

Json cavityPlacesJson(const std::vector<CavityPlace>& places) {
    Json list = Json::array();
    for (const CavityPlace& place : places)
        list.push_back({{"at", {place.x, place.y}}, {"turn_deg", place.turn}});
    return list;
}

Result<std::vector<CavityPlace>> cavityPlacesFrom(const Json& list) {
    std::vector<CavityPlace> places;
    for (const Json& entry : list) {
        const std::optional<CavityPlace> place = placeIn(entry);
        if (!place)
            return failure(ErrorCode::BadInput,
                           MW_TEXT("Guides", "The place of cavity {0} needs \"at\" with two numbers, mm."),
                           {std::to_string(places.size() + 1)});
        places.push_back(*place);
    }
    return places;
}

} // namespace moldwright
