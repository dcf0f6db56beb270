// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/project_file.h"

#include "exchange/mesh_file.h"
#include "project/archive.h"
#include "project/binary_parts.h"
#include "project/edits.h"
#include "project/part_source.h"
#include "project/project_json.h"
#include "project/variant_parts.h"
#include "project/variants.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* mimeType = "application/vnd.moldwright.project";
constexpr std::size_t pictureLimit = std::size_t{16} << 20;
constexpr std::uintmax_t fileLimit = std::uintmax_t{2} << 30;

Json manifestOf(const Project& project, const std::vector<ArchiveEntry>& parts) {
    const auto counts = [](const IndexedMesh& mesh) {
        return Json{{"points", mesh.vertexCount()}, {"faces", mesh.faceCount()}};
    };
    Json manifest = {{"format", "moldwright-project"},
                     {"version", projectFileVersion},
                     {"minReader", projectFileMinReader},
                     {"name", project.name}};
    if (project.source)
        manifest["part"] = counts(*project.source);
    if (project.cast)
        manifest["cast"] = counts(*project.cast->mesh);
    if (!project.others.empty())
        for (std::size_t i = 0; i < variantCount(project); ++i) {
            const Variant& variant = variantAt(project, i);
            Json entry = {{"name", variant.variantName}, {"current", i == project.place}};
            if (variant.cast)
                entry["cast"] = counts(*variant.cast->mesh);
            manifest["variants"].push_back(std::move(entry));
        }
    for (const TrayPart& part : project.furtherParts)
        manifest["further_parts"].push_back({{"name", part.name}, {"count", part.count}});
    manifest["parts"] = Json::array();
    for (const ArchiveEntry& part : parts)
        manifest["parts"].push_back(part.name);
    return manifest;
}

Result<Json> checkedManifest(const PartSource& parts) try {
    Result<Json> manifest = parts.json("manifest.json");
    if (!manifest)
        return manifest;
    const int minReader = manifest->value("minReader", 0);
    if (minReader > projectFileVersion)
        return failure(ErrorCode::BadInput,
                       MW_TEXT("Project",
                               "{0} was saved by a newer Moldwright. A program that reads format {1} "
                               "is needed; this one reads up to {2}."),
                       {parts.fileName(), std::to_string(minReader), std::to_string(projectFileVersion)});
    if (minReader < 1 || manifest->value("format", "") != "moldwright-project")
        return parts.damaged("manifest.json");
    // Every part that was written must be there: a damaged list of contents may have lost one.
    if (Result<void> complete = parts.require(manifest->value("parts", Json::array())); !complete)
        return std::unexpected(complete.error());
    return manifest;
} catch (const nlohmann::json::exception&) { // a key of another kind
    return parts.damaged("manifest.json");
}

Result<PartSource> openParts(const std::string& bytes, const std::string& fileName) {
    const auto notAProject = [&] {
        return failure(ErrorCode::BadInput, MW_TEXT("Project", "{0} is not a Moldwright project."),
                       {fileName});
    };
    std::optional<ArchiveReader> archive = ArchiveReader::open(bytes);
    if (!archive || archive->read("mimetype", textLimit) != mimeType)
        return notAProject();
    return PartSource(*std::move(archive), fileName);
}

Result<std::vector<DescribedCast>> readDocumentPart(const PartSource& parts, Project& project) {
    const Result<Json> document = parts.json("document.json");
    if (!document)
        return std::unexpected(document.error());
    try {
        return readDocument(*document, project);
    } catch (const nlohmann::json::exception&) {
        return parts.damaged("document.json");
    }
}

Result<void> readPart(const PartSource& parts, Project& project) {
    Result<IndexedMesh> source = parts.part("part.mesh", &readMeshPart);
    if (!source)
        return std::unexpected(source.error());
    project.source = std::make_shared<const IndexedMesh>(*std::move(source));
    project.part = std::make_shared<const IndexedMesh>(placed(*project.source, project.placement));
    return {};
}

Result<std::string> bytesOf(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
        return failure(ErrorCode::BadInput, MW_TEXT("Project", "{0} cannot be opened: {1}."),
                       {file.string(), error.message()});
    if (size > fileLimit)
        return failure(ErrorCode::BadInput, MW_TEXT("Project", "{0} is too large for a project file."),
                       {file.string()});
    std::ifstream in(file, std::ios::binary);
    std::string bytes(size, '\0');
    if (!in.read(bytes.data(), static_cast<std::streamsize>(size)))
        return failure(ErrorCode::BadInput, MW_TEXT("Project", "{0} cannot be read."), {file.string()});
    return bytes;
}

} // namespace

Result<std::string> projectBytes(const StoredProject& stored) {
    const Project& project = stored.project;
    std::vector<ArchiveEntry> entries = {{"document.json", documentJson(project).dump(2) + "\n"}};
    if (project.source)
        entries.push_back({"part.mesh", meshPart(*project.source)});
    addVariantParts(entries, project);
    if (!stored.viewState.empty())
        entries.push_back({"view.json", stored.viewState});
    if (!stored.thumbnail.empty())
        entries.push_back({"thumbnail.png", stored.thumbnail, true});
    const ArchiveEntry manifest{"manifest.json", manifestOf(project, entries).dump(2) + "\n"};
    entries.insert(entries.begin(), {ArchiveEntry{"mimetype", mimeType, true}, manifest});
    return archiveBytes(entries);
}

Result<StoredProject> readProjectBytes(const std::string& bytes, const std::string& fileName) {
    const Result<PartSource> parts = openParts(bytes, fileName);
    if (!parts)
        return std::unexpected(parts.error());
    const Result<Json> manifest = checkedManifest(*parts);
    if (!manifest)
        return std::unexpected(manifest.error());
    StoredProject stored;
    Result<std::vector<DescribedCast>> casts = readDocumentPart(*parts, stored.project);
    if (!casts)
        return std::unexpected(casts.error());
    if (manifest->contains("part"))
        if (Result<void> done = readPart(*parts, stored.project); !done)
            return std::unexpected(done.error());
    if (Result<void> done = readVariantParts(*parts, *std::move(casts), stored.project); !done)
        return std::unexpected(done.error());
    // Without these the model is whole: a damaged one is as good as none.
    stored.viewState = parts->bytes("view.json", textLimit).value_or("");
    stored.thumbnail = parts->bytes("thumbnail.png", pictureLimit).value_or("");
    return stored;
}

Result<void> saveProject(const std::filesystem::path& file, const StoredProject& stored) {
    const Result<std::string> bytes = projectBytes(stored);
    if (!bytes)
        return std::unexpected(bytes.error());
    return writeFileAtomically(file, *bytes);
}

Result<StoredProject> openProject(const std::filesystem::path& file) {
    const Result<std::string> bytes = bytesOf(file);
    if (!bytes)
        return std::unexpected(bytes.error());
    return readProjectBytes(*bytes, file.filename().string());
}

Result<Project> projectAt(const std::filesystem::path& input, const std::string& variant) {
    const std::filesystem::path file =
        std::filesystem::is_directory(input) ? input / "project.moldwright" : input;
    Result<StoredProject> stored = openProject(file);
    if (!stored)
        return std::unexpected(stored.error());
    return atVariant(std::move(stored->project), variant, file.filename().string());
}

Result<std::string> projectManifest(const std::filesystem::path& file) {
    const Result<std::string> bytes = bytesOf(file);
    if (!bytes)
        return std::unexpected(bytes.error());
    const Result<PartSource> parts = openParts(*bytes, file.filename().string());
    if (!parts)
        return std::unexpected(parts.error());
    const Result<Json> manifest = checkedManifest(*parts);
    if (!manifest)
        return std::unexpected(manifest.error());
    return manifest->dump(2) + "\n";
}

} // namespace moldwright
