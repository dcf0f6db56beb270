// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/paper_method.h"

#include "castability/analysis.h"
#include "castability/plane_search.h"
#include "design/carried_pins.h"
#include "design/comparison.h"
#include "design/elastoplastic.h"
#include "design/stopwatch.h"

#include <cmath>
#include <numeric>

namespace moldwright {

namespace {

constexpr int kPlasticSteps = 40; ///< at most

Result<MoldState> stateFor(DesignRun& run) {
    const DesignRequest& request = run.request();
    if (request.plane)
        return MoldState{*request.plane, run.directionsFor(*run.start(), *request.plane)};
    const Stopwatch watch(run.seconds(), "plane");
    const std::vector<PlaneCandidate> planes =
        findPlanes(*request.part, run.planeSearch(1), run.task().part(0, 0.1));
    if (planes.empty())
        return DesignRun::cancelled();
    return planes.front().state;
}

ElastoplasticSettings settingsOf(const LiveSettings& live) {
    ElastoplasticSettings settings;
    settings.smoothing = live.smoothing;
    settings.draftDegrees = live.draftDegrees;
    settings.limits = live.limits;
    settings.optimizeDirections = live.directionsChoice == DirectionsChoice::Automatic;
    return settings;
}

Result<Elastoplastic> elastoplasticAt(const MoldState& state, DesignRun& run) {
    const DesignRequest& request = run.request();
    const std::vector<Pin> pins = carriedPins(request.pins, *request.part, *run.start());
    const Stopwatch watch(run.seconds(), "tetrahedralize");
    return Elastoplastic::create(*run.start(), state, settingsOf(request), run.task(), pins,
                                 request.faceWeights);
}

/// Has the deformation take what the designer changed since the last step, or ends the leg: see
/// DesignRun::hear(). Returns whether it took anything.
bool hearChanges(Elastoplastic& solver, DesignRun& run) {
    if (!run.hear(true))
        return false;
    const LiveSettings& now = run.request();
    solver.change(settingsOf(now), run.directionsFor(solver.shape(), solver.state().plane));
    solver.setFaceWeights(now.faceWeights);
    return true;
}

void showStep(const Elastoplastic& solver, DesignRun& run) {
    IndexedMesh shape = solver.shape();
    run.setReached(shape, solver.state());
    run.show({"deformation",
              std::move(shape),
              {},
              solver.state(),
              std::make_shared<const Points>(run.request().part->V)});
}

/// Runs until the violating area stalls: it falls by less than a thousandth of itself in five steps.
void plasticSteps(Elastoplastic& solver, DesignRun& run) {
    const DesignRequest& request = run.request();
    if (analyzeDraft(solver.shape(), solver.state(), request.draftDegrees, false).castable())
        return;
    std::vector<double> history;
    for (int step = 0; step < kPlasticSteps && !run.stopped(); ++step) {
        {
            const Stopwatch watch(run.seconds(), step == 0 ? "arap_first" : "elastoplastic");
            solver.step(run.task());
        }
        run.task().progress(0.1 + 0.8 * step / kPlasticSteps, "deformation");
        const DraftAnalysis analysis =
            analyzeDraft(solver.shape(), solver.state(), request.draftDegrees, false);
        showStep(solver, run);
        if (hearChanges(solver, run)) {
            history.clear();
            step = 0;
            continue;
        }
        history.push_back(analysis.energy);
        const bool enough = run.finishAsked();
        if (enough || analysis.castable() ||
            (history.size() > 5 && history.back() > 0.999 * history[history.size() - 6]))
            break;
    }
    run.seconds()["elastoplastic"] += run.seconds()["arap_first"];
}

DesignResult judged(const Elastoplastic& solver, DesignRun& run) {
    const Stopwatch watch(run.seconds(), "postprocess");
    const DesignRequest& request = run.request();
    const std::vector<PlacedPin> pins = solver.pins();
    IndexedMesh cast =
        postProcess(solver.shape(), solver.state(), request.draftDegrees, run.task().part(0.9, 1), pins);
    cast.V = cast.V.cast<float>().cast<double>();
    DesignResult result;
    result.state = solver.state();
    result.tets = solver.tets();
    result.plasticSteps = solver.steps();
    result.localGlobalIterations = solver.iterations();
    result.labels = labelSides(cast, result.state.plane);
    result.certificate = certify(cast, result.labels, result.state, request.draftDegrees);
    result.castable = result.certificate.holds();
    const DraftAnalysis analysis = analyzeDraft(cast, result.state, request.draftDegrees, false);
    result.energy = analysis.energy;
    result.violatingAreaFraction = analysis.violatingAreaFraction;
    std::vector<int> same(static_cast<std::size_t>(cast.vertexCount()));
    std::iota(same.begin(), same.end(), 0);
    result.change = measureChange(*request.part, *request.part, cast, same);
    result.strain = surfaceStrain(*request.part, cast, same);
    std::vector<int> sameFace(static_cast<std::size_t>(cast.faceCount()));
    std::iota(sameFace.begin(), sameFace.end(), 0);
    result.regions = measureRegions(request.regions, *request.part, sameFace, cast, same);
    for (const PlacedPin& pin : pins) {
        const Eigen::Vector3d place = pin.surfacePoint < 0 ? pin.place : cast.point(pin.surfacePoint);
        result.pins.push_back({place, std::abs(result.state.plane.distance(place))});
    }
    result.limbs = measureLimbs(*request.part, cast, same, request.limbTips);
    result.before = request.part->V;
    result.cast = std::make_shared<const IndexedMesh>(std::move(cast));
    return result;
}

} // namespace

Result<DesignResult> designAsPublished(DesignRun& run) {
    const Result<MoldState> state = stateFor(run);
    if (!state)
        return std::unexpected(state.error());
    Result<Elastoplastic> solver = elastoplasticAt(*state, run);
    if (!solver)
        return std::unexpected(solver.error());
    plasticSteps(*solver, run);
    if (run.next() || (run.stopped() && !run.request().keepUnfinished))
        return DesignRun::cancelled();
    DesignResult result = judged(*solver, run);
    result.cutShort = run.stopped();
    return result;
}

} // namespace moldwright
