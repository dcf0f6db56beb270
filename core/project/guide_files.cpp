// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/guide_files.h"

#include "mesh/closest_point.h"
#include "mesh/measures.h"
#include "pins/cgal/inside_test.h"
#include "project/placed_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kOnSurface = 1e-3; ///< diagonals that a pin may lie outside: written by hand, or rounded

std::unexpected<Error> refused(std::string text, std::vector<std::string> arguments) {
    return failure(ErrorCode::BadInput, std::move(text), std::move(arguments));
}

/// The list under `key` of a JSON file.
Result<Json> readList(const std::filesystem::path& file, const std::string& key) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    if (!in)
        return refused(MW_TEXT("Guides", "{0} could not be read."), {file.string()});
    Json json;
    try {
        json = Json::parse(bytes.str());
    } catch (const Json::parse_error& error) {
        return refused(MW_TEXT("Guides", "{0} is not JSON: it goes wrong at byte {1}."),
                       {file.string(), std::to_string(error.byte)});
    }
    if (!json.is_object() || !json.contains(key) || !json[key].is_array())
        return refused(MW_TEXT("Guides", "{0} has no list \"{1}\"."), {file.string(), key});
    return std::move(json[key]);
}

std::optional<double> numberUnder(const Json& entry, const char* key) {
    if (!entry.is_object() || !entry.contains(key) || !entry[key].is_number())
        return std::nullopt;
    const double value = entry[key].get<double>();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<Eigen::Vector3d> pointUnder(const Json& entry, const char* key) {
    if (!entry.is_object() || !entry.contains(key) || !entry[key].is_array() || entry[key].size() != 3)
        return std::nullopt;
    Eigen::Vector3d point;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!entry[key][k].is_number())
            return std::nullopt;
        point[static_cast<Eigen::Index>(k)] = entry[key][k].get<double>();
    }
    return point.allFinite() ? std::optional(point) : std::nullopt;
}

std::vector<int> facesInBall(const IndexedMesh& part, const Eigen::Vector3d& centre, double radius) {
    std::vector<int> faces;
    for (int f = 0; f < part.faceCount(); ++f)
        if (((part.corner(f, 0) + part.corner(f, 1) + part.corner(f, 2)) / 3 - centre).norm() <= radius)
            faces.push_back(f);
    return faces;
}

/// The faces listed in an entry; none where it lists anything else.
std::optional<std::vector<int>> facesListed(const Json& list, const IndexedMesh& part) {
    std::vector<int> faces;
    for (const Json& face : list) {
        if (!face.is_number_integer() || face.get<std::int64_t>() < 0 ||
            face.get<std::int64_t>() >= part.faceCount())
            return std::nullopt;
        faces.push_back(face.get<int>());
    }
    return faces;
}

/// The faces of a region. `which` names the entry for sentences.
Result<std::vector<int>> facesOf(const Json& entry, const IndexedMesh& part,
                                 const std::vector<std::string>& which) {
    if (entry.is_object() && entry.contains("faces")) {
        const auto faces =
            entry["faces"].is_array() ? facesListed(entry["faces"], part) : std::optional<std::vector<int>>();
        if (!faces)
            return refused(
                MW_TEXT("Guides", "{0}: the \"faces\" of region {1} have to be numbers from 0 to {2}."),
                {which[0], which[1], std::to_string(part.faceCount() - 1)});
        return *faces;
    }
    const std::optional<Eigen::Vector3d> centre = pointUnder(entry, "centre");
    const std::optional<double> radius = numberUnder(entry, "radius");
    if (!centre || !radius || !(*radius > 0))
        return refused(MW_TEXT("Guides", "{0}: region {1} needs a \"centre\" of three numbers and a positive "
                                         "\"radius\", or a list of \"faces\"."),
                       which);
    return facesInBall(part, *centre, *radius);
}

/// The weight of each of `count` faces of an entry; none where they are anything else.
std::optional<std::vector<double>> weightsOf(const Json& entry, std::size_t count) {
    std::vector<double> weights;
    if (const std::optional<double> weight = numberUnder(entry, "weight"))
        weights = {*weight};
    else if (entry.is_object() && entry.contains("faces") && entry.contains("weight") &&
             entry["weight"].is_array() && entry["weight"].size() == count)
        for (const Json& number : entry["weight"])
            weights.push_back(number.is_number() ? number.get<double>() : 0);
    const bool sound =
        std::ranges::all_of(weights, [](double weight) { return weight >= 1 && weight <= mostWeight; });
    if (weights.empty() || !sound)
        return std::nullopt;
    weights.resize(count, weights.front());
    return weights;
}

/// Faces in their order with their weights; of a face that is listed twice the larger one.
void setFaces(ImportantRegion& region, const std::vector<int>& faces, const std::vector<double>& weights) {
    std::map<int, double> weightOf;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        double& here = weightOf[faces[i]];
        here = std::max(here, weights[i]);
    }
    for (const auto& [face, weight] : weightOf) {
        region.faces.push_back(face);
        region.weights.push_back(weight);
    }
}

/// A region with its name and limit.
Result<ImportantRegion> regionOf(const Json& entry, const IndexedMesh& part,
                                 const std::vector<std::string>& which) {
    Result<std::vector<int>> faces = facesOf(entry, part, which);
    if (!faces)
        return std::unexpected(faces.error());
    const std::optional<std::vector<double>> weights = weightsOf(entry, faces->size());
    if (!weights)
        return refused(MW_TEXT("Guides",
                               "{0}: region {1} needs a \"weight\" from 1 (like the rest) to 65536, "
                               "or with \"faces\" a list of such, one for each."),
                       which);
    if (faces->empty())
        return refused(MW_TEXT("Guides", "{0}: region {1} has no face of the part in it."), which);
    ImportantRegion region{which[1], {}, {}, 0};
    setFaces(region, *faces, *weights);
    if (entry.contains("name") && entry["name"].is_string())
        region.name = entry["name"].get<std::string>();
    if (entry.contains("keep_within")) {
        const std::optional<double> within = numberUnder(entry, "keep_within");
        if (!within || !(*within > 0))
            return refused(MW_TEXT("Guides",
                                   "{0}: the \"keep_within\" of region {1} has to be a positive number "
                                   "of millimetres."),
                           which);
        region.keepWithin = *within;
    }
    return region;
}

} // namespace

Result<std::vector<NamedPin>> readPins(const std::filesystem::path& file, const IndexedMesh& part) {
    const Result<Json> list = readList(file, "pins");
    if (!list)
        return std::unexpected(list.error());
    const InsideTest solid(part);
    const ClosestPoint surface(part);
    std::vector<NamedPin> pins;
    for (const Json& entry : *list) {
        const std::string which = std::to_string(pins.size() + 1);
        const std::optional<Eigen::Vector3d> point = pointUnder(entry, "point");
        if (!point)
            return refused(MW_TEXT("Guides", "{0}: pin {1} needs a \"point\" of three numbers."),
                           {file.string(), which});
        const double outside = solid.inside(*point) ? 0 : surface.distance(*point);
        if (outside > kOnSurface * diagonal(part))
            return refused(MW_TEXT("Guides",
                                   "{0}: pin {1} lies {2} mm outside the part. Pins are in the part's "
                                   "millimetres, after --units, --scale or --size."),
                           {file.string(), which, readable(outside, 3)});
        const bool named = entry.contains("name") && entry["name"].is_string();
        pins.push_back({{*point}, named ? entry["name"].get<std::string>() : std::string()});
    }
    return pins;
}

std::string pinsText(const std::vector<NamedPin>& pins) {
    Json list = Json::array();
    for (const NamedPin& pin : pins) {
        list.push_back({{"point", {pin.point.x(), pin.point.y(), pin.point.z()}}});
        if (!pin.name.empty())
            list.back()["name"] = pin.name;
    }
    return Json{{"pins", std::move(list)}}.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<std::vector<ImportantRegion>> readWeights(const std::filesystem::path& file, const IndexedMesh& part) {
    const Result<Json> list = readList(file, "regions");
    if (!list)
        return std::unexpected(list.error());
    std::vector<ImportantRegion> regions;
    for (const Json& entry : *list) {
        Result<ImportantRegion> region =
            regionOf(entry, part, {file.string(), std::to_string(regions.size() + 1)});
        if (!region)
            return std::unexpected(region.error());
        regions.push_back(std::move(*region));
    }
    return regions;
}

Result<PlacedFeatures> readPlaces(const std::filesystem::path& file) {
    const Result<Json> list = readList(file, "features");
    if (!list)
        return std::unexpected(list.error());
    return placedFrom(*list, file.string());
}

std::string weightsText(const std::vector<ImportantRegion>& regions) {
    std::string lines;
    for (const ImportantRegion& region : regions) {
        Json entry = {{"name", region.name}};
        const bool even = std::ranges::all_of(
            region.weights, [&](double weight) { return weight == region.weights.front(); });
        entry["weight"] =
            even && !region.weights.empty() ? Json(region.weights.front()) : Json(region.weights);
        if (region.keepWithin > 0)
            entry["keep_within"] = region.keepWithin;
        entry["faces"] = region.faces;
        lines +=
            (lines.empty() ? "\n " : ",\n ") + entry.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return "{\"regions\": [" + lines + "\n]}\n";
}

} // namespace moldwright
