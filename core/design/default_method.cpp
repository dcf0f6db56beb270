// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/default_method.h"

#include "deformation/pin_drawing.h"
#include "design/attempt.h"
#include "design/carried_pins.h"
#include "design/given_up.h"
#include "design/mold_states.h"
#include "design/pinned_planes.h"
#include "design/remedies.h"
#include "design/stopwatch.h"
#include "design/working_body.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

constexpr std::size_t kPlanesTried = 6;    ///< deformed in turn until one ends castable, its limbs kept
constexpr std::size_t kPlanesForLimbs = 3; ///< of these, tried when only a limb is short
constexpr int kFacesBentWhole =
    60000;                           ///< larger parts bend by a stand-in only: theirs are too many tetrahedra
constexpr int kPlanesForPins = 3;    ///< tried where pins came without a plane
constexpr double kNearlyKept = 0.15; ///< missing shares, summed, that more detail may well bring back
constexpr double kMuchLost = 0.25;   ///< missing shares, summed, from which filling is tried beside bending
constexpr double kBarelyLost = 0.05; ///< missing shares of a limb that is not worth filling
constexpr double kLimbReach = 0.15;  ///< of the diagonal: how far a limb's tip may be from its undercut
constexpr int kLimbRounds = 2;       ///< in which lost limbs are kept by filling
constexpr double kStrainFair = 0.5;  ///< rms strain up to which no other plane is looked at
constexpr double kHopeless = 1;      ///< missing shares, summed, that no finer stand-in brings back

bool goodEnough(const DesignResult& result) {
    return result.castable && bentAway(result) == 0;
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
    /// So good that no other plane need be looked at.
    [[nodiscard]] bool fair() const { return good() && best->strain.rms <= kStrainFair; }
    [[nodiscard]] bool castable() const { return best && best->castable; }
    /// Castable, but only by giving up a limb or the form, or not castable at all.
    [[nodiscard]] bool wantsFilling() const {
        return !best || !best->castable || bentAway(*best) > kMuchLost;
    }
};

bool tryBy(Means means, Attempt& attempt, Tries& tries, const Task& task, DesignRun& run) {
    attempt.means = means;
    return tries.take(attempt, tryAttempt(attempt, task, run));
}

/// Bends quickly, and at once with more detail where that all but kept the limbs.
void tryQuickly(Attempt attempt, Tries& tries, const Task& task, DesignRun& run) {
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
        for (auto& unfinished : again) {
            Attempt& attempt = unfinished.attempt;
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

/// A part that pins have drawn into the plane, and where they are in it.
struct PinnedShape {
    SharedMesh shape;
    std::vector<PlacedPin> pins; ///< part frame
};

/// What the designer chose to fill is filled whether or not the rest can be bent.
std::optional<Filling> chosenFilling(const DesignRun& run) {
    const std::vector<UndercutChoice>& choices = run.request().undercuts;
    return fillsAny(choices) ? std::optional(Filling{FillExtent::Chosen, choices}) : std::nullopt;
}

Tries tryStates(const PinnedShape& part, MoldStates& states, DesignRun& run) {
    Tries tries;
    const double share = 0.7 / kPlanesTried;
    for (std::size_t i = 0; i < kPlanesTried && !tries.fair() && !run.stopped(); ++i) {
        if (tries.castable() && i >= kPlanesForLimbs)
            break;
        const std::optional<MoldState> state = states.next();
        if (!state)
            break;
        tries.first = tries.first ? tries.first : state;
        const double from = 0.1 + static_cast<double>(i) * share;
        tryQuickly({part.shape.get(), *state, chosenFilling(run), Means::QuickProxy, part.pins}, tries,
                   run.task().part(from, from + share), run);
    }
    tryAgain(tries, run.task().part(0.8, 0.95), run);
    return tries;
}

/// Has the undercuts filled that a result's lost limbs lie in, but for those that would join pieces: that is
/// for the designer to choose. Returns whether any was new.
bool chooseAtLostLimbs(const DesignResult& result, const std::vector<FillableUndercut>& undercuts,
                       const IndexedMesh& shape, std::vector<UndercutChoice>& choices) {
    const double reach = kLimbReach * diagonal(shape);
    bool any = false;
    for (const LimbMeasure& limb : result.limbs) {
        if (missing(limb) <= kBarelyLost)
            continue;
        const int nearest = undercutNearest(undercuts, shape, limb.tip, reach);
        if (nearest < 0 || undercuts[static_cast<std::size_t>(nearest)].joins)
            continue;
        const UndercutChoice choice{undercuts[static_cast<std::size_t>(nearest)].place,
                                    UndercutChoice::Treatment::Fill};
        if (std::ranges::find(choices, choice) != choices.end())
            continue;
        choices.push_back(choice);
        any = true;
    }
    return any;
}

/// Fills a part at one state, ever more of it, where bending alone does not end well.
class FillingTries {
public:
    FillingTries(const PinnedShape& part, const MoldState& state, Tries& tries, DesignRun& run)
        : m_part(part), m_state(state), m_tries(tries), m_run(run), m_task(run.task().part(0.95, 1)) {}

    /// As little as needed: the less is filled, the more of the part is kept. `passes`: nothing is needed at
    /// this state.
    void fillLittle(bool passes) {
        const FillExtent least = passes ? FillExtent::Chosen : FillExtent::Needed;
        if (!passes && !m_run.stopped())
            fill({least, m_run.request().undercuts});
        fillAtLostLimbs(least);
    }

    void fillAll() {
        if (!m_run.stopped())
            fill({FillExtent::All, m_run.request().undercuts});
    }

private:
    void fill(const Filling& filling) {
        tryQuickly({m_part.shape.get(), m_state, filling, Means::QuickProxy, m_part.pins}, m_tries, m_task,
                   m_run);
        // Filling all takes a moment; what is far from ending well is not bent again and again before that.
        if (m_tries.castable() && limbsLost(*m_tries.best) > kHopeless)
            m_tries.again.clear();
        tryAgain(m_tries, m_task, m_run);
    }

    /// Limbs that bending gave up are kept where they are, and the rest is bent: less than filling all.
    void fillAtLostLimbs(FillExtent least) {
        if (!m_tries.castable() || !m_tries.wantsFilling() || m_run.stopped())
            return;
        const auto undercuts = fillableUndercuts(*m_part.shape, m_state, m_task);
        // What the designer chose stands last and counts.
        std::vector<UndercutChoice> atLimbs;
        for (int round = 0; undercuts && round < kLimbRounds && m_tries.wantsFilling() && !m_run.stopped();
             ++round) {
            if (!chooseAtLostLimbs(*m_tries.best, *undercuts, *m_part.shape, atLimbs))
                break;
            std::vector<UndercutChoice> choices = atLimbs;
            choices.insert(choices.end(), m_run.request().undercuts.begin(), m_run.request().undercuts.end());
            fill({least, choices});
        }
    }

    const PinnedShape& m_part;
    const MoldState& m_state;
    Tries& m_tries;
    DesignRun& m_run;
    Task m_task;
};

/// Fills where bending alone does not end well, or no plane that was worth bending at passes. Where even that
/// costs more than filling all at another plane, that plane is tried too.
void tryFilling(const PinnedShape& pinned, const MoldStates& states, Tries& tries, DesignRun& run) {
    const bool passes = tries.first && !states.onlyOthersPassed();
    if (passes && !tries.wantsFilling())
        return;
    const MoldState best = passes ? *tries.first : states.best();
    FillingTries atBest(pinned, best, tries, run);
    atBest.fillLittle(passes);
    const FillableState other = states.leastToFill();
    const auto costsMore = [&] { return !tries.castable() || givenUp(*tries.best) > other.filled; };
    if (other.state.plane != best.plane && costsMore()) {
        FillingTries elsewhere(pinned, other.state, tries, run);
        elsewhere.fillLittle(false);
        if (costsMore())
            elsewhere.fillAll();
    }
    if (tries.wantsFilling())
        atBest.fillAll();
}

void tellObstructions(DesignResult& result, ObstructedPart obstructed, const WorkingFrame& frame) {
    result.obstructions = std::move(obstructed.obstructions);
    result.parted = std::make_shared<const IndexedMesh>(frame.toPart(obstructed.surface.mesh));
    result.partedLabels = std::move(obstructed.surface.labels);
}

Error drawnThroughItself(const IndexedMesh& part, int face) {
    const Eigen::Vector3d place = (part.corner(face, 0) + part.corner(face, 1) + part.corner(face, 2)) / 3;
    return {ErrorCode::Impossible,
            {MW_TEXT("design", "The pins draw the part through itself at ({0}, {1}, {2}). Leave one of them "
                               "out, or give another plane."),
             {readable(place.x(), 3), readable(place.y(), 3), readable(place.z(), 3)}},
            {},
            {place}};
}

Result<WorkingBody> bodyWithPins(const MoldState& state, DesignRun& run) {
    const DesignRequest& request = run.request();
    const Stopwatch watch(run.seconds(), "tetrahedralize");
    return workingBody(*run.start(), state, carriedPins(request.pins, *request.part, *run.start()),
                       request.faceWeights, run.task());
}

/// Pins first bend the whole part, unsplit, until they lie in the plane; what they make meet lies side by
/// side: [Stein 2019], Section 6.1.
Result<PinnedShape> pinned(const MoldState& state, DesignRun& run) {
    const Result<WorkingBody> body = bodyWithPins(state, run);
    if (!body)
        return std::unexpected(body.error());
    const Stopwatch watch(run.seconds(), "elastoplastic");
    const auto before = std::make_shared<const Points>(run.request().part->V);
    const auto seen = [&](const Positions& X) {
        const IndexedMesh shape = body->surfaceAt(X);
        run.setReached(shape, state);
        run.show({"pins", shape, {}, state, before});
        run.hear(false);
    };
    const Positions drawn = drawnIntoPlane(body->shape, body->pinned, run.task(), seen);
    if (run.stopped())
        return DesignRun::cancelled();
    const auto shape = std::make_shared<const IndexedMesh>(body->surfaceAt(drawn));
    if (const auto crossing = selfIntersections(*shape); !crossing.empty())
        return std::unexpected(drawnThroughItself(*run.request().part, crossing.front().first));
    return PinnedShape{shape, body->pinsAt(drawn)};
}

/// Bends a part, whose pins lie in the plane already, at the request's plane or the best ones.
Result<DesignResult> bendPart(const PinnedShape& pinned, DesignRun& run) {
    const IndexedMesh& shape = *pinned.shape;
    Result<MoldStates> states = MoldStates::create(shape, run);
    if (!states)
        return std::unexpected(states.error());
    Tries tries = tryStates(pinned, *states, run);
    if (run.request().fill == FillChoice::Auto)
        tryFilling(pinned, *states, tries, run);
    if (!tries.best && run.stopped())
        return DesignRun::cancelled();
    const MoldState state = tries.best ? tries.best->state : states->best();
    ObstructedPart obstructed;
    if (!run.stopped() && (!tries.first || (tries.best && tries.best->change.filledVolumeFraction > 0)))
        obstructed = obstructionsAt(shape, state, run.request().undercuts, run.task());
    if (obstructed.obstructions.empty())
        return tries.best ? Result<DesignResult>(*tries.best) : std::unexpected(*tries.lastError);
    offerRemedies(obstructed, shape, state, run);
    if (!tries.best) {
        tries.best.emplace();
        tries.best->state = state;
        tries.best->certificate.reason = obstructed.obstructions.front().message.english();
    }
    tellObstructions(*tries.best, std::move(obstructed), WorkingFrame(shape, state));
    return *tries.best;
}

/// Pins without a plane: one after the other, at planes that suit them, until one ends well.
Result<DesignResult> bendAtPlaneForPins(DesignRun& run) {
    std::optional<DesignResult> best;
    std::optional<Error> lastError;
    for (const PartingPlane& plane : planesForPins(run, kPlanesForPins)) {
        DesignRun there = run.at(plane);
        Result<DesignResult> result = designByBending(there);
        for (const auto& [stage, seconds] : there.seconds())
            run.seconds()[stage] += seconds;
        run.takeSettings(there);
        if (!result)
            lastError = result.error();
        else if (!best || better(*result, *best))
            best = std::move(*result);
        if (run.stopped() || (best && best->castable && givenUp(*best) == 0))
            break;
    }
    if (best)
        return *best;
    return lastError && !run.stopped() ? std::unexpected(*lastError) : DesignRun::cancelled();
}

} // namespace

Result<DesignResult> designByBending(DesignRun& run) {
    const DesignRequest& request = run.request();
    if (request.pins.empty())
        return bendPart({run.start(), {}}, run);
    if (!request.plane)
        return bendAtPlaneForPins(run);
    const Result<PinnedShape> drawn =
        pinned({*request.plane, run.directionsFor(*run.start(), *request.plane)}, run);
    return drawn ? bendPart(*drawn, run) : std::unexpected(drawn.error());
}

} // namespace moldwright
