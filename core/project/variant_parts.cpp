// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/variant_parts.h"

#include "project/binary_parts.h"
#include "project/further_parts_json.h"

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

constexpr const char* oldWeightsName = "weights.numbers";

/// How the names of a variant's parts begin; 0 is the current one.
std::string prefixOf(std::size_t number) {
    return number == 0 ? std::string() : "variant-" + std::to_string(number) + '-';
}

/// The part with the faces or weights of an important region.
std::string regionPartName(const std::string& prefix, std::size_t number, const char* what) {
    return prefix + "importance-" + std::to_string(number + 1) + '.' + what;
}

void addRegions(std::vector<ArchiveEntry>& entries, const Variant& variant, const std::string& prefix) {
    for (std::size_t i = 0; i < variant.importance.size(); ++i) {
        entries.push_back({regionPartName(prefix, i, "faces"), indicesPart(variant.importance[i].faces)});
        entries.push_back({regionPartName(prefix, i, "weights"), numbersPart(variant.importance[i].weights)});
    }
}

/// How the names of the parts of a further cast begin.
std::string furtherName(std::size_t number) {
    return "further-cast-" + std::to_string(number + 1);
}

void addSurface(std::vector<ArchiveEntry>& entries, const CertifiedCast& cast, const std::string& name) {
    entries.push_back({name + ".mesh", meshPart(*cast.mesh)});
    entries.push_back({name + ".labels", labelsPart(cast.labels)});
}

void addCast(std::vector<ArchiveEntry>& entries, const CastResult& cast, const std::string& prefix) {
    addSurface(entries, cast, prefix + "cast");
    if (const Points& before = cast.before; before.rows() > 0)
        entries.push_back(
            {prefix + "cast.before", numbersPart({before.data(), before.data() + before.size()})});
}

bool areWeights(const std::vector<double>& weights, std::size_t count) {
    return weights.size() == count &&
           std::ranges::all_of(weights, [](double weight) { return weight >= 1 && weight <= mostWeight; });
}

Result<void> readRegion(const PartSource& parts, const std::string& prefix, std::size_t number, int faceCount,
                        ImportantRegion& region) {
    const std::string facesName = regionPartName(prefix, number, "faces");
    const Result<std::string> bytes = parts.bytes(facesName, meshLimit);
    if (!bytes)
        return std::unexpected(bytes.error());
    std::optional<std::vector<int>> faces = readIndicesPart(*bytes, faceCount);
    if (!faces)
        return parts.damaged(facesName);
    const std::string weightsName = regionPartName(prefix, number, "weights");
    Result<std::vector<double>> weights = parts.part(weightsName, &readNumbersPart);
    if (!weights)
        return std::unexpected(weights.error());
    if (!areWeights(*weights, faces->size()))
        return parts.damaged(weightsName);
    region.faces = *std::move(faces);
    region.weights = *std::move(weights);
    return {};
}

/// Files written before regions had names hold a weight for each face.
Result<void> readOldWeights(const PartSource& parts, Project& project) {
    const Result<std::vector<double>> weights = parts.part(oldWeightsName, &readNumbersPart);
    if (!weights)
        return std::unexpected(weights.error());
    if (!areWeights(*weights, static_cast<std::size_t>(project.part->faceCount())))
        return parts.damaged(oldWeightsName);
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

/// Mesh and labels of a cast.
Result<void> readSurface(const PartSource& parts, const std::string& name, CertifiedCast& cast) {
    Result<IndexedMesh> mesh = parts.part(name + ".mesh", &readMeshPart);
    if (!mesh)
        return std::unexpected(mesh.error());
    Result<SideLabels> labels = parts.part(name + ".labels", &readLabelsPart);
    if (!labels)
        return std::unexpected(labels.error());
    if (labels->size() != static_cast<std::size_t>(mesh->faceCount()))
        return parts.damaged(name + ".labels");
    cast.mesh = std::make_shared<const IndexedMesh>(*std::move(mesh));
    cast.labels = *std::move(labels);
    return {};
}

Result<std::shared_ptr<const CastResult>> readCast(const PartSource& parts, const std::string& prefix,
                                                   CastResult cast) {
    if (Result<void> done = readSurface(parts, prefix + "cast", cast); !done)
        return std::unexpected(done.error());
    if (const std::string name = prefix + "cast.before"; parts.has(name)) {
        const Result<std::vector<double>> before = parts.part(name, &readNumbersPart);
        if (!before)
            return std::unexpected(before.error());
        const Points& points = cast.mesh->V;
        if (static_cast<Eigen::Index>(before->size()) != points.size())
            return parts.damaged(name);
        cast.before = Eigen::Map<const Points>(before->data(), points.rows(), 3);
    }
    return std::make_shared<const CastResult>(std::move(cast));
}

Variant& variantOf(Project& project, std::size_t number) {
    return number == 0 ? project : project.others[number - 1];
}

/// The document's casts of further parts have a state only; each is read once.
Result<void> readFurtherCasts(const PartSource& parts, Project& project) {
    const std::vector<SharedCast> described = furtherCasts(project);
    for (std::size_t i = 0; i < described.size(); ++i) {
        CertifiedCast cast = *described[i];
        if (Result<void> done = readSurface(parts, furtherName(i), cast); !done)
            return done;
        if (cast.mesh->faceCount() == 0)
            return parts.damaged(furtherName(i) + ".mesh");
        const auto whole = std::make_shared<const CertifiedCast>(std::move(cast));
        for (std::size_t number = 0; number <= project.others.size(); ++number)
            for (TrayPart& part : variantOf(project, number).furtherParts)
                if (part.cast == described[i])
                    part.cast = whole;
    }
    return {};
}

Result<void> readRegions(const PartSource& parts, Project& project) {
    if (!project.part)
        return {};
    for (std::size_t number = 0; number <= project.others.size(); ++number) {
        Variant& variant = variantOf(project, number);
        for (std::size_t i = 0; i < variant.importance.size(); ++i)
            if (Result<void> done =
                    readRegion(parts, prefixOf(number), i, project.part->faceCount(), variant.importance[i]);
                !done)
                return done;
    }
    return {};
}

} // namespace

void addVariantParts(std::vector<ArchiveEntry>& entries, const Project& project) {
    addRegions(entries, project, prefixOf(0));
    if (project.cast)
        addCast(entries, *project.cast, prefixOf(0));
    for (std::size_t i = 0; i < project.others.size(); ++i) {
        const Variant& other = project.others[i];
        addRegions(entries, other, prefixOf(i + 1));
        if (other.cast && !sharedCast(project, i))
            addCast(entries, *other.cast, prefixOf(i + 1));
    }
    const std::vector<SharedCast> further = furtherCasts(project);
    for (std::size_t i = 0; i < further.size(); ++i)
        addSurface(entries, *further[i], furtherName(i));
}

Result<void> readVariantParts(const PartSource& parts, std::vector<DescribedCast> casts, Project& project) {
    const bool old = project.part && parts.has(oldWeightsName);
    if (Result<void> done = old ? readOldWeights(parts, project) : readRegions(parts, project); !done)
        return done;
    for (std::size_t number = 0; number < casts.size(); ++number) {
        auto& cast = variantOf(project, number).cast;
        if (casts[number].sameAs) {
            cast = variantOf(project, *casts[number].sameAs).cast;
        } else if (casts[number].own) {
            auto read = readCast(parts, prefixOf(number), *std::move(casts[number].own));
            if (!read)
                return std::unexpected(read.error());
            cast = *std::move(read);
        }
    }
    return readFurtherCasts(parts, project);
}

} // namespace moldwright
