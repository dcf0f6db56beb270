// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/design_files.h"

#include "cli/state_options.h"
#include "exchange/mesh_file.h"
#include "mesh/measures.h"

#include <array>

namespace moldwright::cli {

namespace {

const char* nameOf(Obstruction::Kind kind) {
    switch (kind) {
    case Obstruction::Kind::Pocket:
        return "pocket";
    case Obstruction::Kind::ClosedPiece:
        return "closed_piece";
    case Obstruction::Kind::Handle:
        return "handle";
    case Obstruction::Kind::Link:
        return "link";
    default:
        return "steep_faces";
    }
}

Json jsonOf(const Remedy& remedy, double partVolume) {
    const char* const kind =
        std::array{"plane", "fill", "merge", "pin"}[static_cast<std::size_t>(remedy.kind)];
    Json json = {{"kind", kind}, {"message", remedy.message.english()}};
    switch (remedy.kind) {
    case Remedy::Kind::Plane:
        json["plane"] = cli::jsonOf(remedy.state->plane);
        json["d1"] = cli::jsonOf(remedy.state->directions.d1);
        json["d2"] = cli::jsonOf(remedy.state->directions.d2);
        break;
    case Remedy::Kind::Fill:
    case Remedy::Kind::Merge:
        json["volume"] = remedy.volume;
        json["volume_fraction"] = remedy.volume / partVolume;
        json["fill_at"] = Json::array();
        for (const Eigen::Vector3d& place : remedy.places)
            json["fill_at"].push_back(cli::jsonOf(place));
        break;
    case Remedy::Kind::Pin:
        json["point"] = cli::jsonOf(remedy.places.front());
        break;
    }
    return json;
}

Json jsonOf(const Obstruction& o, double partVolume) {
    Json json = {{"kind", nameOf(o.kind)},
                 {"message", o.message.english()},
                 {"place", cli::jsonOf(o.place)},
                 {"size", o.size},
                 {"side", o.side},
                 {"remedies", Json::array()}};
    for (const Remedy& remedy : o.remedies)
        json["remedies"].push_back(jsonOf(remedy, partVolume));
    return json;
}

Json jsonOf(const Certificate& c) {
    return {{"method",
             "exact draft of every face and simple, nested parting curves, on the coordinates as written"},
            {"holds", c.holds()},
            {"closed_and_outward", c.closedAndOutward},
            {"directions_leave", c.directionsLeave},
            {"draft_holds", c.draftHolds},
            {"curves_on_plane", c.curvesOnPlane},
            {"curves_simple_and_nested", c.curvesSimpleAndNested},
            {"self_intersection_free", c.selfIntersectionFree},
            {"reason", c.reason}};
}

} // namespace

Json designJson(const std::string& inputFile, const DesignRequest& request, const DesignResult& result) {
    const IndexedMesh& part = *request.part;
    Json json = {{"version", 1},
                 {"input",
                  {{"file", inputFile},
                   {"vertices", part.vertexCount()},
                   {"faces", part.faceCount()},
                   {"volume", volume(part)},
                   {"diagonal", diagonal(part)}}},
                 {"castable", result.castable},
                 {"cut_short", result.cutShort},
                 {"plane", cli::jsonOf(result.state.plane)},
                 {"d1", cli::jsonOf(result.state.directions.d1)},
                 {"d2", cli::jsonOf(result.state.directions.d2)},
                 {"draft_deg", request.draftDegrees},
                 {"worst_draft_deg", result.certificate.worstDraftDegrees},
                 {"violating_area_fraction", result.violatingAreaFraction},
                 {"energy", result.energy},
                 {"change",
                  {{"mean_distance", result.change.meanDistance},
                   {"max_distance", result.change.maxDistance},
                   {"volume_ratio", result.change.volumeRatio},
                   {"filled_volume_fraction", result.change.filledVolumeFraction}}},
                 {"strain",
                  {{"rms", result.strain.rms},
                   {"stretch_p01", result.strain.stretchLow},
                   {"stretch_p99", result.strain.stretchHigh},
                   {"roughness_ratio", result.strain.roughness}}},
                 {"tets", result.tets},
                 {"plastic_steps", result.plasticSteps},
                 {"local_global_iterations", result.localGlobalIterations},
                 {"limbs", Json::array()},
                 {"obstructions", Json::array()},
                 {"certificate", jsonOf(result.certificate)},
                 {"warnings", cli::jsonOf(result.warnings)}};
    for (const LimbMeasure& limb : result.limbs)
        json["limbs"].push_back({{"tip", cli::jsonOf(limb.tip)},
                                 {"length_ratio", limb.lengthRatio},
                                 {"volume_ratio", limb.volumeRatio}});
    if (!request.regions.empty())
        json["regions"] = Json::array();
    for (const RegionMeasure& region : result.regions)
        json["regions"].push_back({{"name", region.name},
                                   {"max_distance", region.maxDistance},
                                   {"rms_distance", region.rmsDistance},
                                   {"strain_rms", region.strain},
                                   {"kept", region.kept}});
    if (!request.pins.empty())
        json["pins"] = Json::array();
    for (std::size_t i = 0; i < result.pins.size(); ++i)
        json["pins"].push_back({{"point", cli::jsonOf(request.pins[i].point)},
                                {"place", cli::jsonOf(result.pins[i].place)},
                                {"distance_from_plane", result.pins[i].distanceFromPlane}});
    for (const Obstruction& obstruction : result.obstructions)
        json["obstructions"].push_back(jsonOf(obstruction, volume(part)));
    return json;
}

Json timingsJson(const DesignResult& result) {
    Json json;
    for (const char* key : {"load", "tetrahedralize", "plane", "directions_first", "arap_first",
                            "elastoplastic", "postprocess", "fill", "mold", "total"}) {
        const auto found = result.seconds.find(key);
        json[key] = found == result.seconds.end() ? 0.0 : found->second;
    }
    return json;
}

Result<void> writeDesign(const std::filesystem::path& folder, const std::string& inputFile,
                         const DesignRequest& request, const DesignResult& result) {
    if (Result<void> done = makeFolder(folder); !done)
        return done;
    if (result.cast) {
        if (auto done = writeMesh(folder / "cast.ply", *result.cast, MeshFormat::Ply); !done)
            return done;
        if (auto done = writeMesh(folder / "cast.stl", *result.cast, MeshFormat::StlBinary); !done)
            return done;
    }
    if (result.parted)
        if (auto done = writeSidedMesh(folder / "parted.ply", *result.parted, result.partedLabels); !done)
            return done;
    if (auto done =
            writeFileAtomically(folder / "design.json", textOf(designJson(inputFile, request, result)));
        !done)
        return done;
    return writeFileAtomically(folder / "timings.json", textOf(timingsJson(result)));
}

} // namespace moldwright::cli
