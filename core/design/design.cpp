// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/design.h"

#include "castability/analysis.h"
#include "castability/cast_analysis.h"
#include "castability/directions.h"
#include "castability/float_rounding.h"
#include "castability/plane_search.h"
#include "design/castable_shape.h"
#include "design/comparison.h"
#include "design/elastoplastic.h"
#include "design/parting.h"
#include "design/stopwatch.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldwright {

namespace {

constexpr int kCandidatePlanes = 60; ///< searched for one that passes the topological certificate
constexpr int kPlanesTried = 3;      ///< deformed in turn until one ends castable
constexpr int kRoundingAttempts = 3; ///< finishes with ever coarser clean-up until floats keep the draft
constexpr int kPlasticSteps = 40;    ///< at most, of the paper's method
constexpr int kPinSteps = 12;        ///< plastic steps that bring pins to the plane before the part is split

std::unexpected<Error> cancelled() {
    return failure(ErrorCode::Cancelled, MW_TEXT("design", "The design was cancelled."));
}

/// Size of a float's rounding step at the part's largest coordinate, mm.
double floatStep(const IndexedMesh& part) {
    const double largest = part.V.cwiseAbs().maxCoeff();
    return largest * std::numeric_limits<float>::epsilon();
}

DesignFrame frameOf(const char* stage, IndexedMesh shape, const SideLabels& labels, const MoldState& state,
                    int step, double draftDegrees) {
    const DraftAnalysis analysis = labels.empty() ? analyzeDraft(shape, state, draftDegrees, false)
                                                  : analyzeCast(shape, labels, state, draftDegrees);
    return {stage,
            std::make_shared<const IndexedMesh>(std::move(shape)),
            labels,
            state,
            step,
            analysis.energy,
            analysis.worstDraftDegrees,
            analysis.violatingAreaFraction};
}

/// One run of Algorithm 1: holds what its stages share.
class Run {
public:
    Run(const DesignRequest& request, const Task& task, const FrameSink& frames)
        : m_request(request), m_task(task), m_frames(frames) {}

    Result<DesignResult> start() {
        if (m_request.method == DeformationMethod::Paper)
            return runPaper();
        return runDefault();
    }

private:
    [[nodiscard]] Directions directionsFor(const IndexedMesh& shape, const PartingPlane& plane) {
        const Stopwatch watch(m_result.seconds, "directions_first");
        switch (m_request.directionsChoice) {
        case DirectionsChoice::Given:
            return m_request.directions;
        case DirectionsChoice::Normal:
            return Directions::normalTo(plane);
        default:
            return bestDirections(shape, plane, m_request.draftDegrees, m_request.maxTiltDegrees);
        }
    }

    /// The states to try, best first: the given plane alone, or the best planes that pass the topological
    /// certificate. None pass: empty, and the result holds the obstructions.
    Result<std::vector<MoldState>> statesToTry(const IndexedMesh& shape) {
        if (m_request.plane) {
            const MoldState state{*m_request.plane, directionsFor(shape, *m_request.plane)};
            m_result.state = state;
            m_result.obstructions = obstructionsAt(shape, state);
            return m_result.obstructions.empty() ? std::vector{state} : std::vector<MoldState>{};
        }
        const Stopwatch watch(m_result.seconds, "plane");
        PlaneSearch search;
        search.count = kCandidatePlanes;
        search.draftDegrees = m_request.draftDegrees;
        search.maxTiltDegrees = m_request.maxTiltDegrees;
        search.normalDirections = m_request.directionsChoice == DirectionsChoice::Normal;
        search.seed = m_request.seed;
        std::vector<MoldState> passing;
        const std::vector<PlaneCandidate> candidates = findPlanes(shape, search, m_task.part(0, 0.1));
        for (const PlaneCandidate& candidate : candidates) {
            if (m_task.stopped())
                return cancelled();
            MoldState state = candidate.state;
            if (m_request.directionsChoice != DirectionsChoice::Normal)
                state.directions = directionsFor(shape, state.plane);
            if (planePasses(shape, state))
                passing.push_back(state);
            if (static_cast<int>(passing.size()) == kPlanesTried)
                break;
        }
        if (m_task.stopped() || candidates.empty())
            return cancelled();
        if (passing.empty()) {
            m_result.state = candidates.front().state;
            m_result.obstructions = obstructionsAt(shape, m_result.state);
        }
        return passing;
    }

    /// The published deformation of the whole part, with the request's pins and importance.
    Result<Elastoplastic> solverAt(const MoldState& state) {
        ElastoplasticSettings settings;
        settings.draftDegrees = m_request.draftDegrees;
        settings.maxTiltDegrees = m_request.maxTiltDegrees;
        settings.optimizeDirections = m_request.directionsChoice == DirectionsChoice::Automatic;
        const Stopwatch watch(m_result.seconds, "tetrahedralize");
        Result<Elastoplastic> solver = Elastoplastic::create(m_request.part, state, settings, m_task);
        if (!solver)
            return solver;
        solver->setPins(m_request.pins);
        if (!m_request.faceWeights.empty())
            solver->setFaceWeights(m_request.faceWeights);
        return solver;
    }

    /// Pins first pull the whole part, unsplit, until they lie in the plane: [Stein 2019], Section 6.1.
    Result<SharedMesh> pinned(const MoldState& state) {
        Result<Elastoplastic> solver = solverAt(state);
        if (!solver)
            return std::unexpected(solver.error());
        for (int step = 0; step < kPinSteps && !m_task.stopped(); ++step) {
            solver->step(m_task);
            show("pins", solver->shape(), {}, solver->state());
        }
        m_result.plasticSteps = solver->steps();
        m_result.localGlobalIterations = solver->iterations();
        if (m_task.stopped())
            return cancelled();
        return std::make_shared<const IndexedMesh>(solver->shape());
    }

    Result<DesignResult> runDefault() {
        SharedMesh shape = m_request.part;
        if (!m_request.pins.empty() && m_request.plane) {
            const MoldState state{*m_request.plane, directionsFor(*shape, *m_request.plane)};
            const Result<SharedMesh> bent = pinned(state);
            if (!bent)
                return std::unexpected(bent.error());
            shape = *bent;
        }
        const Result<std::vector<MoldState>> states = statesToTry(*shape);
        if (!states)
            return std::unexpected(states.error());
        if (states->empty()) {
            m_result.certificate.reason = m_result.obstructions.front().message.english();
            return m_result;
        }
        std::optional<Error> lastError;
        std::optional<DesignResult> best;
        for (std::size_t i = 0; i < states->size(); ++i) {
            const double share = 0.9 / static_cast<double>(states->size());
            const Task part =
                m_task.part(0.1 + static_cast<double>(i) * share, 0.1 + static_cast<double>(i + 1) * share);
            const Result<DesignResult> result = tryState(*shape, (*states)[i], part);
            if (m_task.stopped())
                return cancelled();
            if (!result) {
                lastError = result.error();
                continue;
            }
            if (result->castable)
                return result;
            if (!best || result->violatingAreaFraction < best->violatingAreaFraction)
                best = *result;
        }
        if (best)
            return *best;
        return std::unexpected(*lastError);
    }

    Result<DesignResult> tryState(const IndexedMesh& shape, const MoldState& state, const Task& task) {
        DesignResult result = m_result;
        Result<PartedSolid> solid = [&] {
            const Stopwatch watch(m_result.seconds, "tetrahedralize");
            return partSolid(shape, state, task);
        }();
        if (!solid)
            return std::unexpected(solid.error());
        result.state = state;
        result.tets = static_cast<int>(solid->tets.T.rows());
        ShapeGoal goal{m_request.draftDegrees, m_request.faceWeights, floatStep(shape), m_request.finishNow};
        for (int attempt = 0; attempt < kRoundingAttempts; ++attempt, goal.resolution *= 4) {
            const CastableShape bent = bend(*solid, goal, task);
            result.localGlobalIterations += bent.iterations;
            if (m_task.stopped())
                return cancelled();
            takeCast(result, *solid, bent);
            if (result.castable || !bent.reached)
                break;
        }
        result.seconds = m_result.seconds;
        return result;
    }

    CastableShape bend(const PartedSolid& solid, const ShapeGoal& goal, const Task& task) {
        const Stopwatch watch(m_result.seconds, "elastoplastic");
        // Without anyone to see them, frames would be copied for nothing.
        if (!m_frames)
            return bendToCastable(solid, goal, task, {});
        return bendToCastable(solid, goal, task, [&](const char* stage, const LabelledSurface& surface) {
            show(stage, solid.frame.toPart(surface.mesh), surface.labels, solid.state);
        });
    }

    /// Rounds to floats, proves, measures.
    void takeCast(DesignResult& result, const PartedSolid& solid, const CastableShape& bent) {
        const Stopwatch watch(m_result.seconds, "postprocess");
        const IndexedMesh rounded =
            roundKeepingDraft(solid.frame.toPart(bent.surface.mesh), bent.surface.labels,
                              solid.state.directions, m_request.draftDegrees);
        result.labels = bent.surface.labels;
        result.certificate = certify(rounded, result.labels, solid.state, m_request.draftDegrees);
        result.castable = result.certificate.holds();
        const DraftAnalysis analysis = analyzeDraft(rounded, solid.state, m_request.draftDegrees, false);
        result.energy = analysis.energy;
        // On an oblique plane rounded points lie a hair off it and analysis sees two pieces: the proof has
        // the last word.
        result.violatingAreaFraction = result.castable ? 0 : analysis.violatingAreaFraction;
        const IndexedMesh parted = solid.frame.toPart(solid.surface.mesh);
        result.change = measureChange(*m_request.part, parted, rounded, bent.surface.sourceVertex);
        result.limbs = measureLimbs(parted, rounded, bent.surface.sourceVertex, m_request.limbTips);
        result.cast = std::make_shared<const IndexedMesh>(rounded);
    }

    /// The paper's method as described: nothing split, restarts, post-processing. It seldom ends castable.
    Result<DesignResult> runPaper() {
        const Result<MoldState> state = paperState();
        if (!state)
            return std::unexpected(state.error());
        Result<Elastoplastic> solver = solverAt(*state);
        if (!solver)
            return std::unexpected(solver.error());
        plasticSteps(*solver);
        if (m_task.stopped())
            return cancelled();
        return judgePaper(*solver);
    }

    Result<MoldState> paperState() {
        if (m_request.plane)
            return MoldState{*m_request.plane, directionsFor(*m_request.part, *m_request.plane)};
        const Stopwatch watch(m_result.seconds, "plane");
        PlaneSearch search;
        search.count = 1;
        search.draftDegrees = m_request.draftDegrees;
        search.maxTiltDegrees = m_request.maxTiltDegrees;
        search.seed = m_request.seed;
        const std::vector<PlaneCandidate> planes = findPlanes(*m_request.part, search, m_task.part(0, 0.1));
        if (planes.empty())
            return cancelled();
        return planes.front().state;
    }

    /// Runs until the violating area stalls: it falls by less than a thousandth of itself in five steps.
    void plasticSteps(Elastoplastic& solver) {
        std::vector<double> history;
        for (int step = 0; step < kPlasticSteps && !m_task.stopped(); ++step) {
            {
                const Stopwatch watch(m_result.seconds, step == 0 ? "arap_first" : "elastoplastic");
                solver.step(m_task);
            }
            m_task.progress(0.1 + 0.8 * step / kPlasticSteps, "deformation");
            const DraftAnalysis analysis =
                analyzeDraft(solver.shape(), solver.state(), m_request.draftDegrees, false);
            show("deformation", solver.shape(), {}, solver.state());
            history.push_back(analysis.energy);
            const bool enough = m_request.finishNow && m_request.finishNow();
            if (enough || analysis.castable() ||
                (history.size() > 5 && history.back() > 0.999 * history[history.size() - 6]))
                break;
        }
        m_result.seconds["elastoplastic"] += m_result.seconds["arap_first"];
    }

    DesignResult judgePaper(const Elastoplastic& solver) {
        const Stopwatch watch(m_result.seconds, "postprocess");
        IndexedMesh cast =
            postProcess(solver.shape(), solver.state(), m_request.draftDegrees, m_task.part(0.9, 1));
        cast.V = cast.V.cast<float>().cast<double>();
        m_result.state = solver.state();
        m_result.tets = solver.tets();
        m_result.plasticSteps = solver.steps();
        m_result.localGlobalIterations = solver.iterations();
        m_result.labels = labelSides(cast, m_result.state.plane);
        m_result.certificate = certify(cast, m_result.labels, m_result.state, m_request.draftDegrees);
        m_result.castable = m_result.certificate.holds();
        const DraftAnalysis analysis = analyzeDraft(cast, m_result.state, m_request.draftDegrees, false);
        m_result.energy = analysis.energy;
        m_result.violatingAreaFraction = analysis.violatingAreaFraction;
        std::vector<int> same(static_cast<std::size_t>(cast.vertexCount()));
        for (std::size_t v = 0; v < same.size(); ++v)
            same[v] = static_cast<int>(v);
        m_result.change = measureChange(*m_request.part, *m_request.part, cast, same);
        m_result.limbs = measureLimbs(*m_request.part, cast, same, m_request.limbTips);
        m_result.cast = std::make_shared<const IndexedMesh>(std::move(cast));
        return m_result;
    }

    void show(const char* stage, IndexedMesh shape, const SideLabels& labels, const MoldState& state) {
        if (m_frames)
            m_frames(frameOf(stage, std::move(shape), labels, state, ++m_step, m_request.draftDegrees));
    }

    const DesignRequest& m_request;
    Task m_task;
    const FrameSink& m_frames;
    DesignResult m_result; ///< what is known so far
    int m_step = 0;
};

} // namespace

Result<DesignResult> design(const DesignRequest& request, const Task& task, const FrameSink& frames) {
    return Run(request, task, frames).start();
}

} // namespace moldwright
