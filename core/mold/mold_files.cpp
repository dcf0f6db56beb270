// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_files.h"

#include "exchange/mesh_file.h"
#include "mesh/measures.h"
#include "mold/three_mf.h"

#include <nlohmann/json.hpp>

#include <array>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;
using Eigen::Isometry3d;
using Eigen::Vector3d;

Json json(const Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

Json json(const MoldHalf& half) {
    return {{"volume", half.volume}, {"size", json(half.size)}, {"faces", half.mesh->faceCount()}};
}

Json json(const Isometry3d& motion) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            rows.push_back(motion.matrix()(row, column));
    return rows;
}

Json features(const Mold& mold) {
    return {{{"kind", "block"},
             {"name", "Block"},
             {"size",
              json({mold.half1.size.x(), mold.half1.size.y(), mold.half1.size.z() + mold.half2.size.z()})},
             {"wall", mold.settings.wall},
             {"floor", mold.settings.floor},
             {"ceiling", mold.settings.ceiling}},
            {{"kind", "cavity"},
             {"name", "Cavity"},
             {"volume", mold.cavityVolume},
             {"size", json(boundingBox(*mold.cast).sizes())}}};
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

Result<void> writeMeshes(const Mold& mold, const std::filesystem::path& folder) {
    const std::array<std::pair<const char*, SharedMesh>, 3> meshes = {
        std::pair{"mold-half-1.stl", mold.half1.mesh},
        std::pair{"mold-half-2.stl", mold.half2.mesh},
        std::pair{"mold-cast.stl", mold.cast},
    };
    for (const auto& [name, mesh] : meshes)
        if (Result<void> done = writeMesh(folder / name, *mesh, MeshFormat::StlBinary); !done)
            return done;
    return {};
}

} // namespace

std::string moldJson(const Mold& mold) {
    Json whole = {{"version", 1},
                  {"verified", mold.verified()},
                  {"d1", json(mold.directions.d1)},
                  {"d2", json(mold.directions.d2)},
                  {"draft_deg", mold.draftDegrees},
                  {"worst_draft_deg", mold.castCertificate.worstDraftDegrees},
                  {"part_to_mold", json(mold.partToMold)},
                  {"half1", json(mold.half1)},
                  {"half2", json(mold.half2)},
                  {"cavity_volume", mold.cavityVolume},
                  {"channel_volume", mold.channelVolume},
                  {"parting_area", mold.partingArea},
                  {"clamp_force", mold.clampForce},
                  {"clamp_pressure_bar", mold.settings.pressure},
                  {"min_wall", mold.minWall},
                  {"min_wall_at", json(mold.minWallPlace)},
                  {"features", features(mold)},
                  {"problems", mold.problems}};
    return whole.dump(2) + "\n";
}

Result<void> writeMold(const Mold& mold, const std::string& partName, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return failure(ErrorCode::WriteFailed, MW_TEXT("Mold", "The folder {0} could not be made: {1}."),
                       {folder.string(), error.message()});
    if (Result<void> done = writeMeshes(mold, folder); !done)
        return done;
    const Result<std::string> threeMf = threeMfBytes("Mold for " + partName, plate(mold));
    if (!threeMf)
        return std::unexpected(threeMf.error());
    if (Result<void> done = writeFileAtomically(folder / "mold.3mf", *threeMf); !done)
        return done;
    return writeFileAtomically(folder / "mold.json", moldJson(mold));
}

} // namespace moldwright
