// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/attempt.h"

#include "base/parallel.h"
#include "castability/analysis.h"
#include "castability/float_rounding.h"
#include "castability/placed_cast.h"
#include "design/castable_shape.h"
#include "design/comparison.h"
#include "design/pins_in_plane.h"
#include "design/proxy.h"
#include "design/stopwatch.h"
#include "exchange/tetrahedralize.h"
#include "mesh/measures.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace moldwright {

namespace {

constexpr int kRoundingAttempts = 3; ///< finishes with ever coarser clean-up until floats keep the draft

/// Size of a float's rounding step at the part's largest coordinate, mm.
double floatStep(const IndexedMesh& part) {
    const double largest = part.V.cwiseAbs().maxCoeff();
    return largest * std::numeric_limits<float>::epsilon();
}

/// The proof on the cast, and where that holds, on the cast in the mold's frame: where a skirt nearly touches
/// another surface, floats that fall otherwise may make them cross there.
Certificate proofOf(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                    double draftDegrees) {
    Certificate proof = certify(cast, labels, state, draftDegrees);
    if (!proof.holds())
        return proof;
    const PlacedCast placed = placeCast(cast, labels, state, draftDegrees);
    const Certificate inMold = certify(placed.mesh, labels, placed.state, draftDegrees);
    return inMold.holds() ? proof : inMold;
}

/// Rounds to floats, proves, measures.
void takeCast(DesignResult& result, const PartedPart& part, const BentShape& bent, DesignRun& run) {
    const Stopwatch watch(run.seconds(), "postprocess");
    const DesignRequest& request = run.request();
    const LabelledSurface& surface = bent.surface;
    const IndexedMesh rounded = roundKeepingDraft(part.frame.toPart(surface.mesh), surface.labels,
                                                  part.state.directions, request.draftDegrees);
    const IndexedMesh& before = part.before;
    const std::vector<int>& source = surface.sourceVertex;
    DraftAnalysis analysis;
    result.labels = surface.labels;
    result.before = before.V(source, Eigen::all);
    parallelInvoke(
        {[&] { result.certificate = proofOf(rounded, surface.labels, part.state, request.draftDegrees); },
         [&] { result.limbs = measureLimbs(before, rounded, source, request.limbTips); },
         [&] { result.change = measureChange(*request.part, before, rounded, source); },
         [&] { result.strain = surfaceStrain(before, rounded, source); },
         [&] { analysis = analyzeDraft(rounded, part.state, request.draftDegrees, false); }});
    result.regions = measureRegions(request.regions, before, part.surface.sourceFace, rounded, source);
    result.pins = pinnedPoints(bent.pins, part, rounded, source);
    result.castable = result.certificate.holds();
    result.energy = analysis.energy;
    // On an oblique plane rounded points lie a hair off it and analysis sees two pieces: the proof has
    // the last word.
    result.violatingAreaFraction = result.castable ? 0 : analysis.violatingAreaFraction;
    result.change.filledVolumeFraction = part.filledVolume / volume(*request.part);
    result.cast = std::make_shared<const IndexedMesh>(rounded);
}

ShapeGoal goalOf(const Attempt& attempt, const DesignRun& run) {
    return {run.request().draftDegrees, attempt.state.directions, run.request().faceWeights,
            [&run] { return run.finishAsked(); }, attempt.means != Means::QuickProxy};
}

/// Whether the points of the part lead, in their order, those of the parted part.
bool keepsPoints(const PartedPart& part) {
    return std::ranges::none_of(part.surface.sourceFace, [](int f) { return f < 0; });
}

ShapeWatch frameWatch(const PartedPart& part, DesignRun& run) {
    // Without anyone to see them, frames would be copied for nothing.
    if (!run.watched() && !run.live())
        return {};
    return [&](const char* stage, const LabelledSurface& surface) {
        IndexedMesh shape = part.frame.toPart(surface.mesh);
        const bool keeps = keepsPoints(part);
        if (keeps && shape.vertexCount() == part.surface.mesh.vertexCount())
            run.setReached(shape, part.state);
        run.show({stage, std::move(shape), surface.labels, part.state,
                  keeps ? std::make_shared<const Points>(part.before.V(surface.sourceVertex, Eigen::all))
                        : nullptr});
    };
}

/// The same for a stage that takes no change: one ends it.
ShapeWatch hearingWatch(const PartedPart& part, DesignRun& run) {
    return [&run, show = frameWatch(part, run)](const char* stage, const LabelledSurface& surface) {
        if (show)
            show(stage, surface);
        run.hear(false);
    };
}

using BendOnce = std::function<BentShape(const ShapeGoal&, const BentShape* from)>;

/// Bends, and goes on from where it is whenever something is changed that bending takes as it goes. The
/// directions that it ends with are those of `part` and `attempt`.
BentShape bendHearing(PartedPart& part, Attempt& attempt, DesignRun& run, const BendOnce& bendOnce) {
    const auto directionsOf = [&](const LabelledSurface& surface) {
        attempt.state.directions = run.directionsFor(part.frame.toPart(surface.mesh), attempt.state.plane);
        part.state.directions = attempt.state.directions;
        return attempt.state.directions;
    };
    std::optional<BentShape> bent;
    for (bool again = true; again;) {
        again = false;
        const LiveSettings old = run.request();
        ShapeGoal goal = goalOf(attempt, run);
        goal.enough = [&] {
            again = run.hear(true);
            return again || run.stopped() || run.finishAsked();
        };
        if (old.followDirections && old.directionsChoice == DirectionsChoice::Automatic)
            goal.follow = directionsOf;
        bent = bendOnce(goal, bent ? &*bent : nullptr);
        const LiveSettings& now = run.request();
        if (again && (now.directionsChoice != old.directionsChoice || now.directions != old.directions ||
                      now.limits != old.limits))
            directionsOf(bent->surface);
    }
    return *bent;
}

/// Finishes a bent shape, rounds and proves it; again with a coarser clean-up where floats lose the draft.
Result<DesignResult> finishAndProve(const PartedPart& part, const BentShape& bent, const ShapeGoal& goal,
                                    const Task& task, DesignRun& run) {
    const DesignRequest& request = run.request();
    if (run.next())
        return DesignRun::cancelled();
    DesignResult result;
    result.state = part.state;
    result.localGlobalIterations = bent.iterations;
    double resolution = floatStep(*request.part);
    for (int attempt = 0; attempt < kRoundingAttempts; ++attempt, resolution *= 4) {
        BentShape finished = bent;
        const bool reached = [&] {
            const Stopwatch watch(run.seconds(), "postprocess");
            return finish(finished, part, goal, resolution, task, hearingWatch(part, run));
        }();
        result.cutShort = run.stopped();
        if (run.next() || (result.cutShort && !request.keepUnfinished))
            return DesignRun::cancelled();
        takeCast(result, part, finished, run);
        if (result.castable || !reached || result.cutShort)
            break;
    }
    return result;
}

/// The part, if pieces of it were not joined against the request.
Result<PartedPart> unlessJoined(Result<PartedPart> part, const Attempt& attempt, const DesignRun& run) {
    if (part)
        part->before = beforePinning(*part, *attempt.shape, *run.request().part);
    if (part && part->joinsPieces && !run.request().mergePieces)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("design",
                               "Filling would join pieces of the part that are apart. Allow it, take "
                               "them apart further, or give another plane."));
    return part;
}

Result<PartedPart> parted(const Attempt& attempt, const Task& task, DesignRun& run) {
    const Stopwatch watch(run.seconds(), attempt.fill ? "fill" : "plane");
    return unlessJoined(attempt.fill
                            ? filledSurface(*attempt.shape, attempt.state, *attempt.fill, task, attempt.pins)
                            : partSurface(*attempt.shape, attempt.state, task, attempt.pins),
                        attempt, run);
}

/// Everything filled, with draft: then nothing needs bending, and only the finish has a little to do.
Result<DesignResult> fillWholly(const Attempt& attempt, const ShapeGoal& goal, const Task& task,
                                DesignRun& run) {
    const Result<PartedPart> part = [&] {
        const Stopwatch watch(run.seconds(), "fill");
        return unlessJoined(
            filledWithDraft(*attempt.shape, attempt.state, goal.draftDegrees, task, attempt.pins), attempt,
            run);
    }();
    if (!part)
        return std::unexpected(part.error());
    // Clean-up alone is quickest; where it makes something cross, motion comes first.
    Result<DesignResult> result;
    for (const bool followed : {false, true}) {
        const BentShape asItIs{surfaceAt(*part, part->surface.mesh.V), 0, followed, part->pins};
        result = finishAndProve(*part, asItIs, goal, task, run);
        if (!result || result->castable || task.stopped())
            break;
    }
    return result;
}

/// The part with tetrahedra inside; parted with more caution where TetGen refuses it.
Result<PartedSolid> tetrahedralized(const Attempt& attempt, const PartedPart& part, const Task& task,
                                    DesignRun& run) {
    const Stopwatch watch(run.seconds(), "tetrahedralize");
    if (Result<TetMesh> tets =
            tetrahedralize(part.surface.mesh, task, kTetGenSwitches, innerPlaces(part.pins)))
        return PartedSolid{part, std::move(*tets)};
    Result<PartedSolid> solid =
        attempt.fill ? filledSolid(*attempt.shape, attempt.state, *attempt.fill, task, attempt.pins)
                     : partSolid(*attempt.shape, attempt.state, task, attempt.pins);
    if (solid)
        solid->before = beforePinning(*solid, *attempt.shape, *run.request().part);
    return solid;
}

/// Bends the part's own tetrahedra.
Result<DesignResult> bendWhole(Attempt& attempt, const PartedPart& part, const Task& task, DesignRun& run) {
    Result<PartedSolid> solid = tetrahedralized(attempt, part, task, run);
    if (!solid)
        return std::unexpected(solid.error());
    const BentShape bent = [&] {
        const Stopwatch watch(run.seconds(), "elastoplastic");
        return bendHearing(*solid, attempt, run, [&](const ShapeGoal& goal, const BentShape* from) {
            return bend(*solid, goal, task.part(0, 0.8), frameWatch(*solid, run), from);
        });
    }();
    Result<DesignResult> result = finishAndProve(*solid, bent, goalOf(attempt, run), task.part(0.8, 1), run);
    if (result)
        result->tets = static_cast<int>(solid->tets.T.rows());
    return result;
}

/// Bends a stand-in, and the part's surface follows.
Result<DesignResult> bendStandIn(const Proxy& proxy, Attempt& attempt, const Task& task, DesignRun& run) {
    PartedPart part = *attempt.parted;
    const BentShape bent = [&] {
        const Stopwatch watch(run.seconds(), "elastoplastic");
        return bendHearing(part, attempt, run, [&](const ShapeGoal& goal, const BentShape* from) {
            return bendByProxy(part, proxy, goal, task.part(0, 0.6), frameWatch(part, run), from);
        });
    }();
    Result<DesignResult> result = finishAndProve(part, bent, goalOf(attempt, run), task.part(0.6, 1), run);
    if (result) {
        result->tets = static_cast<int>(proxy.solid.tets.T.rows());
        result->bentByProxy = true;
    }
    return result;
}

} // namespace

Result<DesignResult> tryAttempt(Attempt& attempt, const Task& task, DesignRun& run) {
    const ShapeGoal goal = goalOf(attempt, run);
    const bool fillsAll =
        attempt.fill && attempt.fill->extent == FillExtent::All && !bendsAny(attempt.fill->choices);
    if (fillsAll && !attempt.parted)
        if (Result<DesignResult> result = fillWholly(attempt, goal, task, run);
            (result && result->castable) || task.stopped())
            return result;
    if (!attempt.parted) {
        Result<PartedPart> made = parted(attempt, task, run);
        if (!made)
            return std::unexpected(made.error());
        attempt.parted = std::make_shared<const PartedPart>(std::move(*made));
    }
    if (attempt.parted->state != attempt.state) {
        PartedPart turned = *attempt.parted; // by means during which the directions were changed
        turned.state = attempt.state;
        attempt.parted = std::make_shared<const PartedPart>(std::move(turned));
    }
    const std::shared_ptr<const PartedPart> part = attempt.parted;
    if (passesAlready(*part, goal.draftDegrees))
        return finishAndProve(*part, {surfaceAt(*part, part->surface.mesh.V), 0, false, part->pins}, goal,
                              task, run);
    const std::optional<Proxy> proxy = [&]() -> std::optional<Proxy> {
        const Stopwatch watch(run.seconds(), "tetrahedralize");
        if (attempt.means == Means::Itself)
            return std::nullopt;
        return proxyOf(*part, attempt.means == Means::FineProxy ? ProxyDetail::Fine : ProxyDetail::Quick,
                       goal.faceWeights, task);
    }();
    return proxy ? bendStandIn(*proxy, attempt, task, run) : bendWhole(attempt, *part, task, run);
}

} // namespace moldwright
