// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/default_method.h"

#include "castability/analysis.h"
#include "castability/float_rounding.h"
#include "design/castable_shape.h"
#include "design/comparison.h"
#include "design/mold_states.h"
#include "design/paper_method.h"
#include "design/parting.h"
#include "design/remedies.h"
#include "design/stopwatch.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldwright {

namespace {

constexpr std::size_t kPlanesTried = 6;    ///< deformed in turn until one ends castable, its limbs kept
constexpr std::size_t kPlanesForLimbs = 3; ///< of these, tried when only a limb is short
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

/// Castable before not castable; then the fewer limbs lost, or the less left undone.
bool better(const DesignResult& a, const DesignResult& b) {
    if (a.castable != b.castable)
        return a.castable;
    if (!a.castable)
        return a.violatingAreaFraction < b.violatingAreaFraction;
    return limbsLost(a) < limbsLost(b);
}

/// Rounds to floats, proves, measures.
void takeCast(DesignResult& result, const PartedSolid& solid, const CastableShape& bent, DesignRun& run) {
    const Stopwatch watch(run.seconds(), "postprocess");
    const DesignRequest& request = run.request();
    const IndexedMesh rounded = roundKeepingDraft(solid.frame.toPart(bent.surface.mesh), bent.surface.labels,
                                                  solid.state.directions, request.draftDegrees);
    result.labels = bent.surface.labels;
    result.certificate = certify(rounded, result.labels, solid.state, request.draftDegrees);
    result.castable = result.certificate.holds();
    const DraftAnalysis analysis = analyzeDraft(rounded, solid.state, request.draftDegrees, false);
    result.energy = analysis.energy;
    // On an oblique plane rounded points lie a hair off it and analysis sees two pieces: the proof has
    // the last word.
    result.violatingAreaFraction = result.castable ? 0 : analysis.violatingAreaFraction;
    const IndexedMesh before = solid.frame.toPart(solid.surface.mesh);
    result.change = measureChange(*request.part, before, rounded, bent.surface.sourceVertex);
    result.change.filledVolumeFraction = solid.filledVolume / volume(*request.part);
    result.strain = surfaceStrain(before, rounded, bent.surface.sourceVertex);
    result.limbs = measureLimbs(before, rounded, bent.surface.sourceVertex, request.limbTips);
    result.cast = std::make_shared<const IndexedMesh>(rounded);
}

CastableShape bend(const PartedSolid& solid, const ShapeGoal& goal, const Task& task, DesignRun& run) {
    const Stopwatch watch(run.seconds(), "elastoplastic");
    // Without anyone to see them, frames would be copied for nothing.
    if (!run.watched())
        return bendToCastable(solid, goal, task, {});
    return bendToCastable(solid, goal, task, [&](const char* stage, const LabelledSurface& surface) {
        run.show(stage, solid.frame.toPart(surface.mesh), surface.labels, solid.state);
    });
}

/// Bends a solid, rounds and proves it; finishes again with a coarser clean-up where floats lose the draft.
Result<DesignResult> bendAndProve(const PartedSolid& solid, const Task& task, DesignRun& run) {
    const DesignRequest& request = run.request();
    DesignResult result;
    result.state = solid.state;
    result.tets = static_cast<int>(solid.tets.T.rows());
    ShapeGoal goal{request.draftDegrees, request.faceWeights, floatStep(*request.part), request.finishNow};
    for (int attempt = 0; attempt < kRoundingAttempts; ++attempt, goal.resolution *= 4) {
        const CastableShape bent = bend(solid, goal, task, run);
        result.localGlobalIterations += bent.iterations;
        result.cutShort = run.stopped();
        if (result.cutShort && !request.keepUnfinished)
            return DesignRun::cancelled();
        takeCast(result, solid, bent, run);
        if (result.castable || !bent.reached || result.cutShort)
            break;
    }
    return result;
}

Result<DesignResult> tryBending(const IndexedMesh& shape, const MoldState& state, const Task& task,
                                DesignRun& run) {
    const Result<PartedSolid> solid = [&] {
        const Stopwatch watch(run.seconds(), "tetrahedralize");
        return partSolid(shape, state, task);
    }();
    if (!solid)
        return std::unexpected(solid.error());
    return bendAndProve(*solid, task, run);
}

/// Fills what cannot leave at `state`, then leans the walls that filling made.
Result<DesignResult> tryFilling(const IndexedMesh& shape, const MoldState& state, FillExtent extent,
                                const Task& task, DesignRun& run) {
    const Result<PartedSolid> solid = [&] {
        const Stopwatch watch(run.seconds(), "fill");
        return filledSolid(shape, state, extent, task);
    }();
    if (!solid)
        return std::unexpected(solid.error());
    if (!run.request().mergePieces &&
        connectedComponents(solid->surface.mesh).count < connectedComponents(shape).count)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("design",
                               "Filling would join pieces of the part that are apart. Allow it, take "
                               "them apart further, or give another plane."));
    return bendAndProve(*solid, task, run);
}

/// The best of the passing planes, and why there is none.
struct Tries {
    std::optional<MoldState> first; ///< the first state that passed
    std::optional<DesignResult> best;
    std::optional<Error> lastError;

    void take(Result<DesignResult> result) {
        if (!result)
            lastError = result.error();
        else if (!best || better(*result, *best))
            best = std::move(*result);
    }
    [[nodiscard]] bool good() const { return best && best->castable && limbsLost(*best) == 0; }
    [[nodiscard]] bool castable() const { return best && best->castable; }
    /// Castable, but only by giving up a limb, or not castable at all.
    [[nodiscard]] bool wantsFilling() const {
        return !best || !best->castable || limbsLost(*best) > kMuchLost;
    }
};

Tries tryStates(const IndexedMesh& shape, MoldStates& states, DesignRun& run) {
    Tries tries;
    const double share = 0.85 / kPlanesTried;
    for (std::size_t i = 0; i < kPlanesTried && !tries.good() && !run.stopped(); ++i) {
        if (tries.castable() && i >= kPlanesForLimbs)
            break;
        const std::optional<MoldState> state = states.next();
        if (!state)
            break;
        tries.first = tries.first ? tries.first : state;
        const double from = 0.1 + static_cast<double>(i) * share;
        tries.take(tryBending(shape, *state, run.task().part(from, from + share), run));
    }
    return tries;
}

/// As little as needed first: the less is filled, the more of the part is kept.
void fillWhereWanted(const IndexedMesh& shape, const MoldStates& states, Tries& tries, DesignRun& run) {
    const MoldState state = tries.first.value_or(states.best());
    const Task task = run.task().part(0.95, 1);
    if (!tries.first && !run.stopped())
        tries.take(tryFilling(shape, state, FillExtent::Needed, task, run));
    if (tries.wantsFilling() && !run.stopped())
        tries.take(tryFilling(shape, state, FillExtent::All, task, run));
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
