// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill_plan.h"

#include "castability/topology.h"
#include "fill/projected_half.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mesh/union_find.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <span>

namespace moldwright {

namespace {

constexpr double kNothing = 1e-12; ///< of the part's volume: patches that fill less only turn edges

PartedMesh onGrid(const PartedMesh& part, const ShadowGrid& grid) {
    PartedMesh placed = part;
    for (int f = 0; f < part.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            const int side = part.labels[static_cast<std::size_t>(f)];
            const Eigen::Vector3d x = part.mesh.corner(f, k);
            placed.mesh.V.row(part.mesh.F(f, k)) =
                grid.place(grid.shadow(x, side), grid.height(x, side), side).transpose();
        }
    return placed;
}

/// A patch's faces in the part (0) and in the filled part (1), and what they enclose.
struct Patch {
    std::array<std::vector<int>, 2> faces;
    double volume = 0;
};

double volumeOf(const MeshDifference& difference, std::size_t which, int f, const Eigen::Vector3d& origin) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
        return difference.points.row(difference.faces[which](f, k)).transpose() - origin;
    };
    return corner(0).dot(corner(1).cross(corner(2))) / 6;
}

std::vector<Patch> patchesOf(const MeshDifference& difference) {
    std::vector<Patch> patches(static_cast<std::size_t>(difference.patches));
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t f = 0; f < difference.patchOf[m].size(); ++f)
            if (const int patch = difference.patchOf[m][f]; patch >= 0)
                patches[static_cast<std::size_t>(patch)].faces[m].push_back(static_cast<int>(f));
    for (Patch& patch : patches) {
        const std::size_t any = patch.faces[0].empty() ? 1 : 0;
        if (patch.faces[any].empty())
            continue;
        const Eigen::Vector3d origin =
            difference.points.row(difference.faces[any](patch.faces[any].front(), 0)).transpose();
        for (const std::size_t m : {std::size_t{0}, std::size_t{1}})
            for (const int f : patch.faces[m])
                patch.volume += (m == 0 ? -1 : 1) * volumeOf(difference, m, f, origin);
    }
    return patches;
}

/// The patch of the part's face that a line along d from x meets first; −1 where it meets none.
int firstPatchAlong(const MeshDifference& difference, const Eigen::Vector3d& x, const Eigen::Vector3d& d) {
    double nearest = std::numeric_limits<double>::infinity();
    int patch = -1;
    for (Eigen::Index f = 0; f < difference.faces[0].rows(); ++f) {
        const Eigen::Vector3d a = difference.points.row(difference.faces[0](f, 0)).transpose() - x;
        const Eigen::Vector3d b = difference.points.row(difference.faces[0](f, 1)).transpose() - x;
        const Eigen::Vector3d c = difference.points.row(difference.faces[0](f, 2)).transpose() - x;
        const Eigen::Vector3d share(d.dot(b.cross(c)), d.dot(c.cross(a)), d.dot(a.cross(b)));
        if ((share.minCoeff() < 0 && share.maxCoeff() > 0) || share.sum() == 0)
            continue;
        const double t = (share[0] * a + share[1] * b + share[2] * c).dot(d) / share.sum();
        if (t > 0 && t < nearest) {
            nearest = t;
            patch = difference.patchOf[0][static_cast<std::size_t>(f)];
        }
    }
    return patch;
}

/// A solid that floats inside a region vanishes with it: its patch joins that of what lies above it.
void joinIslands(MeshDifference& difference, const Directions& directions) {
    const std::vector<Patch> patches = patchesOf(difference);
    UnionFind groups(difference.patches);
    for (std::size_t p = 0; p < patches.size(); ++p) {
        if (!patches[p].faces[1].empty() || patches[p].volume > 0)
            continue;
        Eigen::Vector3d top = Eigen::Vector3d::Zero();
        for (const int f : patches[p].faces[0])
            for (int k = 0; k < 3; ++k)
                if (const Eigen::Vector3d x = difference.points.row(difference.faces[0](f, k)).transpose();
                    std::abs(x.z()) > std::abs(top.z()))
                    top = x;
        const int above = firstPatchAlong(difference, top, directions.of(top.z() >= 0 ? 1 : 2));
        if (above >= 0)
            groups.unite(static_cast<int>(p), above);
    }
    for (auto& patchOf : difference.patchOf)
        for (int& patch : patchOf)
            if (patch >= 0)
                patch = groups.rootOf(patch);
}

/// Drops patches that fill nothing and numbers the rest by falling volume.
void numberByVolume(MeshDifference& difference, double nothing) {
    const std::vector<Patch> patches = patchesOf(difference);
    std::vector<int> order;
    for (std::size_t p = 0; p < patches.size(); ++p)
        if (patches[p].volume > nothing)
            order.push_back(static_cast<int>(p));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return patches[static_cast<std::size_t>(a)].volume > patches[static_cast<std::size_t>(b)].volume;
    });
    // What differs but fills nothing stays as the part has it: the last number, which no choice names.
    std::vector<int> number(patches.size(), static_cast<int>(order.size()));
    for (std::size_t i = 0; i < order.size(); ++i)
        number[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    for (auto& patchOf : difference.patchOf)
        for (int& patch : patchOf)
            if (patch >= 0)
                patch = number[static_cast<std::size_t>(patch)];
    difference.patches = static_cast<int>(order.size()) + 1;
}

FillRegion describe(const FillPlan& plan, const Patch& patch) {
    FillRegion region;
    region.volume = patch.volume;
    Eigen::AlignedBox3d box;
    std::set<int> sides;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0;
    const auto middle = [&](int f) -> Eigen::Vector3d {
        return (plan.part.mesh.corner(f, 0) + plan.part.mesh.corner(f, 1) + plan.part.mesh.corner(f, 2)) / 3;
    };
    for (const int f : patch.faces[0]) {
        sides.insert(plan.part.labels[static_cast<std::size_t>(f)]);
        const double weight = doubleAreaVector(plan.part.mesh, f).norm();
        sum += weight * middle(f);
        area += weight;
        for (int k = 0; k < 3; ++k)
            box.extend(plan.part.mesh.corner(f, k));
    }
    region.side = sides.size() == 1 ? *sides.begin() : 0;
    region.size = box.isEmpty() ? 0 : box.diagonal().norm();
    double nearest = std::numeric_limits<double>::infinity();
    for (const int f : patch.faces[0])
        if (const double distance = (middle(f) - sum / area).norm(); distance < nearest) {
            nearest = distance;
            region.place = middle(f);
        }
    return region;
}

/// The part with the regions filled that are marked.
FilledPart assembled(const FillPlan& plan, const std::vector<char>& marked) {
    const MeshDifference& difference = plan.difference;
    FilledPart result;
    result.surface.mesh.V = difference.points;
    std::vector<Eigen::RowVector3i> faces;
    const std::array<const PartedMesh*, 2> meshes = {&plan.part, &plan.filled.surface};
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t f = 0; f < difference.patchOf[m].size(); ++f) {
            const int patch = difference.patchOf[m][f];
            const bool filled = patch >= 0 && marked[static_cast<std::size_t>(patch)] != 0;
            if (patch < 0 ? m == 1 : filled != (m == 1))
                continue;
            faces.emplace_back(difference.faces[m].row(static_cast<Eigen::Index>(f)));
            result.surface.labels.push_back(meshes[m]->labels[f]);
            result.surface.sourceFace.push_back(m == 0 ? static_cast<int>(f) : meshes[m]->sourceFace[f]);
        }
    result.surface.mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f)
        result.surface.mesh.F.row(static_cast<Eigen::Index>(f)) = faces[f];
    return result;
}

/// Leaves out as many regions as it can: all of them at once, else the first half, then the second.
void leaveOut(const FillPlan& plan, std::span<const int> regions, std::vector<char>& marked,
              const Task& task) {
    if (regions.empty() || task.stopped())
        return;
    for (const int region : regions)
        marked[static_cast<std::size_t>(region)] = 0;
    const FilledPart without = assembled(plan, marked);
    if (topologyAllowsCasting(without.surface.mesh, without.surface.labels))
        return;
    for (const int region : regions)
        marked[static_cast<std::size_t>(region)] = 1;
    if (regions.size() == 1)
        return;
    leaveOut(plan, regions.first(regions.size() / 2), marked, task);
    leaveOut(plan, regions.subspan(regions.size() / 2), marked, task);
}

void markNeeded(FillPlan& plan, const Task& task) {
    std::vector<char> marked(static_cast<std::size_t>(plan.difference.patches), 1);
    marked.back() = 0;
    std::vector<int> all(plan.regions.size());
    std::iota(all.begin(), all.end(), 0);
    leaveOut(plan, all, marked, task);
    for (std::size_t r = 0; r < plan.regions.size(); ++r)
        plan.regions[r].needed = marked[r] != 0;
}

/// Drops points that no face uses; says where the kept ones come from.
void finish(const FillPlan& plan, FilledPart& result) {
    IndexedMesh& mesh = result.surface.mesh;
    std::vector<int> number(static_cast<std::size_t>(mesh.vertexCount()), -1);
    std::vector<int> source(number.size(), -1);
    for (int f = 0; f < plan.part.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            source[static_cast<std::size_t>(plan.difference.faces[0](f, k))] = plan.part.mesh.F(f, k);
    int count = 0;
    for (int& v : mesh.F.reshaped<Eigen::RowMajor>()) {
        int& known = number[static_cast<std::size_t>(v)];
        if (known < 0) {
            known = count++;
            result.sourceVertex.push_back(source[static_cast<std::size_t>(v)]);
        }
        v = known;
    }
    Points kept(count, 3);
    for (std::size_t v = 0; v < number.size(); ++v)
        if (number[v] >= 0)
            kept.row(number[v]) = mesh.V.row(static_cast<Eigen::Index>(v));
    mesh.V = std::move(kept);
    result.volume = volume(mesh) - volume(plan.part.mesh);
}

} // namespace

std::vector<int> FillPlan::needed() const {
    std::vector<int> found;
    for (std::size_t r = 0; r < regions.size(); ++r)
        if (regions[r].needed)
            found.push_back(static_cast<int>(r));
    return found;
}

Result<FillPlan> planFill(const PartedMesh& part, const Directions& directions, const Task& task) {
    Result<FilledPart> filled = fill(part, directions, task);
    if (!filled)
        return std::unexpected(filled.error());
    FillPlan plan;
    plan.part = onGrid(part, ShadowGrid(part.mesh, directions));
    plan.filled = std::move(*filled);
    plan.difference = meshDifference(plan.part, plan.filled.surface);
    joinIslands(plan.difference, directions);
    numberByVolume(plan.difference, kNothing * volume(part.mesh));
    std::vector<Patch> patches = patchesOf(plan.difference);
    patches.pop_back();
    plan.regions.reserve(patches.size());
    for (const Patch& patch : patches)
        plan.regions.push_back(describe(plan, patch));
    markNeeded(plan, task);
    if (task.stopped())
        return failure(ErrorCode::Cancelled, MW_TEXT("fill", "Filling was cancelled."));
    return plan;
}

Result<FilledPart> fillChosen(const FillPlan& plan, const std::vector<int>& chosen) {
    std::vector<char> marked(static_cast<std::size_t>(plan.difference.patches), 0);
    for (const int region : chosen)
        marked[static_cast<std::size_t>(region)] = 1;
    FilledPart result = assembled(plan, marked);
    finish(plan, result);
    const MeshDiagnosis found = diagnose(result.surface.mesh);
    if (found.closed && found.manifold && found.oriented && found.degenerateFaces.empty() &&
        found.selfIntersections.empty())
        return result;
    return failure(ErrorCode::Internal,
                   MW_TEXT("fill", "These regions cannot be filled alone: the surface would "
                                   "cross itself. Fill the regions beside them too."));
}

Result<FilledPart> minimalFill(const FillPlan& plan) {
    Result<FilledPart> result = fillChosen(plan, plan.needed());
    if (result && topologyAllowsCasting(result->surface.mesh, result->surface.labels))
        return result;
    return plan.filled;
}

} // namespace moldwright
