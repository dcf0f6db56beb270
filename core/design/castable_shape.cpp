// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/castable_shape.h"

#include "deformation/finish.h"
#include "deformation/labelled_problem.h"
#include "deformation/side_hinge.h"
#include "deformation/tet_topology.h"
#include "exchange/tetrahedralize.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
constexpr double kRoughly = 1e-2; ///< relative decrease that ends a round before the last: see StageWeights
constexpr double kBarrierShare = 0.01; ///< barrier weight over κ

double meanEdge(const IndexedMesh& mesh) {
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            sum += (mesh.corner(f, k) - mesh.corner(f, (k + 1) % 3)).norm();
    return sum / (3.0 * mesh.faceCount());
}

/// The points of the tetrahedra that pins inside hold.
std::vector<int> pinnedInside(const PartedSolid& solid) {
    return innerPoints(solid.tets, solid.surface.mesh.vertexCount(), innerPlaces(solid.pins));
}

LabelledBody bodyOf(const PartedSolid& solid, const ShapeGoal& goal) {
    LabelledBody body;
    body.shape.V = solid.tets.V;
    body.shape.T = solid.tets.T;
    body.shape.F = solid.surface.mesh.F;
    if (!goal.faceWeights.empty()) {
        body.shape.faceWeights = importanceOfFaces(solid, goal.faceWeights);
        body.shape.tetWeights = tetWeights(solid.tets.T, solid.surface.mesh.F, body.shape.faceWeights);
    }
    body.shape.membrane = kMembrane * meanEdge(solid.surface.mesh);
    body.shape.volumeStiffness = kVolume;
    body.labels = solid.surface.labels;
    body.directions = solid.frame.directionsToWork(goal.directions);
    body.held.assign(static_cast<std::size_t>(solid.tets.V.rows()), 0);
    for (int v = 0; v < solid.surface.mesh.vertexCount(); ++v)
        body.held[static_cast<std::size_t>(v)] = solid.surface.mesh.V(v, 2) == 0;
    for (const int v : pinnedInside(solid))
        body.held[static_cast<std::size_t>(v)] = 1;
    return body;
}

/// The pins of a solid whose points are at X.
std::vector<PlacedPin> pinsAt(const PartedSolid& solid, const Positions& X) {
    std::vector<PlacedPin> pins = solid.pins;
    const std::vector<int> inside = pinnedInside(solid);
    std::size_t next = 0;
    for (PlacedPin& pin : pins)
        if (pin.surfacePoint < 0)
            pin.place = X.row(inside[next++]).transpose();
    return pins;
}

std::vector<double> restAreas(const IndexedMesh& mesh) {
    std::vector<double> areas;
    areas.reserve(static_cast<std::size_t>(mesh.faceCount()));
    for (int f = 0; f < mesh.faceCount(); ++f)
        areas.push_back(doubleAreaVector(mesh, f).norm() / 2);
    return areas;
}

LabelledSurface surfaceOf(const PartedSolid& solid, const Positions& X) {
    return surfaceAt(solid, X.topRows(solid.surface.mesh.vertexCount()));
}

} // namespace

LabelledSurface surfaceAt(const PartedPart& part, const Points& X) {
    LabelledSurface surface{{X, part.surface.mesh.F}, part.surface.labels, {}};
    surface.sourceVertex.resize(static_cast<std::size_t>(X.rows()));
    std::iota(surface.sourceVertex.begin(), surface.sourceVertex.end(), 0);
    return surface;
}

std::vector<double> importanceOfFaces(const PartedPart& part, const std::vector<double>& faceWeights) {
    std::vector<double> weights;
    if (faceWeights.empty())
        return weights;
    weights.reserve(part.surface.sourceFace.size());
    for (const int source : part.surface.sourceFace)
        weights.push_back(source < 0 ? 1 : faceWeights[static_cast<std::size_t>(source)]);
    return weights;
}

std::vector<double> importanceOfPoints(const PartedPart& part, const std::vector<double>& faceWeights) {
    const std::vector<double> ofFaces = importanceOfFaces(part, faceWeights);
    std::vector<double> weights(
        ofFaces.empty() ? 0 : static_cast<std::size_t>(part.surface.mesh.vertexCount()), 0.0);
    for (std::size_t f = 0; f < ofFaces.size(); ++f)
        for (const int v : part.surface.mesh.F.row(static_cast<Eigen::Index>(f)))
            weights[static_cast<std::size_t>(v)] = std::max(weights[static_cast<std::size_t>(v)], ofFaces[f]);
    return weights;
}

bool passesAlready(const PartedPart& part, double draftDegrees) {
    const double enough = std::sin(radians(draftDegrees + kSpare));
    const Directions directions = part.frame.directionsToWork(part.state.directions);
    const PartedMesh& surface = part.surface;
    return sideDraft(surface.mesh.F, surface.labels, directions, surface.mesh.V, enough).violating == 0;
}

BentShape bend(const PartedSolid& solid, const ShapeGoal& goal, const Task& task, const ShapeWatch& watch,
               const BentShape* from) {
    LabelledProblem problem(bodyOf(solid, goal));
    Positions X = from ? from->points : solid.tets.V;
    const std::vector<double> areas = restAreas(solid.surface.mesh);
    StageWeights weights;
    weights.tau = std::sin(radians(goal.draftDegrees + kAimHigher));
    weights.iterations = kIterations;
    const int first = from ? from->round : 0;
    int round = first;
    for (bool enough = false; round < kRounds && !enough && !task.stopped(); ++round) {
        weights.hinge = kFirstHinge * std::pow(kHingeGrowth, round);
        weights.barrier = kBarrierShare * weights.hinge;
        const bool roughly = !goal.thorough && round + 1 < kRounds;
        weights.relativeDecrease = roughly ? kRoughly : StageWeights{}.relativeDecrease;
        if (goal.follow && round > first)
            problem.setDirections(solid.frame.directionsToWork(goal.follow(surfaceOf(solid, X))));
        int step = 0;
        X = problem.minimize(weights, areas, std::move(X), [&](const Positions& Y) {
            task.progress((round + static_cast<double>(++step) / kIterations) / kRounds, "deformation");
            if (watch)
                watch("deformation", surfaceOf(solid, Y));
            enough = task.stopped() || (goal.enough && goal.enough());
            return !enough;
        });
        if (enough)
            break; // gone on with, it repeats this round
    }
    const int iterations = problem.iterations() + (from ? from->iterations : 0);
    return {surfaceOf(solid, X), iterations, false, pinsAt(solid, X), X, round};
}

bool finish(BentShape& bent, const PartedPart& part, const ShapeGoal& goal, double resolution,
            const Task& task, const ShapeWatch& watch) {
    FinishGoal wanted;
    wanted.directions = part.frame.directionsToWork(part.state.directions);
    wanted.draftDegrees = goal.draftDegrees;
    wanted.resolution = resolution / part.frame.scale();
    wanted.keepDetail = bent.followed;
    wanted.importance = importanceOfPoints(part, goal.faceWeights);
    return finishSurface(bent.surface, wanted, task, [&](const LabelledSurface& now) {
        if (watch)
            watch("finish", now);
    });
}

} // namespace moldwright
