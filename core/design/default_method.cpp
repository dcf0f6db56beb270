// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/default_method.h"

#include "castability/analysis.h"
#include "castability/float_rounding.h"
#include "design/castable_shape.h"
#include "design/comparison.h"
#include "design/mold_states.h"
#include "design/paper_method.h"
#include "design/parting.h"
#include "design/proxy.h"
#include "design/remedies.h"
#include "design/stopwatch.h"
#include "exchange/tetrahedralize.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace moldwright {

namespace {

constexpr std::size_t kPlanesTried = 6;    ///< deformed in turn until one ends castable, its limbs kept
constexpr std::size_t kPlanesForLimbs = 3; ///< of these, tried when only a limb is short
constexpr int kFacesBentWhole =
    60000;                           ///< larger parts bend by a stand-in only: theirs are too many tetrahedra
constexpr int kRoundingAttempts = 3; ///< finishes with ever coarser clean-up until floats keep the draft
constexpr int kPinSteps = 12;        ///< plastic steps that bring pins to the plane before the part is split
constexpr double kLimbLength = 0.85; ///< share of its length that a limb keeps, or it counts as lost
constexpr double kLimbVolume = 0.75; ///< share of its volume
constexpr double kMuchLost = 0.25;   ///< missing shares, summed, from which filling is tried beside bending

/// Size of a float's rounding step at the part's largest coordinate, mm.
double floatStep(const IndexedMesh& part) {
    const double largest = part.V.cwiseAbs().maxCoeff();
    return largest * std::numeric_limits<float>::epsilon();
}

/// By how much limbs fell short of what they are to keep, summed; 0: all kept.
double limbsLost(const DesignResult& result) {
    double lost = 0;
    for (const LimbMeasure& limb : result.limbs)
        lost += std::max(0.0, kLimbLength - limb.lengthRatio) + std::max(0.0, kLimbVolume - limb.volumeRatio);
    return lost;
}

bool goodEnough(const DesignResult& result) {
    return result.castable && limbsLost(result) == 0;
}

/// What the part has given up: limbs, and the share of its volume that filling buries it under.
double givenUp(const DesignResult& result) {
    return limbsLost(result) + result.change.filledVolumeFraction;
}

/// Castable before not castable; then the less given up, or the less left undone.
bool better(const DesignResult& a, const DesignResult& b) {
    if (a.castable != b.castable)
        return a.castable;
    if (!a.castable)
        return a.violatingAreaFraction < b.violatingAreaFraction;
    return givenUp(a) < givenUp(b);
}

/// Rounds to floats, proves, measures.
void takeCast(DesignResult& result, const PartedPart& part, const LabelledSurface& surface, DesignRun& run) {
    const Stopwatch watch(run.seconds(), "postprocess");
    const DesignRequest& request = run.request();
    const IndexedMesh rounded = roundKeepingDraft(part.frame.toPart(surface.mesh), surface.labels,
                                                  part.state.directions, request.draftDegrees);
    result.labels = surface.labels;
    result.certificate = certify(rounded, result.labels, part.state, request.draftDegrees);
    result.castable = result.certificate.holds();
    const DraftAnalysis analysis = analyzeDraft(rounded, part.state, request.draftDegrees, false);
    result.energy = analysis.energy;
    // On an oblique plane rounded points lie a hair off it and analysis sees two pieces: the proof has
    // the last word.
    result.violatingAreaFraction = result.castable ? 0 : analysis.violatingAreaFraction;
    const IndexedMesh before = part.frame.toPart(part.surface.mesh);
    result.change = measureChange(*request.part, before, rounded, surface.sourceVertex);
    result.change.filledVolumeFraction = part.filledVolume / volume(*request.part);
    result.strain = surfaceStrain(before, rounded, surface.sourceVertex);
    result.limbs = measureLimbs(before, rounded, surface.sourceVertex, request.limbTips);
    result.cast = std::make_shared<const IndexedMesh>(rounded);
}

/// What is done at one state: the part as it is or filled first, then bent.
struct Attempt {
    const IndexedMesh* shape;
    MoldState state;
    std::optional<FillExtent> fill;
};

ShapeGoal goalOf(const DesignRun& run) {
    return {run.request().draftDegrees, run.request().faceWeights, run.request().finishNow};
}

ShapeWatch frameWatch(const PartedPart& part, DesignRun& run) {
    // Without anyone to see them, frames would be copied for nothing.
    if (!run.watched())
        return {};
    return [&](const char* stage, const LabelledSurface& surface) {
        run.show(stage, part.frame.toPart(surface.mesh), surface.labels, part.state);
    };
}

/// Finishes a bent shape, rounds and proves it; again with a coarser clean-up where floats lose the draft.
Result<DesignResult> finishAndProve(const PartedPart& part, const BentShape& bent, const ShapeGoal& goal,
                                    const Task& task, DesignRun& run) {
    const DesignRequest& request = run.request();
    DesignResult result;
    result.state = part.state;
    result.localGlobalIterations = bent.iterations;
    double resolution = floatStep(*request.part);
    for (int attempt = 0; attempt < kRoundingAttempts; ++attempt, resolution *= 4) {
        BentShape finished = bent;
        const bool reached = [&] {
            const Stopwatch watch(run.seconds(), "postprocess");
            return finish(finished, part, goal, resolution, task, frameWatch(part, run));
        }();
        result.cutShort = run.stopped();
        if (result.cutShort && !request.keepUnfinished)
            return DesignRun::cancelled();
        takeCast(result, part, finished.surface, run);
        if (result.castable || !reached || result.cutShort)
            break;
    }
    return result;
}

Result<PartedPart> parted(const Attempt& attempt, const Task& task, DesignRun& run) {
    const Stopwatch watch(run.seconds(), attempt.fill ? "fill" : "plane");
    Result<PartedPart> part = attempt.fill ? filledSurface(*attempt.shape, attempt.state, *attempt.fill, task)
                                           : partSurface(*attempt.shape, attempt.state, task);
    if (part && !run.request().mergePieces &&
        connectedComponents(part->surface.mesh).count < connectedComponents(*attempt.shape).count)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("design",
                               "Filling would join pieces of the part that are apart. Allow it, take "
                               "them apart further, or give another plane."));
    return part;
}

/// The part with tetrahedra inside; parted with more caution where TetGen refuses it.
Result<PartedSolid> tetrahedralized(const Attempt& attempt, const PartedPart& part, const Task& task,
                                    DesignRun& run) {
    const Stopwatch watch(run.seconds(), "tetrahedralize");
    if (Result<TetMesh> tets = tetrahedralize(part.surface.mesh, task))
        return PartedSolid{part, std::move(*tets)};
    return attempt.fill ? filledSolid(*attempt.shape, attempt.state, *attempt.fill, task)
                        : partSolid(*attempt.shape, attempt.state, task);
}

/// Bends the part's own tetrahedra.
Result<DesignResult> bendWhole(const Attempt& attempt, const PartedPart& part, const Task& task,
                               DesignRun& run) {
    const ShapeGoal goal = goalOf(run);
    const Result<PartedSolid> solid = tetrahedralized(attempt, part, task, run);
    if (!solid)
        return std::unexpected(solid.error());
    const BentShape bent = [&] {
        const Stopwatch watch(run.seconds(), "elastoplastic");
        return bend(*solid, goal, task.part(0, 0.8), frameWatch(*solid, run));
    }();
    Result<DesignResult> result = finishAndProve(*solid, bent, goal, task.part(0.8, 1), run);
    if (result)
        result->tets = static_cast<int>(solid->tets.T.rows());
    return result;
}

/// Bends quickly by a coarse stand-in where there is one, otherwise the part's own tetrahedra.
Result<DesignResult> tryAttempt(const Attempt& attempt, const Task& task, DesignRun& run) {
    const ShapeGoal goal = goalOf(run);
    const Result<PartedPart> part = parted(attempt, task, run);
    if (!part)
        return std::unexpected(part.error());
    if (passesAlready(*part, goal.draftDegrees))
        return finishAndProve(*part, {surfaceAt(*part, part->surface.mesh.V), 0}, goal, task, run);
    const std::optional<Proxy> proxy = [&] {
        const Stopwatch watch(run.seconds(), "tetrahedralize");
        return proxyOf(*part, task);
    }();
    if (!proxy)
        return bendWhole(attempt, *part, task, run);
    const BentShape bent = [&] {
        const Stopwatch watch(run.seconds(), "elastoplastic");
        return bendByProxy(*part, *proxy, goal, task.part(0, 0.6), frameWatch(*part, run));
    }();
    Result<DesignResult> result = finishAndProve(*part, bent, goal, task.part(0.6, 1), run);
    if (result) {
        result->tets = static_cast<int>(proxy->solid.tets.T.rows());
        result->bentByProxy = true;
    }
    return result;
}

/// The best of the passing planes, and why there is none.
struct Tries {
    std::optional<MoldState> first; ///< the first state that passed
    std::optional<DesignResult> best;
    std::optional<Error> lastError;
    std::vector<Attempt> again; ///< what a stand-in did not bring to an end: the part itself may come further

    void take(const Attempt& attempt, Result<DesignResult> result) {
        if (!result) {
            lastError = result.error();
            return;
        }
        if (result->bentByProxy && !goodEnough(*result) && attempt.shape->faceCount() <= kFacesBentWhole)
            again.push_back(attempt);
        if (!best || better(*result, *best))
            best = std::move(*result);
    }
    [[nodiscard]] bool good() const { return best && goodEnough(*best); }
    [[nodiscard]] bool castable() const { return best && best->castable; }
    /// Castable, but only by giving up a limb, or not castable at all.
    [[nodiscard]] bool wantsFilling() const {
        return !best || !best->castable || limbsLost(*best) > kMuchLost;
    }
};

Result<DesignResult> bendAgain(const Attempt& attempt, const Task& task, DesignRun& run) {
    const Result<PartedPart> part = parted(attempt, task, run);
    if (!part)
        return std::unexpected(part.error());
    return bendWhole(attempt, *part, task, run);
}

/// Bends the part itself where a stand-in was not enough, until one attempt ends well.
void tryAgain(Tries& tries, const Task& task, DesignRun& run) {
    for (const Attempt& attempt : std::exchange(tries.again, {}))
        if (!tries.good() && !run.stopped())
            tries.take(attempt, bendAgain(attempt, task, run));
}

Tries tryStates(const IndexedMesh& shape, MoldStates& states, DesignRun& run) {
    Tries tries;
    const double share = 0.7 / kPlanesTried;
    for (std::size_t i = 0; i < kPlanesTried && !tries.good() && !run.stopped(); ++i) {
        if (tries.castable() && i >= kPlanesForLimbs)
            break;
        const std::optional<MoldState> state = states.next();
        if (!state)
            break;
        tries.first = tries.first ? tries.first : state;
        const double from = 0.1 + static_cast<double>(i) * share;
        const Attempt attempt{&shape, *state, {}};
        tries.take(attempt, tryAttempt(attempt, run.task().part(from, from + share), run));
    }
    tryAgain(tries, run.task().part(0.8, 0.95), run);
    return tries;
}

/// As little as needed first: the less is filled, the more of the part is kept.
void fillWhereWanted(const IndexedMesh& shape, const MoldStates& states, Tries& tries, DesignRun& run) {
    const MoldState state = tries.first.value_or(states.best());
    const Task task = run.task().part(0.95, 1);
    const auto tryFilling = [&](FillExtent extent) {
        const Attempt attempt{&shape, state, extent};
        tries.take(attempt, tryAttempt(attempt, task, run));
        tryAgain(tries, task, run);
    };
    if (!tries.first && !run.stopped())
        tryFilling(FillExtent::Needed);
    if (tries.wantsFilling() && !run.stopped())
        tryFilling(FillExtent::All);
}

void tellObstructions(DesignResult& result, ObstructedPart obstructed, const WorkingFrame& frame) {
    result.obstructions = std::move(obstructed.obstructions);
    result.parted = std::make_shared<const IndexedMesh>(frame.toPart(obstructed.surface.mesh));
    result.partedLabels = std::move(obstructed.surface.labels);
}

/// Pins first pull the whole part, unsplit, until they lie in the plane: [Stein 2019], Section 6.1.
Result<SharedMesh> pinned(const MoldState& state, DesignRun& run) {
    Result<Elastoplastic> solver = elastoplasticAt(state, run);
    if (!solver)
        return std::unexpected(solver.error());
    for (int step = 0; step < kPinSteps && !run.stopped(); ++step) {
        solver->step(run.task());
        run.show("pins", solver->shape(), {}, solver->state());
    }
    if (run.stopped())
        return DesignRun::cancelled();
    return std::make_shared<const IndexedMesh>(solver->shape());
}

} // namespace

Result<DesignResult> designByBending(DesignRun& run) {
    const DesignRequest& request = run.request();
    SharedMesh shape = request.part;
    if (!request.pins.empty() && request.plane) {
        const Result<SharedMesh> bent =
            pinned({*request.plane, run.directionsFor(*shape, *request.plane)}, run);
        if (!bent)
            return std::unexpected(bent.error());
        shape = *bent;
    }
    Result<MoldStates> states = MoldStates::create(*shape, run);
    if (!states)
        return std::unexpected(states.error());
    Tries tries = tryStates(*shape, *states, run);
    ObstructedPart obstructed;
    if (!tries.first && !run.stopped())
        obstructed = obstructionsAt(*shape, states->best());
    if (!obstructed.obstructions.empty())
        offerRemedies(obstructed, *shape, states->best(), run);
    if (request.fill == FillChoice::Auto)
        fillWhereWanted(*shape, *states, tries, run);
    if (!tries.best) {
        if (run.stopped())
            return DesignRun::cancelled();
        if (obstructed.obstructions.empty())
            return std::unexpected(*tries.lastError);
        tries.best.emplace();
        tries.best->state = states->best();
        tries.best->certificate.reason = obstructed.obstructions.front().message.english();
    }
    if (!obstructed.obstructions.empty())
        tellObstructions(*tries.best, std::move(obstructed), WorkingFrame(*shape, states->best()));
    return *tries.best;
}

} // namespace moldwright
