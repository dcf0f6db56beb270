// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/castable_shape.h"

#include "deformation/finish.h"
#include "deformation/labelled_problem.h"
#include "deformation/side_hinge.h"
#include "deformation/tet_topology.h"
#include "mesh/measures.h"

#include <cmath>

namespace moldwright {

namespace {

constexpr double kMembrane = 5;    ///< weight of the surface term, times the mean edge
constexpr double kVolume = 5;      ///< weight of each tetrahedron's change of volume: limbs turn, not shrink
constexpr double kAimHigher = 1;   ///< degrees above the required draft
constexpr double kSpare = 0.05;    ///< degrees that rounding may take from a part left as it is
constexpr double kFirstHinge = 1;  ///< κ of the first round
constexpr double kHingeGrowth = 3; ///< from round to round
constexpr int kRounds = 4;
constexpr int kIterations = 40;
constexpr double kBarrierShare = 0.01; ///< barrier weight over κ

double meanEdge(const IndexedMesh& mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            sum += (mesh.corner(f, k) - mesh.corner(f, (k + 1) % 3)).norm();
    return sum / (3.0 * mesh.faceCount());
}

/// Importance of each face of the solid: its source's; 1 where filling made it.
std::vector<double> solidFaceWeights(const PartedSolid& solid, const std::vector<double>& partWeights) {
    std::vector<double> weights;
    for (const int source : solid.surface.sourceFace)
        weights.push_back(source < 0 ? 1 : partWeights[static_cast<std::size_t>(source)]);
    return weights;
}

LabelledBody bodyOf(const PartedSolid& solid, const ShapeGoal& goal) {
    LabelledBody body;
    body.shape.V = solid.tets.V;
    body.shape.T = solid.tets.T;
    body.shape.F = solid.surface.mesh.F;
    if (!goal.faceWeights.empty())
        body.shape.tetWeights =
            tetWeights(solid.tets.T, solid.surface.mesh.F, solidFaceWeights(solid, goal.faceWeights));
    body.shape.membrane = kMembrane * meanEdge(solid.surface.mesh);
    body.shape.volumeStiffness = kVolume;
    body.labels = solid.surface.labels;
    body.directions = solid.frame.directionsToWork(solid.state.directions);
    body.held.assign(static_cast<std::size_t>(solid.tets.V.rows()), 0);
    for (int v = 0; v < solid.surface.mesh.vertexCount(); ++v)
        body.held[static_cast<std::size_t>(v)] = solid.surface.mesh.V(v, 2) == 0;
    return body;
}

LabelledSurface surfaceOf(const PartedSolid& solid, const Positions& X) {
    LabelledSurface surface{};
    const int points = solid.surface.mesh.vertexCount();
    surface.mesh = {Points(X.topRows(points)), solid.surface.mesh.F};
    surface.labels = solid.surface.labels;
    for (int v = 0; v < points; ++v)
        surface.sourceVertex.push_back(v);
    return surface;
}

/// A part that is castable as it is stays as it is.
bool passesAlready(const LabelledBody& body, double draftDegrees) {
    const double enough = std::sin(radians(draftDegrees + kSpare));
    return sideDraft(body.shape.F, body.labels, body.directions, body.shape.V, enough).violating == 0;
}

std::vector<double> restAreas(const IndexedMesh& mesh) {
    std::vector<double> areas;
    for (int f = 0; f < mesh.faceCount(); ++f)
        areas.push_back(doubleAreaVector(mesh, f).norm() / 2);
    return areas;
}

} // namespace

CastableShape bendToCastable(const PartedSolid& solid, const ShapeGoal& goal, const Task& task,
                             const ShapeWatch& watch) {
    const LabelledBody body = bodyOf(solid, goal);
    Positions X = body.shape.V;
    if (passesAlready(body, goal.draftDegrees))
        return {surfaceOf(solid, X), true, 0};
    LabelledProblem problem(body);
    const std::vector<double> areas = restAreas(solid.surface.mesh);
    StageWeights weights;
    weights.hinge = kFirstHinge;
    weights.tau = std::sin(radians(goal.draftDegrees + kAimHigher));
    weights.iterations = kIterations;
    const Task elastic = task.part(0, 0.8);
    bool enough = false;
    for (int round = 0; round < kRounds && !enough && !task.stopped();
         ++round, weights.hinge *= kHingeGrowth) {
        weights.barrier = kBarrierShare * weights.hinge;
        int step = 0;
        X = problem.minimize(weights, areas, std::move(X), [&](const Positions& Y) {
            elastic.progress((round + static_cast<double>(++step) / kIterations) / kRounds, "deformation");
            if (watch)
                watch("deformation", surfaceOf(solid, Y));
            enough = task.stopped() || (goal.finishNow && goal.finishNow());
            return !enough;
        });
    }
    CastableShape shape{surfaceOf(solid, X), false, problem.iterations()};
    const FinishGoal finish{body.directions, goal.draftDegrees, goal.resolution / solid.frame.scale(), 10};
    shape.reached =
        finishSurface(shape.surface, finish, task.part(0.8, 1), [&](const LabelledSurface& surface) {
            if (watch)
                watch("finish", surface);
        });
    return shape;
}

} // namespace moldwright
