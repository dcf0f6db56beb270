// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/finish.h"

#include "castability/parting_line.h"
#include "deformation/labelled_problem.h"
#include "deformation/side_hinge.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kAimHigher = 1.0;  ///< degrees above the required draft
constexpr double kEnough = 0.2;     ///< degrees above the required draft that end the finish
constexpr double kAreaFloor = 0.01; ///< of the mean face area: slivers must count too
constexpr int kIterations = 100;
constexpr std::size_t kStalledRounds = 3; ///< without fewer violations: what is left is stuck
constexpr double kThinInSteps =
    400; ///< rounding steps below which a face is too thin to keep its draft in floats

LabelledBody shellOf(const LabelledSurface& surface, const Directions& directions) {
    LabelledBody body;
    body.shape.V = surface.mesh.V;
    body.shape.F = surface.mesh.F;
    body.shape.membrane = 1;
    body.labels = surface.labels;
    body.directions = directions;
    body.held.assign(static_cast<std::size_t>(surface.mesh.vertexCount()), 0);
    for (const auto& [a, b] : partingEdges(surface.mesh, surface.labels))
        body.held[static_cast<std::size_t>(a)] = body.held[static_cast<std::size_t>(b)] = 1;
    // A face that was laid in the plane (a flat back) stays there.
    for (int v = 0; v < surface.mesh.vertexCount(); ++v)
        if (surface.mesh.V(v, 2) == 0)
            body.held[static_cast<std::size_t>(v)] = 1;
    return body;
}

std::vector<double> flooredAreas(const IndexedMesh& mesh) {
    const double floor = kAreaFloor * surfaceArea(mesh) / mesh.faceCount();
    std::vector<double> areas;
    for (int f = 0; f < mesh.faceCount(); ++f)
        areas.push_back(std::max(doubleAreaVector(mesh, f).norm() / 2, floor));
    return areas;
}

int violations(const LabelledSurface& surface, const Directions& directions, double draftDegrees) {
    return sideDraft(surface.mesh.F, surface.labels, directions, surface.mesh.V,
                     std::sin(radians(draftDegrees)))
        .violating;
}

} // namespace

bool finishSurface(LabelledSurface& surface, const FinishGoal& goal, const Task& task,
                   const std::function<void(const LabelledSurface&)>& watch) {
    StageWeights weights;
    weights.elastic = 1e-3;
    weights.hinge = 1;
    weights.tau = std::sin(radians(goal.draftDegrees + kAimHigher));
    weights.barrier = 0.01;
    weights.iterations = kIterations;
    weights.relativeDecrease = 1e-9;
    const double enough = std::sin(radians(goal.draftDegrees + kEnough));
    CleanUpGoal mending{goal.directions, enough, kThinInSteps * goal.resolution,
                        kThinInSteps * goal.resolution};
    cleanUp(surface, mending);
    std::vector<int> history;
    for (int round = 0; round < goal.rounds && !task.stopped(); ++round) {
        if (violations(surface, goal.directions, goal.draftDegrees + kEnough) == 0)
            return true;
        task.progress(static_cast<double>(round) / goal.rounds, "finish");
        LabelledProblem problem(shellOf(surface, goal.directions));
        const Positions X =
            problem.minimize(weights, flooredAreas(surface.mesh), surface.mesh.V, [&](const Positions& Y) {
                return !task.stopped() &&
                       sideDraft(surface.mesh.F, surface.labels, goal.directions, Y, enough).violating > 0;
            });
        surface.mesh.V = X;
        cleanUp(surface, mending);
        weights.elastic = std::max(weights.elastic * 0.1, 1e-8);
        weights.barrier = std::max(weights.barrier * 0.3, 1e-4);
        if (watch)
            watch(surface);
        history.push_back(violations(surface, goal.directions, goal.draftDegrees));
        if (history.size() > kStalledRounds && history.back() >= history[history.size() - 1 - kStalledRounds])
            break;
    }
    return violations(surface, goal.directions, goal.draftDegrees) == 0;
}

} // namespace moldwright
