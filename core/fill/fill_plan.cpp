// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill_plan.h"

#include "castability/topology.h"
#include "fill/caps.h"
#include "fill/necks.h"
#include "fill/needed_regions.h"
#include "fill/projected_half.h"
#include "fill/short_edges.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mesh/opposite_sides.h"
#include "mesh/union_find.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace moldwright {

namespace {

constexpr double kNothing = 1e-12;    ///< of the part's volume: regions that fill less only turn edges
constexpr double kShortest = 1e-4;    ///< of the size: of edges that dividing made, what stays
constexpr double kFlat = 1e-8;        ///< of the size: triangles less high are all but a line
constexpr double kDragged = 0.05;     ///< of what was chosen: how much more may be filled because it must
constexpr double kChosenAlone = 0.25; ///< of the size: how long a region may be that can be left

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

/// The region whose space a line along d from x enters first through the part; −1 where it meets none.
int regionAlong(const ChoiceMesh& choices, const Eigen::Vector3d& x, const Eigen::Vector3d& d) {
    double nearest = std::numeric_limits<double>::infinity();
    int region = -1;
    for (const ChoiceFace& face : choices.faces) {
        if (face.made >= 0)
            continue;
        const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
            return choices.points[static_cast<std::size_t>(face.corners[k])] - x;
        };
        const Eigen::Vector3d a = corner(0);
        const Eigen::Vector3d b = corner(1);
        const Eigen::Vector3d c = corner(2);
        const Eigen::Vector3d share(d.dot(b.cross(c)), d.dot(c.cross(a)), d.dot(a.cross(b)));
        if ((share.minCoeff() < 0 && share.maxCoeff() > 0) || share.sum() == 0)
            continue;
        const double t = (share[0] * a + share[1] * b + share[2] * c).dot(d) / share.sum();
        if (t > 0 && t < nearest) {
            nearest = t;
            region = face.covered;
        }
    }
    return region;
}

/// A solid that floats inside a region vanishes with it: its faces join that of what lies above it.
void joinIslands(ChoiceMesh& choices, const Directions& directions) {
    const std::vector<double> volumes = volumesOf(choices);
    std::vector<int> top(volumes.size(), -1);
    std::vector<char> island(volumes.size(), 1);
    for (const ChoiceFace& face : choices.faces)
        for (const int v : face.corners) {
            if (face.made >= 0)
                island[static_cast<std::size_t>(face.made)] = 0;
            if (face.covered < 0)
                continue;
            int& highest = top[static_cast<std::size_t>(face.covered)];
            if (highest < 0 || std::abs(choices.points[static_cast<std::size_t>(v)].z()) >
                                   std::abs(choices.points[static_cast<std::size_t>(highest)].z()))
                highest = v;
        }
    UnionFind groups(choices.regions);
    for (std::size_t r = 0; r < volumes.size(); ++r) {
        if (!island[r] || volumes[r] > 0 || top[r] < 0)
            continue;
        const Eigen::Vector3d x = choices.points[static_cast<std::size_t>(top[r])];
        if (const int above = regionAlong(choices, x, directions.of(x.z() >= 0 ? 1 : 2)); above >= 0)
            groups.unite(static_cast<int>(r), above);
    }
    std::vector<int> number;
    number.reserve(static_cast<std::size_t>(choices.regions));
    for (int r = 0; r < choices.regions; ++r)
        number.push_back(groups.rootOf(r));
    renumber(choices, number);
}

/// Whether the wall between two regions is on one side of the plane: else it would belong to both.
bool isOnOneSide(const Eigen::AlignedBox3d& wall) {
    const double tiny = kFlat * wall.diagonal().norm();
    return wall.min().z() >= -tiny || wall.max().z() <= tiny;
}

/// Whether a cut leaves two regions of which either can be filled alone: nothing crosses about the cut.
bool eachStandsAlone(const ChoiceMesh& choices, int region, int beyond) {
    const auto at = [&](int v) -> const Eigen::Vector3d& {
        return choices.points[static_cast<std::size_t>(v)];
    };
    Eigen::AlignedBox3d cut;
    for (const ChoiceFace& face : choices.faces)
        for (const int v : face.corners)
            if (face.made == region && face.covered == beyond)
                cut.extend(at(v));
    if (!isOnOneSide(cut))
        return false;
    for (const int alone : {region, beyond}) {
        std::vector<char> filled(static_cast<std::size_t>(choices.regions), 0);
        filled[static_cast<std::size_t>(alone)] = 1;
        std::vector<int> choiceOf;
        const IndexedMesh surface = surfaceWith(choices, filled, choiceOf).mesh;
        std::vector<int> near;
        for (int f = 0; f < surface.faceCount(); ++f) {
            Eigen::AlignedBox3d box;
            for (int k = 0; k < 3; ++k)
                box.extend(surface.corner(f, k));
            if (box.intersects(cut))
                near.push_back(f);
        }
        if (!selfIntersections({surface.V, surface.F(near, Eigen::all)}).empty())
            return false;
    }
    return true;
}

std::vector<FillRegion> describe(const ChoiceMesh& choices, const std::vector<char>& needed) {
    const std::vector<double> volumes = volumesOf(choices);
    std::vector<FillRegion> regions(volumes.size());
    std::vector<Eigen::AlignedBox3d> boxes(volumes.size());
    std::vector<Eigen::Vector4d> sums(volumes.size(), Eigen::Vector4d::Zero());
    std::vector<std::set<int>> sides(volumes.size());
    const auto at = [&](const ChoiceFace& face, std::size_t k) {
        return choices.points[static_cast<std::size_t>(face.corners[k])];
    };
    const auto middle = [&](const ChoiceFace& face) -> Eigen::Vector3d {
        return (at(face, 0) + at(face, 1) + at(face, 2)) / 3;
    };
    for (const ChoiceFace& face : choices.faces) {
        if (face.covered < 0 || face.made >= 0)
            continue;
        const auto r = static_cast<std::size_t>(face.covered);
        sides[r].insert(face.label);
        const double area = (at(face, 1) - at(face, 0)).cross(at(face, 2) - at(face, 0)).norm();
        sums[r] += area * middle(face).homogeneous();
        for (std::size_t k = 0; k < 3; ++k)
            boxes[r].extend(at(face, k));
    }
    std::vector<double> nearest(volumes.size(), std::numeric_limits<double>::infinity());
    for (const ChoiceFace& face : choices.faces) {
        if (face.covered < 0 || face.made >= 0)
            continue;
        const auto r = static_cast<std::size_t>(face.covered);
        if (const double distance = (middle(face) - sums[r].hnormalized()).norm(); distance < nearest[r]) {
            nearest[r] = distance;
            regions[r].place = middle(face);
        }
    }
    for (std::size_t r = 0; r < regions.size(); ++r) {
        regions[r].side = sides[r].size() == 1 ? *sides[r].begin() : 0;
        regions[r].size = boxes[r].isEmpty() ? 0 : boxes[r].diagonal().norm();
        regions[r].volume = volumes[r];
        regions[r].needed = needed[r] != 0;
    }
    return regions;
}

/// Drops points that no face uses; says where the kept ones come from.
void finish(const FillPlan& plan, FilledPart& result) {
    IndexedMesh& mesh = result.surface.mesh;
    std::vector<int> number(static_cast<std::size_t>(mesh.vertexCount()), -1);
    int count = 0;
    for (int& v : mesh.F.reshaped<Eigen::RowMajor>()) {
        int& known = number[static_cast<std::size_t>(v)];
        if (known < 0) {
            known = count++;
            result.sourceVertex.push_back(plan.choices.partPoint[static_cast<std::size_t>(v)]);
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

bool isSound(const IndexedMesh& mesh) {
    const MeshDiagnosis found = diagnose(mesh);
    return found.closed && found.manifold && found.oriented && found.degenerateFaces.empty() &&
           found.selfIntersections.empty();
}

/// The surface with the marked regions filled, if it is sound.
std::optional<FilledPart> soundWith(const FillPlan& plan, const std::vector<char>& filled) {
    FilledPart result;
    std::vector<int> choiceOf;
    result.surface = surfaceWith(plan.choices, filled, choiceOf);
    finish(plan, result);
    if (!closedManifold(result.surface.mesh.F, result.surface.mesh.vertexCount()))
        return std::nullopt;
    FilledPart rounder = result;
    collapseShortEdges(rounder, kShortest * diagonal(plan.part.mesh));
    flipCaps(rounder, kFlat * diagonal(plan.part.mesh));
    if (isSound(rounder.surface.mesh))
        return rounder;
    return isSound(result.surface.mesh) ? std::optional(result) : std::nullopt;
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
    plan.choices = choicesBetween(plan.part, plan.filled.surface);
    joinIslands(plan.choices, directions);
    const double nothing = kNothing * volume(part.mesh);
    numberByVolume(plan.choices, nothing);
    const std::vector<char> needed =
        neededRegions(plan.choices, directions, diagonal(part.mesh), nothing, task);
    plan.regions = describe(plan.choices, needed);
    if (task.stopped())
        return failure(ErrorCode::Cancelled, MW_TEXT("fill", "Filling was cancelled."));
    return plan;
}

FillPlan divided(FillPlan plan, const Directions& directions, const Task& task) {
    const double longest = kChosenAlone * diagonal(plan.part.mesh);
    std::vector<char> needed;
    for (std::size_t r = 0; r < plan.regions.size(); ++r) {
        needed.push_back(plan.regions[r].needed);
        if (!plan.regions[r].needed && plan.regions[r].size > longest)
            divideAtNecks(plan.choices, static_cast<int>(r), directions, longest, task, eachStandsAlone);
    }
    needed.resize(static_cast<std::size_t>(plan.choices.regions), 0);
    numberByVolume(plan.choices, needed, kNothing * volume(plan.part.mesh));
    plan.regions = describe(plan.choices, needed);
    return plan;
}

Result<FilledPart> fillChosen(const FillPlan& plan, const std::vector<int>& chosen) {
    std::vector<char> filled(plan.regions.size(), 0);
    double wanted = 0;
    for (const int region : chosen) {
        filled[static_cast<std::size_t>(region)] = 1;
        wanted += plan.regions[static_cast<std::size_t>(region)].volume;
    }
    if (std::optional<FilledPart> result = soundWith(plan, filled))
        return *result;
    double dragged = -wanted;
    const bool clear = dragAlong(plan.choices, filled);
    for (std::size_t r = 0; r < filled.size(); ++r)
        dragged += filled[r] ? plan.regions[r].volume : 0;
    if (clear && dragged <= kDragged * wanted)
        if (std::optional<FilledPart> result = soundWith(plan, filled))
            return *result;
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
