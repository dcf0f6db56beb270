// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/repair_mesh.h"

#include "exchange/wire.h"
#include "exchange/worker_client.h"
#include "mesh/check.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"
#include "mesh/nesting.h"

#include <algorithm>
#include <array>
#include <utility>

namespace moldwright {

namespace {

constexpr double kSkinOffset = 1.0 / 1200; ///< of the diagonal
constexpr double kSkinAlpha = 1.0 / 120;   ///< of the diagonal: narrower gaps are bridged
constexpr double kFar = 0.01;      ///< of the diagonal: faces farther from the mended surface are lost
constexpr double kMostLost = 0.02; ///< of the area: where mending loses more, it has spoilt the surface
constexpr double kSheet =
    1.75; ///< times the area before: where filling adds so much there was a sheet, no solid
constexpr double kHollow = 3; ///< times area × offset, of volume: less is a skin about a sheet, no solid

WorkerLimits limitsFor(const IndexedMesh& mesh) {
    return {.megabytes = 3072 + mesh.faceCount() / 64, .seconds = 120 + mesh.faceCount() / 500};
}

Message told(std::string text, std::vector<std::string> arguments) {
    return {std::move(text), std::move(arguments)};
}

WireWriter requestFor(const IndexedMesh& mesh) {
    WireWriter request;
    request.matrix(mesh.V);
    request.matrix(mesh.F);
    return request;
}

Result<IndexedMesh> meshIn(WireReader& reader) {
    IndexedMesh mesh;
    mesh.V = reader.matrix<Points>();
    mesh.F = reader.matrix<Triangles>();
    const bool fits = mesh.F.size() > 0 && mesh.F.minCoeff() >= 0 && mesh.F.maxCoeff() < mesh.vertexCount();
    if (!reader.whole() || !fits || !mesh.V.allFinite())
        return failure(ErrorCode::Worker, MW_TEXT("exchange", "The worker program's answer is incomplete."));
    return mesh;
}

std::unexpected<Error> enclosesNothing(const std::string& name) {
    return failure(ErrorCode::BadInput,
                   MW_TEXT("exchange", "{0} cannot be repaired: its surface encloses nothing."), {name});
}

/// The share of a surface's area that is not there any more.
double shareLost(const IndexedMesh& before, const IndexedMesh& after) {
    const ClosestPoint surface(after);
    const double far = kFar * diagonal(before);
    double lost = 0;
    for (int f = 0; f < before.faceCount(); ++f) {
        const Eigen::Vector3d middle = (before.corner(f, 0) + before.corner(f, 1) + before.corner(f, 2)) / 3;
        if (surface.distance(middle) > far)
            lost += doubleAreaVector(before, f).norm() / 2;
    }
    return lost / surfaceArea(before);
}

Result<RepairedMesh> mended(const IndexedMesh& mesh, const std::string& name, const Task& task) {
    const Result<std::string> answer =
        askWorker(WorkerJob::Mend, requestFor(mesh).bytes(), limitsFor(mesh), task);
    if (!answer)
        return std::unexpected(answer.error());
    WireReader reader(*answer);
    Result<IndexedMesh> surface = meshIn(reader);
    if (!surface)
        return std::unexpected(surface.error());
    std::array<std::int64_t, 4> counts{};
    for (std::int64_t& count : counts)
        count = reader.number();
    const auto [removed, holes, made, crossings] = counts;
    const auto largest = reader.matrix<Eigen::Matrix<double, Eigen::Dynamic, 1>>();
    if (!reader.whole() || largest.size() != 1)
        return failure(ErrorCode::Worker, MW_TEXT("exchange", "The worker program's answer is incomplete."));
    if (surfaceArea(*surface) > kSheet * surfaceArea(mesh))
        return enclosesNothing(name);
    if (shareLost(mesh, *surface) > kMostLost)
        return failure(ErrorCode::BadInput,
                       MW_TEXT("exchange", "{0} cannot be mended: too much of its surface would be lost."),
                       {name});
    RepairedMesh repaired{*std::move(surface), {}, 0};
    if (removed > 0)
        repaired.repairs.push_back(
            told(MW_TEXT("exchange", "{0} faces were removed: repeated, without area, or loose scraps."),
                 {std::to_string(removed)}));
    if (holes > 0)
        repaired.repairs.push_back(
            told(MW_TEXT("exchange", "{0} holes were filled with {1} faces; the largest is {2} wide."),
                 {std::to_string(holes), std::to_string(made), readable(largest[0])}));
    if (crossings > 0)
        repaired.repairs.push_back(told(
            MW_TEXT("exchange", "The surface was made anew about {0} places where faces crossed each other."),
            {std::to_string(crossings)}));
    return repaired;
}

Result<RepairedMesh> wrapped(const IndexedMesh& mesh, const std::string& name, const Task& task) {
    const double size = diagonal(mesh);
    const double offset = kSkinOffset * size;
    WireWriter request = requestFor(mesh);
    request.matrix(Eigen::Matrix<double, 2, 1>(kSkinAlpha * size, offset));
    const Result<std::string> answer = askWorker(WorkerJob::Wrap, request.bytes(), limitsFor(mesh), task);
    if (!answer)
        return std::unexpected(answer.error());
    WireReader reader(*answer);
    Result<IndexedMesh> skin = meshIn(reader);
    if (!skin)
        return std::unexpected(skin.error());
    if (volume(*skin) < kHollow * surfaceArea(mesh) * offset)
        return enclosesNothing(name);
    return RepairedMesh{
        *std::move(skin),
        {told(MW_TEXT("exchange", "The faults were too many to mend: a closed skin was made about "
                                  "the surface, no farther than {0} from it. Gaps narrower than "
                                  "{1} are bridged, sharp edges rounded."),
              {readable(2 * offset, 2), readable(kSkinAlpha * size, 2)})},
        2 * offset};
}

/// Without the components that lie inside others; a mold cannot reach those.
void dropInner(RepairedMesh& repaired) {
    const Components components = connectedComponents(repaired.mesh);
    const std::vector<int> inside = componentsInsideOthers(repaired.mesh, components);
    if (inside.empty())
        return;
    std::vector<int> kept;
    for (int f = 0; f < repaired.mesh.faceCount(); ++f)
        if (!std::ranges::binary_search(inside, components.ofFace[static_cast<std::size_t>(f)]))
            kept.push_back(f);
    repaired.mesh.F = repaired.mesh.F(kept, Eigen::all).eval();
    repaired.repairs.push_back(
        told(MW_TEXT("exchange", "{0} closed surfaces inside others were removed: they are solid now."),
             {std::to_string(inside.size())}));
}

/// As it is found to be usable; else the gravest fault.
Result<RepairedMesh> ifUsable(RepairedMesh repaired, const std::string& name) {
    Examination found = examine(repaired.mesh, name);
    if (found.diagnosis.nested > 0) {
        dropInner(repaired);
        found = examine(repaired.mesh, name);
    }
    if (!found.faults.empty())
        return std::unexpected(found.faults.front());
    repaired.mesh = std::move(found.mesh);
    repaired.repairs.insert(repaired.repairs.end(), found.repairs.begin(), found.repairs.end());
    return repaired;
}

} // namespace

Result<RepairedMesh> repairMesh(const IndexedMesh& mesh, const std::string& name, const Task& task) {
    Examination found = examine(mesh, name);
    RepairedMesh given{std::move(found.mesh), std::move(found.repairs), 0};
    if (found.faults.empty())
        return given;
    if (found.diagnosis.nested > 0)
        return ifUsable(std::move(given), name);
    const auto use = [&](Result<RepairedMesh> repaired) -> Result<RepairedMesh> {
        if (!repaired)
            return repaired;
        repaired->repairs.insert(repaired->repairs.begin(), given.repairs.begin(), given.repairs.end());
        return ifUsable(*std::move(repaired), name);
    };
    task.progress(0.1, "Mending");
    if (Result<RepairedMesh> repaired = use(mended(given.mesh, name, task)); repaired || task.stopped())
        return repaired;
    task.progress(0.5, "Wrapping");
    Result<RepairedMesh> skin = use(wrapped(given.mesh, name, task));
    // Where CGAL itself failed, the mesh's own fault says more.
    if (!skin && skin.error().code == ErrorCode::Worker)
        return std::unexpected(found.faults.front());
    return skin;
}

} // namespace moldwright
