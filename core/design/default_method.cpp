// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/default_method.h"

#include "design/attempt.h"
#include "design/mold_states.h"
#include "design/paper_method.h"
#include "design/parting.h"
#include "design/remedies.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

constexpr std::size_t kPlanesTried = 6;    ///< deformed in turn until one ends castable, its limbs kept
constexpr std::size_t kPlanesForLimbs = 3; ///< of these, tried when only a limb is short
constexpr int kFacesBentWhole =
    60000;                           ///< larger parts bend by a stand-in only: theirs are too many tetrahedra
constexpr int kPinSteps = 12;        ///< plastic steps that bring pins to the plane before the part is split
constexpr double kLimbLength = 0.85; ///< share of its length that a limb keeps, or it counts as lost
constexpr double kLimbVolume = 0.75; ///< share of its volume
constexpr double kNearlyKept = 0.15; ///< missing shares, summed, that more detail may well bring back
constexpr double kMuchLost = 0.25;   ///< missing shares, summed, from which filling is tried beside bending

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

/// The best of the passing planes, and why there is none.
struct Tries {
    /// An attempt that a stand-in did not bring to a good end: a finer one, or the part itself, may come
    /// further.
    struct Unfinished {
        Attempt attempt;
        bool castable;
        double givenUp;
        bool operator<(const Unfinished& other) const {
            return std::pair(!castable, givenUp) < std::pair(!other.castable, other.givenUp);
        }
    };

    std::optional<MoldState> first; ///< the first state that passed
    std::optional<DesignResult> best;
    std::optional<Error> lastError;
    std::vector<Unfinished> again;

    /// Whether it all but ended well: more detail may bring back what is missing.
    bool take(const Attempt& attempt, Result<DesignResult> result) {
        if (!result) {
            lastError = result.error();
            return false;
        }
        bool nearly = false;
        if (result->bentByProxy && !goodEnough(*result)) {
            again.push_back({attempt, result->castable, givenUp(*result)});
            nearly = result->castable && givenUp(*result) <= kNearlyKept;
        }
        if (!best || better(*result, *best))
            best = std::move(*result);
        return nearly;
    }
    [[nodiscard]] bool good() const { return best && goodEnough(*best); }
    [[nodiscard]] bool castable() const { return best && best->castable; }
    /// Castable, but only by giving up a limb, or not castable at all.
    [[nodiscard]] bool wantsFilling() const {
        return !best || !best->castable || limbsLost(*best) > kMuchLost;
    }
};

bool tryBy(Means means, Attempt attempt, Tries& tries, const Task& task, DesignRun& run) {
    attempt.means = means;
    return tries.take(attempt, tryAttempt(attempt, task, run));
}

/// Bends quickly, and at once with more detail where that all but kept the limbs.
void tryQuickly(const Attempt& attempt, Tries& tries, const Task& task, DesignRun& run) {
    if (tryBy(Means::QuickProxy, attempt, tries, task, run) && !run.stopped()) {
        tries.again.pop_back();
        tryBy(Means::FineProxy, attempt, tries, task, run);
    }
}

/// Bends by finer means where a stand-in was not enough, what came furthest first, until one attempt ends
/// well. Once something is castable, only what was castable too can still be better.
void tryAgain(Tries& tries, const Task& task, DesignRun& run) {
    for (const Means means : {Means::FineProxy, Means::Itself}) {
        std::vector<Tries::Unfinished> again = std::exchange(tries.again, {});
        std::stable_sort(again.begin(), again.end());
        for (const auto& unfinished : again) {
            const Attempt& attempt = unfinished.attempt;
            const bool tooLarge = means == Means::Itself && attempt.shape->faceCount() > kFacesBentWhole;
            if (tries.good() || run.stopped() || tooLarge || (tries.castable() && !unfinished.castable))
                continue;
            if (attempt.means < means)
                tryBy(means, attempt, tries, task, run);
            else
                tries.again.push_back(unfinished);
        }
    }
    tries.again.clear();
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
        tryQuickly({&shape, *state, {}}, tries, run.task().part(from, from + share), run);
    }
    tryAgain(tries, run.task().part(0.8, 0.95), run);
    return tries;
}

/// As little as needed first: the less is filled, the more of the part is kept.
void fillWhereWanted(const IndexedMesh& shape, const MoldStates& states, Tries& tries, DesignRun& run) {
    const MoldState state = tries.first.value_or(states.best());
    const Task task = run.task().part(0.95, 1);
    const auto tryFilling = [&](FillExtent extent) {
        tryQuickly({&shape, state, extent}, tries, task, run);
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
