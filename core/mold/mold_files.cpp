// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_files.h"

#include "base/stop_point.h"
#include "exchange/mesh_file.h"
#include "mesh/measures.h"
#include "mold/drawing.h"
#include "mold/pour_tilt.h"
#include "mold/three_mf.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Shop practice: what is mixed over what is filled.
constexpr double mixAllowance = 1.1;

Json vectorJson(const Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

Json json(const MoldHalf& half) {
    return {{"volume", half.volume}, {"size", vectorJson(half.size)}, {"faces", half.mesh->faceCount()}};
}

Json rows(const Eigen::Matrix4d& matrix) {
    Json all = Json::array();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            all.push_back(matrix(row, column));
    return all;
}

/// A part's frame to the mold's: made larger first, then moved.
Json partToMold(const Mold& mold, const Isometry3d& motion) {
    const MoldSettings& settings = mold.settings;
    Eigen::Affine3d larger = Eigen::Affine3d::Identity();
    larger.linear() = mold.shrinkFactors.asDiagonal();
    larger.translation() = settings.shrink.origin - mold.shrinkFactors.cwiseProduct(settings.shrink.origin);
    return rows((motion * larger).matrix());
}

Json notes(const Mold& mold) {
    Json all = Json::array();
    for (const Message& note : mold.notes)
        all.push_back(note.english());
    return all;
}

Json parts(const Mold& mold) {
    Json all = Json::array();
    for (const PartOfMold& part : mold.parts) {
        Json json = {{"name", part.name},
                     {"cavities", part.cavities},
                     {"volume", part.volume},
                     {"part_to_mold", partToMold(mold, part.toMold)}};
        if (part.shellVolume > 0)
            json["shell_volume"] = part.shellVolume;
        if (mold.settings.density > 0)
            json["mass_each_g"] =
                (part.shellVolume > 0 ? part.shellVolume : part.volume) / 1000 * mold.settings.density;
        all.push_back(std::move(json));
    }
    return all;
}

Json features(const Mold& mold) {
    Json all = Json::array();
    for (const MoldFeature& feature : mold.features) {
        Json json = {{"kind", feature.kind}, {"name", feature.name}, {"place", vectorJson(feature.place)}};
        if (!feature.part.empty()) {
            json["name"] = feature.name + ' ' + std::to_string(feature.number) + " (" + feature.part + ")";
            json["number"] = feature.number;
            json["part"] = feature.part;
        }
        if (const std::optional<PlacedFeature>& stands = feature.stands) {
            json["number"] = stands->number + 1;
            json["at"] = {stands->place.x(), stands->place.y()};
            json["by_hand"] = feature.byHand;
        }
        for (const auto& [key, value] : feature.numbers)
            json[key] = value;
        if (!feature.note.text.empty())
            json["note"] = feature.note.english();
        all.push_back(std::move(json));
    }
    return all;
}

Json steel(const Mold& mold) {
    Json all = Json::array();
    for (const ThinSteel& thin : mold.steel)
        all.push_back({{"thickness", thin.thickness},
                       {"between", {thin.first, thin.second}},
                       {"place", vectorJson(thin.place)},
                       {"below_limit", thin.thickness < mold.settings.leastSteel}});
    return all;
}

/// Cast hollow: the walls that stay, and what is poured out again.
Json hollowShot(const Mold& mold) {
    const double shell = mold.shellVolume / 1000;
    Json json = {{"wall", mold.settings.hollow.wall},
                 {"volume_cm3", shell},
                 {"poured_out_cm3", mold.cavityVolume / 1000 - shell}};
    if (mold.settings.density > 0) {
        json["mass_g"] = shell * mold.settings.density;
        if (mold.parts.size() == 1) // else each part has its own
            json["mass_each_g"] = shell * mold.settings.density / mold.cavities;
    }
    return json;
}

/// What a shot takes: in cm³, and in grams where the density is known.
Json shot(const Mold& mold) {
    const double volume = (mold.cavityVolume + mold.channelVolume) / 1000;
    Json json = {{"volume_cm3", volume}, {"allowance", mixAllowance}, {"mix_cm3", volume * mixAllowance}};
    if (mold.settings.density > 0) {
        json["density"] = mold.settings.density;
        json["mass_g"] = volume * mold.settings.density;
        json["mix_g"] = volume * mold.settings.density * mixAllowance;
    }
    if (mold.shellVolume > 0)
        json["hollow"] = hollowShot(mold);
    if (mold.settings.blockDensity > 0)
        json["block_mass_g"] = (mold.half1.volume + mold.half2.volume) / 1000 * mold.settings.blockDensity;
    return json;
}

Json shrink(const Mold& mold) {
    const ShrinkSettings& shrink = mold.settings.shrink;
    return {{"percent", vectorJson(shrink.percent)},
            {"formula", shrink.formula == ShrinkFormula::Plus ? "plus" : "divide"},
            {"factors", vectorJson(mold.shrinkFactors)},
            {"origin", vectorJson(shrink.origin)}};
}

/// A press that closes along d needs more than the force along n, and holds the difference sideways.
Json press(const Mold& mold, int side) {
    const Vector3d& d = mold.directions.of(side);
    const double cosine = std::abs(d.z());
    return {{"force_along_d", mold.clampForce / cosine},
            {"side_load", mold.clampForce * std::sqrt(std::max(0.0, 1 - cosine * cosine)) / cosine}};
}

/// Half 2 as it lies, half 1 turned over beside it, then the cast; all standing on the plate.
std::vector<PlateItem> plate(const Mold& mold) {
    Isometry3d turnedOver = Isometry3d::Identity();
    turnedOver.linear() = Vector3d(1, -1, -1).asDiagonal();
    std::array<PlateItem, 3> items = {PlateItem{"Mold half 2", mold.half2.mesh},
                                      PlateItem{"Mold half 1", mold.half1.mesh, turnedOver},
                                      PlateItem{"Cast", mold.cast}};
    constexpr double gap = 10;
    double x = 0;
    for (PlateItem& item : items) {
        const Eigen::AlignedBox3d box = boundingBox(*item.mesh).transformed(item.placement);
        item.placement.pretranslate(Vector3d(x - box.min().x(), -box.min().y(), -box.min().z()));
        x += box.sizes().x() + gap;
    }
    return {items.begin(), items.end()};
}

Result<void> writeMeshes(const Mold& mold, const std::filesystem::path& folder, const std::string& ending,
                         MeshFormat format) {
    const std::array<std::pair<const char*, SharedMesh>, 3> meshes = {
        std::pair{"mold-half-1", mold.half1.mesh},
        std::pair{"mold-half-2", mold.half2.mesh},
        std::pair{"mold-cast", mold.cast},
    };
    for (const auto& [name, mesh] : meshes)
        if (Result<void> done = writeMesh(folder / (name + ending), *mesh, format); !done)
            return done;
    return {};
}

Result<void> writeDrawings(const Mold& mold, const std::filesystem::path& folder, const std::string& ending,
                           std::string (*written)(const Drawing&)) {
    const std::array<std::pair<const char*, Drawing>, 3> drawings = {
        std::pair{"mold-plan", planDrawing(mold)},
        std::pair{"mold-section-x", sectionDrawing(mold, 0)},
        std::pair{"mold-section-y", sectionDrawing(mold, 1)},
    };
    for (const auto& [name, drawing] : drawings)
        if (Result<void> done = writeFileAtomically(folder / (name + ending), written(drawing)); !done)
            return done;
    return {};
}

Result<void> writeAlso(const Mold& mold, const std::filesystem::path& folder, const MoldFormats& also) {
    Result<void> done;
    if (also.obj)
        done = writeMeshes(mold, folder, ".obj", MeshFormat::Obj);
    if (done && also.ply)
        done = writeMeshes(mold, folder, ".ply", MeshFormat::Ply);
    if (done && also.svg)
        done = writeDrawings(mold, folder, ".svg", svgOf);
    if (done && also.dxf)
        done = writeDrawings(mold, folder, ".dxf", dxfOf);
    return done;
}

/// How it leans while it is filled, or had better; null where upright is best.
Json pourTilt(const Mold& mold) {
    if (!mold.leaning)
        return nullptr;
    const LeaningMold& lean = *mold.leaning;
    const Resting resting = mold.settings.spout.resting;
    return {{"degrees", lean.degrees},
            {"towards_deg", lean.towards},
            {"towards", leaningWords(resting, lean.towards)},
            {"up", vectorJson(upWhenLeaning(resting, lean.degrees, lean.towards))},
            {"trapped_air_upright", lean.airUpright},
            {"trapped_air", lean.air},
            {"applied", lean.applied}};
}

} // namespace

std::string moldJson(const Mold& mold) {
    Json whole = {{"version", 1},
                  {"verified", mold.verified()},
                  {"d1", vectorJson(mold.directions.d1)},
                  {"d2", vectorJson(mold.directions.d2)},
                  {"draft_deg", mold.draftDegrees},
                  {"worst_draft_deg", mold.castCertificate.worstDraftDegrees},
                  {"part_to_mold", partToMold(mold, mold.partToMold)},
                  {"parts", parts(mold)},
                  {"material", mold.settings.material ? materialJson(*mold.settings.material) : Json()},
                  {"shrink", shrink(mold)},
                  {"cavities", mold.cavities},
                  {"half1", json(mold.half1)},
                  {"half2", json(mold.half2)},
                  {"block_volume", mold.blockVolume},
                  {"block_size", vectorJson(mold.blockSize)},
                  {"cavity_volume", mold.cavityVolume},
                  {"channel_volume", mold.channelVolume},
                  {"sprue_volume", mold.sprueVolume},
                  {"other_volume", mold.otherVolume},
                  {"shot", shot(mold)},
                  {"parting_area", mold.partingArea},
                  {"clamp_force", mold.clampForce},
                  {"clamp_pressure_bar", mold.settings.pressure},
                  {"press1", press(mold, 1)},
                  {"press2", press(mold, 2)},
                  {"min_wall", mold.minWall},
                  {"min_wall_at", vectorJson(mold.minWallPlace)},
                  {"steel", steel(mold)},
                  {"features", features(mold)},
                  {"path_lengths", mold.pathLengths},
                  {"trapped_air", mold.trappedAir},
                  {"pour_tilt", pourTilt(mold)},
                  {"notes", notes(mold)},
                  {"problems", mold.problems}};
    return whole.dump(2) + "\n";
}

namespace {

Result<void> writeFiles(const Mold& mold, const std::string& partName, const std::filesystem::path& folder,
                        const MoldFormats& also) {
    stopPoint();
    if (Result<void> done = makeFolder(folder); !done)
        return done;
    if (Result<void> done = writeMeshes(mold, folder, ".stl", MeshFormat::StlBinary); !done)
        return done;
    if (Result<void> done = writeAlso(mold, folder, also); !done)
        return done;
    const Result<std::string> threeMf = threeMfBytes("Mold for " + partName, plate(mold));
    if (!threeMf)
        return std::unexpected(threeMf.error());
    if (Result<void> done = writeFileAtomically(folder / "mold.3mf", *threeMf); !done)
        return done;
    return writeFileAtomically(folder / "mold.json", moldJson(mold));
}

} // namespace

Result<void> writeMold(const Mold& mold, const std::string& partName, const std::filesystem::path& folder,
                       const MoldFormats& also, const Task& task) {
    const auto written = unlessStopped(task, [&] { return writeFiles(mold, partName, folder, also); });
    return written ? *written
                   : failure(ErrorCode::Cancelled, MW_TEXT("Mold", "Writing the mold was cancelled."));
}

} // namespace moldwright
