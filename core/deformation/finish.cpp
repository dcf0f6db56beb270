// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/finish.h"

#include "deformation/dislodge.h"
#include "deformation/finish_region.h"
#include "deformation/side_hinge.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kAimHigher = 1.0;  ///< degrees above the required draft
constexpr double kEnough = 0.2;     ///< degrees above the required draft that end the finish
constexpr double kAreaFloor = 0.01; ///< of the mean face area: slivers must count too
constexpr double kMany = 0.02;      ///< of the faces: more are worked on all together
constexpr int kFew = 100;           ///< faces left over that are dislodged one by one
constexpr int kRings = 6;           ///< of faces about those that need work
constexpr int kIterations = 100;
constexpr std::size_t kStalledRounds = 3; ///< without fewer violations: what is left is stuck
constexpr double kThinInSteps =
    400; ///< rounding steps below which a face is too thin to keep its draft in floats

/// Areas of the faces listed, slivers counted as if they were larger.
std::vector<double> flooredAreas(const IndexedMesh& mesh, const std::vector<int>& faces) {
    const double floor = kAreaFloor * surfaceArea(mesh) / mesh.faceCount();
    std::vector<double> areas;
    areas.reserve(faces.size());
    for (const int f : faces)
        areas.push_back(std::max(doubleAreaVector(mesh, f).norm() / 2, floor));
    return areas;
}

/// Faces below a draft angle: 1 each.
std::vector<char> below(const LabelledSurface& surface, const Directions& directions, double tau) {
    std::vector<char> faces;
    faces.reserve(surface.labels.size());
    for (int f = 0; f < surface.mesh.faceCount(); ++f) {
        const Eigen::Vector3d c = doubleAreaVector(surface.mesh, f);
        const Eigen::Vector3d& d = directions.of(surface.labels[static_cast<std::size_t>(f)]);
        faces.push_back(!(c.dot(d) >= tau * c.norm()));
    }
    return faces;
}

int tooSteep(const LabelledSurface& surface, const Directions& directions, double draftDegrees) {
    return sideDraft(surface.mesh.F, surface.labels, directions, surface.mesh.V,
                     std::sin(radians(draftDegrees)))
        .violating;
}

int violations(const LabelledSurface& surface, const Directions& directions, double draftDegrees) {
    return tooSteep(surface, directions, draftDegrees) + countFolds(surface);
}

/// Where a round works: about the faces that need it; everywhere while these are many.
FinishRegion regionOfRound(const LabelledSurface& surface, const FinishGoal& goal, double tau, int rings) {
    const std::vector<char> faces = below(surface, goal.directions, tau);
    if (static_cast<double>(std::count(faces.begin(), faces.end(), 1)) > kMany * surface.mesh.faceCount())
        return wholeRegion(surface, goal.directions, goal.importance);
    return regionAround(surface, faces, rings, goal.directions, goal.importance);
}

/// One minimisation of the castability energy about the faces that want it.
void relax(LabelledSurface& surface, const StageWeights& weights, const FinishGoal& goal, int rings,
           const Task& task) {
    const double enough = std::sin(radians(goal.draftDegrees + kEnough));
    const FinishRegion region = regionOfRound(surface, goal, enough, rings);
    const LabelledBody& body = region.body;
    LabelledProblem problem(body);
    const Positions X = problem.minimize(
        weights, flooredAreas(surface.mesh, region.faces), body.shape.V, [&](const Positions& Y) {
            return !task.stopped() &&
                   sideDraft(body.shape.F, body.labels, goal.directions, Y, enough).violating > 0;
        });
    for (std::size_t i = 0; i < region.points.size(); ++i)
        surface.mesh.V.row(region.points[i]) = X.row(static_cast<Eigen::Index>(i));
}

/// What a finish does first: clean-up brings more to an end but costs detail wherever faces miss their draft.
enum class First { Motion, CleanUp };

/// Rounds of motion and clean-up until every face has its draft or what is left is stuck.
bool runRounds(LabelledSurface& surface, First first, const FinishGoal& goal, const Task& task,
               const std::function<void(const LabelledSurface&)>& watch) {
    StageWeights weights;
    weights.elastic = first == First::Motion ? 1e-2 : 1e-3;
    weights.tau = std::sin(radians(goal.draftDegrees + kAimHigher));
    weights.barrier = 0.01;
    weights.iterations = kIterations;
    weights.relativeDecrease = 1e-9;
    const CleanUpGoal mending{goal.directions, std::sin(radians(goal.draftDegrees + kEnough)),
                              kThinInSteps * goal.resolution, kThinInSteps * goal.resolution};
    if (first == First::CleanUp)
        cleanUp(surface, mending);
    std::vector<int> history;
    int rings = kRings;
    for (int round = 0; round < goal.rounds && !task.stopped(); ++round) {
        if (violations(surface, goal.directions, goal.draftDegrees + kEnough) == 0)
            return true;
        task.progress(static_cast<double>(round) / goal.rounds, "finish");
        if (tooSteep(surface, goal.directions, goal.draftDegrees + kEnough) > 0)
            relax(surface, weights, goal, rings, task);
        cleanUp(surface, mending);
        weights.elastic = std::max(weights.elastic * 0.1, 1e-8);
        weights.barrier = std::max(weights.barrier * 0.3, 1e-4);
        if (watch)
            watch(surface);
        if (violations(surface, goal.directions, goal.draftDegrees + kEnough) <= kFew)
            dislodge(surface, mending);
        history.push_back(violations(surface, goal.directions, goal.draftDegrees));
        if (round > 0 && history[history.size() - 2] <= history.back())
            rings *= 2;
        if (history.size() > kStalledRounds && history.back() >= history[history.size() - 1 - kStalledRounds])
            break;
    }
    return violations(surface, goal.directions, goal.draftDegrees) == 0;
}

} // namespace

bool finishSurface(LabelledSurface& surface, const FinishGoal& goal, const Task& task,
                   const std::function<void(const LabelledSurface&)>& watch) {
    LabelledSurface other = surface;
    if (runRounds(surface, goal.keepDetail ? First::Motion : First::CleanUp, goal, task.part(0, 0.5), watch))
        return true;
    if (task.stopped() ||
        !runRounds(other, goal.keepDetail ? First::CleanUp : First::Motion, goal, task.part(0.5, 1), watch))
        return false;
    surface = std::move(other);
    return true;
}

} // namespace moldwright
