// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/project_file.h"

#include "exchange/mesh_file.h"
#include "project/archive.h"
#include "project/binary_parts.h"
#include "project/edits.h"
#include "project/project_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace moldwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* oldWeightsName = "weights.numbers";
constexpr const char* mimeType = "application/vnd.moldwright.project";
// More than the largest honest part; a part that inflates beyond is damaged or hostile.
constexpr std::size_t textLimit = std::size_t{4} << 20;
constexpr std::size_t pictureLimit = std::size_t{16} << 20;
constexpr std::size_t meshLimit = std::size_t{1} << 30;
constexpr std::uintmax_t fileLimit = std::uintmax_t{2} << 30;

/// The part with the faces or weights of an important region.
std::string regionPartName(std::size_t number, const char* what) {
    return "importance-" + std::to_string(number + 1) + '.' + what;
}

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
    manifest["parts"] = Json::array();
    for (const ArchiveEntry& part : parts)
        manifest["parts"].push_back(part.name);
    return manifest;
}

std::unexpected<Error> damaged(const std::string& fileName, const std::string& part) {
    return failure(ErrorCode::BadInput,
                   MW_TEXT("Project", "{0} is damaged: its part {1} is missing or cannot be read. Open an "
                                      "older copy of the project."),
                   {fileName, part});
}

/// Opens the parts of one file and remembers its name for messages.
class PartSource {
public:
    PartSource(ArchiveReader archive, std::string fileName)
        : m_archive(std::move(archive)), m_fileName(std::move(fileName)) {}

    [[nodiscard]] Result<void> require(const Json& names) const {
        for (const Json& name : names)
            if (!name.is_string() || !m_archive.has(name.get<std::string>()))
                return damaged(m_fileName, name.dump());
        return {};
    }
    [[nodiscard]] bool has(const std::string& name) const { return m_archive.has(name); }

    [[nodiscard]] Result<std::string> bytes(const std::string& name, std::size_t limit) const {
        if (std::optional<std::string> part = m_archive.read(name, limit))
            return *std::move(part);
        return damaged(m_fileName, name);
    }
    [[nodiscard]] Result<Json> json(const std::string& name) const {
        const Result<std::string> text = bytes(name, textLimit);
        if (!text)
            return std::unexpected(text.error());
        Json parsed = Json::parse(*text, nullptr, false);
        if (!parsed.is_object())
            return damaged(m_fileName, name);
        return parsed;
    }
    /// A binary part through its reader.
    template <class T>
    [[nodiscard]] Result<T> part(const std::string& name,
                                 std::optional<T> (*read)(const std::string&)) const {
        const Result<std::string> raw = bytes(name, meshLimit);
        if (!raw)
            return std::unexpected(raw.error());
        if (std::optional<T> value = read(*raw))
            return *std::move(value);
        return damaged(m_fileName, name);
    }
    [[nodiscard]] const std::string& fileName() const { return m_fileName; }

private:
    ArchiveReader m_archive;
    std::string m_fileName;
};

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
        return damaged(parts.fileName(), "manifest.json");
    // Every part that was written must be there: a damaged list of contents may have lost one.
    if (Result<void> complete = parts.require(manifest->value("parts", Json::array())); !complete)
        return std::unexpected(complete.error());
    return manifest;
} catch (const nlohmann::json::exception&) { // a key of another kind
    return damaged(parts.fileName(), "manifest.json");
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

Result<void> readDocumentPart(const PartSource& parts, Project& project, std::optional<CastResult>& cast) {
    const Result<Json> document = parts.json("document.json");
    if (!document)
        return std::unexpected(document.error());
    try {
        readDocument(*document, project, cast);
    } catch (const nlohmann::json::exception&) {
        return damaged(parts.fileName(), "document.json");
    }
    return {};
}

bool areWeights(const std::vector<double>& weights, std::size_t count) {
    return weights.size() == count &&
           std::ranges::all_of(weights, [](double weight) { return weight >= 1 && weight <= mostWeight; });
}

Result<void> readRegion(const PartSource& parts, std::size_t number, Project& project) {
    const std::string facesName = regionPartName(number, "faces");
    const Result<std::string> bytes = parts.bytes(facesName, meshLimit);
    if (!bytes)
        return std::unexpected(bytes.error());
    std::optional<std::vector<int>> faces = readIndicesPart(*bytes, project.part->faceCount());
    if (!faces)
        return damaged(parts.fileName(), facesName);
    const std::string weightsName = regionPartName(number, "weights");
    Result<std::vector<double>> weights = parts.part(weightsName, &readNumbersPart);
    if (!weights)
        return std::unexpected(weights.error());
    if (!areWeights(*weights, faces->size()))
        return damaged(parts.fileName(), weightsName);
    project.importance[number].faces = *std::move(faces);
    project.importance[number].weights = *std::move(weights);
    return {};
}

/// Files written before regions had names hold a weight for each face.
Result<void> readOldWeights(const PartSource& parts, Project& project) {
    const Result<std::vector<double>> weights = parts.part(oldWeightsName, &readNumbersPart);
    if (!weights)
        return std::unexpected(weights.error());
    if (!areWeights(*weights, static_cast<std::size_t>(project.part->faceCount())))
        return damaged(parts.fileName(), oldWeightsName);
    ImportantRegion region{"1", {}, {}, 0};
    for (std::size_t f = 0; f < weights->size(); ++f)
        if ((*weights)[f] > 1) {
            region.faces.push_back(static_cast<int>(f));
            region.weights.push_back((*weights)[f]);
        }
    if (!region.faces.empty())
        project.importance = {std::move(region)};
    return {};
}

Result<void> readPart(const PartSource& parts, Project& project) {
    Result<IndexedMesh> source = parts.part("part.mesh", &readMeshPart);
    if (!source)
        return std::unexpected(source.error());
    project.source = std::make_shared<const IndexedMesh>(*std::move(source));
    project.part = std::make_shared<const IndexedMesh>(placed(*project.source, project.placement));
    if (parts.has(oldWeightsName))
        return readOldWeights(parts, project);
    for (std::size_t i = 0; i < project.importance.size(); ++i)
        if (Result<void> done = readRegion(parts, i, project); !done)
            return done;
    return {};
}

Result<void> readCast(const PartSource& parts, CastResult cast, Project& project) {
    Result<IndexedMesh> mesh = parts.part("cast.mesh", &readMeshPart);
    if (!mesh)
        return std::unexpected(mesh.error());
    Result<SideLabels> labels = parts.part("cast.labels", &readLabelsPart);
    if (!labels)
        return std::unexpected(labels.error());
    if (labels->size() != static_cast<std::size_t>(mesh->faceCount()))
        return damaged(parts.fileName(), "cast.labels");
    if (parts.has("cast.before")) {
        const Result<std::vector<double>> before = parts.part("cast.before", &readNumbersPart);
        if (!before)
            return std::unexpected(before.error());
        if (static_cast<Eigen::Index>(before->size()) != mesh->V.size())
            return damaged(parts.fileName(), "cast.before");
        cast.before = Eigen::Map<const Points>(before->data(), mesh->V.rows(), 3);
    }
    cast.mesh = std::make_shared<const IndexedMesh>(*std::move(mesh));
    cast.labels = *std::move(labels);
    project.cast = std::make_shared<const CastResult>(std::move(cast));
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
    for (std::size_t i = 0; i < project.importance.size(); ++i) {
        entries.push_back({regionPartName(i, "faces"), indicesPart(project.importance[i].faces)});
        entries.push_back({regionPartName(i, "weights"), numbersPart(project.importance[i].weights)});
    }
    if (project.cast) {
        entries.push_back({"cast.mesh", meshPart(*project.cast->mesh)});
        entries.push_back({"cast.labels", labelsPart(project.cast->labels)});
        if (const Points& before = project.cast->before; before.rows() > 0)
            entries.push_back({"cast.before", numbersPart({before.data(), before.data() + before.size()})});
    }
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
    std::optional<CastResult> cast;
    if (Result<void> done = readDocumentPart(*parts, stored.project, cast); !done)
        return std::unexpected(done.error());
    if (manifest->contains("part"))
        if (Result<void> done = readPart(*parts, stored.project); !done)
            return std::unexpected(done.error());
    if (cast)
        if (Result<void> done = readCast(*parts, *std::move(cast), stored.project); !done)
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
