// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill_plan.h"

#include "castability/topology.h"
#include "fill/caps.h"
#include "fill/necks.h"
#include "fill/projected_half.h"
#include "fill/short_edges.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mesh/opposite_sides.h"
#include "mesh/union_find.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <utility>

namespace moldwright {

namespace {

constexpr int kDragRounds = 8;              ///< in which regions are added that others drag along
constexpr double kNothing = 1e-12;          ///< of the part's volume: regions that fill less only turn edges
constexpr double kShortest = 1e-4;          ///< of the size: of edges that dividing made, what stays
constexpr double kFlat = 1e-8;              ///< of the size: triangles less high are all but a line
constexpr std::array kLongest = {0.2, 0.4}; ///< of the size: how long a region may be that is needed

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

/// Leaves what fills nothing as the part has it; numbers the rest by falling volume. Returns the new numbers.
std::vector<int> numberByVolume(ChoiceMesh& choices, double nothing) {
    const std::vector<double> volumes = volumesOf(choices);
    std::vector<int> order;
    for (std::size_t r = 0; r < volumes.size(); ++r)
        if (volumes[r] > nothing)
            order.push_back(static_cast<int>(r));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return volumes[static_cast<std::size_t>(a)] > volumes[static_cast<std::size_t>(b)];
    });
    std::vector<int> number(volumes.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i)
        number[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    renumber(choices, number);
    return number;
}

bool castable(const ChoiceMesh& choices, const std::vector<char>& filled) {
    std::vector<int> choiceOf;
    const PartedMesh surface = surfaceWith(choices, filled, choiceOf);
    return topologyAllowsCasting(surface.mesh, surface.labels) &&
           closedManifold(surface.mesh.F, surface.mesh.vertexCount());
}

/// Leaves out as many regions as it can: all of them at once, else the first half, then the second.
void leaveOut(const ChoiceMesh& choices, std::span<const int> regions, std::vector<char>& filled,
              const Task& task) {
    if (regions.empty() || task.stopped())
        return;
    for (const int region : regions)
        filled[static_cast<std::size_t>(region)] = 0;
    if (castable(choices, filled))
        return;
    for (const int region : regions)
        filled[static_cast<std::size_t>(region)] = 1;
    if (regions.size() == 1)
        return;
    leaveOut(choices, regions.first(regions.size() / 2), filled, task);
    leaveOut(choices, regions.subspan(regions.size() / 2), filled, task);
}

/// Of the regions filled, the largest are left out first.
void leaveOutWhatCanBe(const ChoiceMesh& choices, std::vector<char>& filled, const Task& task) {
    std::vector<int> regions;
    for (std::size_t r = 0; r < filled.size(); ++r)
        if (filled[r])
            regions.push_back(static_cast<int>(r));
    leaveOut(choices, regions, filled, task);
    // What one left out made superfluous: once more, one by one.
    for (const int region : regions)
        if (filled[static_cast<std::size_t>(region)])
            leaveOut(choices, std::span(&region, 1), filled, task);
}

/// Where a surface that was to stay is crossed by one that filling makes, by the hair that tidying takes, its
/// region is filled as well. Returns whether nothing crosses in the end.
bool dragAlong(const ChoiceMesh& choices, std::vector<char>& filled, const Task& task) {
    for (int round = 0; round < kDragRounds && !task.stopped(); ++round) {
        std::vector<int> choiceOf;
        const auto crossings = selfIntersections(surfaceWith(choices, filled, choiceOf).mesh);
        if (crossings.empty())
            return true;
        for (const auto& [f, g] : crossings)
            for (const int face : {f, g}) {
                const int choice = choiceOf[static_cast<std::size_t>(face)];
                if (const int region = choices.faces[static_cast<std::size_t>(choice)].covered; region >= 0)
                    filled[static_cast<std::size_t>(region)] = 1;
            }
    }
    return false;
}

/// Regions that hang together become one where they are alike: all needed, or none.
void joinAlike(ChoiceMesh& choices, std::vector<char>& needed) {
    UnionFind groups(choices.regions);
    for (const ChoiceFace& face : choices.faces)
        if (face.made >= 0 && face.covered >= 0 &&
            needed[static_cast<std::size_t>(face.made)] == needed[static_cast<std::size_t>(face.covered)])
            groups.unite(face.made, face.covered);
    std::vector<int> number;
    number.reserve(static_cast<std::size_t>(choices.regions));
    for (int r = 0; r < choices.regions; ++r)
        number.push_back(groups.rootOf(r));
    renumber(choices, number);
    std::erase_if(choices.faces,
                  [](const ChoiceFace& face) { return face.made >= 0 && face.made == face.covered; });
}

/// Numbers regions by volume and keeps what is known of them.
void numberByVolume(ChoiceMesh& choices, std::vector<char>& needed, double nothing) {
    const std::vector<int> number = numberByVolume(choices, nothing);
    std::vector<char> known(static_cast<std::size_t>(choices.regions), 0);
    for (std::size_t r = 0; r < number.size(); ++r)
        if (number[r] >= 0)
            known[static_cast<std::size_t>(number[r])] = needed[r];
    needed = std::move(known);
}

/// Divides those of the regions that are marked at their necks and leaves out what can be of them. Returns
/// whether what is left is a sound surface.
bool divideAndLeaveOut(ChoiceMesh& choices, std::vector<char>& marked, const Directions& directions,
                       double longest, double nothing, const Task& task) {
    const int undivided = choices.regions;
    for (int r = 0; r < undivided && !task.stopped(); ++r)
        if (marked[static_cast<std::size_t>(r)])
            divideAtNecks(choices, r, directions, longest, task);
    marked.resize(static_cast<std::size_t>(choices.regions), 1);
    numberByVolume(choices, marked, nothing);
    leaveOutWhatCanBe(choices, marked, task);
    if (task.stopped() || !dragAlong(choices, marked, task) || !castable(choices, marked))
        return false;
    joinAlike(choices, marked);
    numberByVolume(choices, marked, nothing);
    return true;
}

/// Which regions the certificate asks for: first as they hang together, then those divided.
std::vector<char> findNeeded(ChoiceMesh& choices, const Directions& directions, double size, double nothing,
                             const Task& task) {
    std::vector<char> whole(static_cast<std::size_t>(choices.regions), 1);
    leaveOutWhatCanBe(choices, whole, task);
    if (std::ranges::count(whole, 1) == 0)
        return whole;
    for (const double longest : kLongest) {
        ChoiceMesh divided = choices;
        std::vector<char> needed = whole;
        if (!divideAndLeaveOut(divided, needed, directions, longest * size, nothing, task))
            continue;
        choices = std::move(divided);
        return needed;
    }
    return whole;
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
    const std::vector<char> needed = findNeeded(plan.choices, directions, diagonal(part.mesh), nothing, task);
    plan.regions = describe(plan.choices, needed);
    if (task.stopped())
        return failure(ErrorCode::Cancelled, MW_TEXT("fill", "Filling was cancelled."));
    return plan;
}

Result<FilledPart> fillChosen(const FillPlan& plan, const std::vector<int>& chosen) {
    std::vector<char> filled(plan.regions.size(), 0);
    for (const int region : chosen)
        filled[static_cast<std::size_t>(region)] = 1;
    FilledPart result;
    std::vector<int> choiceOf;
    result.surface = surfaceWith(plan.choices, filled, choiceOf);
    finish(plan, result);
    if (closedManifold(result.surface.mesh.F, result.surface.mesh.vertexCount())) {
        FilledPart rounder = result;
        collapseShortEdges(rounder, kShortest * diagonal(plan.part.mesh));
        flipCaps(rounder, kFlat * diagonal(plan.part.mesh));
        if (isSound(rounder.surface.mesh))
            return rounder;
        if (isSound(result.surface.mesh))
            return result;
    }
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
