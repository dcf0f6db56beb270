// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill.h"

#include "base/parallel.h"
#include "castability/topology.h"
#include "fill/field_repair.h"
#include "fill/field_tidy.h"
#include "fill/joined_halves.h"
#include "fill/leaned_field.h"
#include "fill/leaned_repair.h"
#include "fill/outermost_surface.h"
#include "fill/outlines.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace moldwright {

namespace {

/// How boldly details that filling makes are simplified: lengths in mean edges of the part.
struct Boldness {
    double tidying;  ///< see TidyGoal
    double flatness; ///< see TidyGoal
    double matching; ///< see matchOutlines()
    double step;     ///< heights at a point that differ by less become one, in grid steps
};

/// Round triangles first, caution where something then touches.
constexpr std::array kRungs = {Boldness{0.1, 0.01, 0.01, 16}, Boldness{0.1, 0.01, 1e-4, 16},
                               Boldness{0.1, 0.01, 0, 16},    Boldness{0.01, 0.001, 1e-4, 16},
                               Boldness{0, 0, 0, 16},         Boldness{0, 0, 0, 1024}};

/// Of the squared size: what an area seen from behind may be and still be rounding.
constexpr double kRounding = 1e-14;

constexpr double kAim = 0.6;    ///< degrees above the draft at which skirts lean
constexpr double kLimit = 0.25; ///< degrees above the draft from which nothing leans further
constexpr double kNear = 0.002; ///< mean edges: points of skirts that are nearer become one
constexpr double kApron = 20;   ///< times that: how far about a point in the plane that is lifted

double meanEdge(const IndexedMesh& mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            sum += (mesh.corner(f, k) - mesh.corner(f, (k + 1) % 3)).norm();
    return sum / (3 * mesh.faceCount());
}

HeightField leaning(const HeightField& field, const Eigen::Vector2d& run, double draftDegrees, double near) {
    const DraftCone limit(run, draftDegrees + kLimit);
    HeightField leaned = leanWalls(field, DraftCone(run, draftDegrees + kAim), limit, near);
    repairLeaned(leaned, limit, kApron * near);
    return leaned;
}

/// Of the body below a half, in cubed grid steps.
double volumeBelow(const HeightField& field) {
    double sum = 0;
    for (const auto f : field.mesh().faces())
        for (const auto h : field.mesh().fh_range(f))
            sum += field.area(f) * field.height(h) / 6;
    return sum;
}

struct FilledHalf {
    HeightField field;
    double skirtVolume = 0; ///< cubed grid steps
};

FilledHalf filledHalf(const ProjectedHalf& half, const Eigen::Vector2d& run, double edge,
                      const Boldness& boldness, std::optional<double> draftDegrees, const Task& task) {
    FilledHalf made{outermostSurface(half, boldness.step, task)};
    if (boldness.tidying > 0 && !task.stopped())
        tidy(made.field, {boldness.tidying * edge, boldness.flatness * edge});
    if (!task.stopped())
        makeManifold(made.field);
    if (!draftDegrees || task.stopped())
        return made;
    const double before = volumeBelow(made.field);
    made.field = leaning(made.field, run, *draftDegrees, kNear * edge);
    made.skirtVolume = volumeBelow(made.field) - before;
    return made;
}

/// Surface and volume of the skirts; nothing once the task is stopped.
FilledPart filled(const PartedMesh& part, const ShadowGrid& grid, const Boldness& boldness,
                  std::optional<double> draftDegrees, const Task& task) {
    const double edge = meanEdge(part.mesh) / grid.step();
    std::array<std::optional<FilledHalf>, 2> made;
    parallelFor(2, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int side = static_cast<int>(i) + 1;
            made[i] =
                filledHalf(projectHalf(part, side, grid), grid.run(side), edge, boldness, draftDegrees, task);
        }
    });
    if (task.stopped())
        return {};
    std::array<HeightField, 2> halves = {std::move(made[0]->field), std::move(made[1]->field)};
    if (boldness.matching > 0)
        matchOutlines(halves, boldness.matching * edge);
    FilledPart result;
    if (!task.stopped())
        result.surface = joinHalves(halves, grid);
    result.skirtVolume = (made[0]->skirtVolume + made[1]->skirtVolume) * std::pow(grid.step(), 3);
    return result;
}

/// Per point of the filled mesh the point of the part that stands there, −1 for none.
std::vector<int> pointsKept(const PartedMesh& part, const IndexedMesh& mesh, const ShadowGrid& grid) {
    std::map<std::array<double, 3>, int> pointAt;
    for (int f = 0; f < part.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            const int side = part.labels[static_cast<std::size_t>(f)];
            const Eigen::Vector3d x = part.mesh.corner(f, k);
            const Eigen::Vector3d placed = grid.place(grid.shadow(x, side), grid.height(x, side), side);
            pointAt.emplace(std::array{placed.x(), placed.y(), placed.z()}, part.mesh.F(f, k));
        }
    std::vector<int> source(static_cast<std::size_t>(mesh.vertexCount()), -1);
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (const auto at = pointAt.find({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)}); at != pointAt.end())
            source[static_cast<std::size_t>(v)] = at->second;
    return source;
}

/// Does every face look along its side's direction, or square to it?
bool looksOut(const PartedMesh& surface, const Directions& directions) {
    const double size = diagonal(surface.mesh);
    for (int f = 0; f < surface.mesh.faceCount(); ++f)
        if (const int side = surface.labels[static_cast<std::size_t>(f)];
            doubleAreaVector(surface.mesh, f).dot(directions.of(side)) < -kRounding * size * size)
            return false;
    return true;
}

bool sound(const PartedMesh& surface, const Directions& directions) {
    if (!looksOut(surface, directions))
        return false;
    const MeshDiagnosis found = diagnose(surface.mesh);
    return found.closed && found.manifold && found.oriented && found.degenerateFaces.empty() &&
           found.selfIntersections.empty() && topologyAllowsCasting(surface.mesh, surface.labels);
}

Result<FilledPart> fillBy(const PartedMesh& part, const Directions& directions,
                          std::optional<double> draftDegrees, const Task& task) {
    const ShadowGrid grid(part.mesh, directions);
    for (const Boldness& boldness : kRungs) {
        FilledPart result = filled(part, grid, boldness, draftDegrees, task);
        if (task.stopped())
            return failure(ErrorCode::Cancelled, MW_TEXT("fill", "Filling was cancelled."));
        if (!sound(result.surface, directions))
            continue;
        result.sourceVertex = pointsKept(part, result.surface.mesh, grid);
        result.volume = volume(result.surface.mesh) - volume(part.mesh) - result.skirtVolume;
        return result;
    }
    return failure(ErrorCode::Internal,
                   MW_TEXT("fill", "The undercuts could not be filled without the surface "
                                   "crossing itself. Move the parting plane a little."));
}

} // namespace

Result<FilledPart> fill(const PartedMesh& part, const Directions& directions, const Task& task) {
    return fillBy(part, directions, std::nullopt, task);
}

Result<FilledPart> fillWithDraft(const PartedMesh& part, const Directions& directions, double draftDegrees,
                                 const Task& task) {
    return fillBy(part, directions, draftDegrees, task);
}

} // namespace moldwright
