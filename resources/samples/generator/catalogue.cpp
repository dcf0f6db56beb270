// SPDX-License-Identifier: AGPL-3.0-or-later
#include "catalogue.h"

#include "exchange/mesh_file.h"
#include "mesh/measures.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace moldwright::samples {

namespace {

Result<void> requireKnown(const std::vector<std::string>& names, const std::vector<Sample>& samples) {
    for (const std::string& name : names)
        if (std::none_of(samples.begin(), samples.end(), [&](const Sample& s) { return s.name == name; }))
            return failure(ErrorCode::Usage, MW_TEXT("samples", "There is no sample named “{0}”."), {name});
    return {};
}

double toTenths(double mm) {
    return std::round(10 * mm) / 10;
}

} // namespace

Result<void> writeSamples(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    const std::vector<Sample> samples = allSamples();
    if (const auto known = requireKnown(names, samples); !known)
        return known;
    for (const Sample& sample : samples) {
        if (!names.empty() && std::find(names.begin(), names.end(), sample.name) == names.end())
            continue;
        const auto written = writeMesh(folder / (sample.name + ".ply"), makeMesh(sample), MeshFormat::Ply);
        if (!written)
            return written;
    }
    return {};
}

Result<void> writeCatalogue(const std::filesystem::path& folder) {
    nlohmann::ordered_json entries = nlohmann::ordered_json::array();
    for (const Sample& sample : allSamples()) {
        const std::string file = sample.name + ".ply";
        const auto read = readMesh(folder / file);
        if (!read)
            return std::unexpected(read.error());
        const Vector3d size = boundingBox(read->mesh).sizes();
        entries.push_back({{"file", file},
                           {"title", sample.title},
                           {"description", sample.description},
                           {"size_mm", {toTenths(size.x()), toTenths(size.y()), toTenths(size.z())}},
                           {"faces", read->mesh.faceCount()}});
    }
    const nlohmann::ordered_json catalogue = {{"samples", entries}};
    return writeFileAtomically(folder / "samples.json", catalogue.dump(2) + "\n");
}

} // namespace moldwright::samples
