// SPDX-License-Identifier: AGPL-3.0-or-later
// The three columns of [Stein 2019], Table 1.
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "castability/directions.h"
#include "design/elastoplastic.h"

using namespace moldwright;
using namespace moldwright::bench;

static void firstDirections(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    Best best(state);
    for (auto _ : state)
        best.round(
            [&] { benchmark::DoNotOptimize(bestDirections(*subject.part, subject.state.plane, 1, {30})); });
}
BENCHMARK(firstDirections)->Apply(eachSubject);

/// One plastic step with the directions given: 15 local-global iterations, restart, factorisation.
static void firstStep(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    ElastoplasticSettings settings;
    settings.optimizeDirections = false;
    Best best(state);
    for (auto _ : state) {
        Result<Elastoplastic> solver = Elastoplastic::create(*subject.part, subject.state, settings, {});
        if (!solver) {
            state.SkipWithError(solver.error().english().c_str());
            break;
        }
        best.round([&] { solver->step({}); });
    }
}
BENCHMARK(firstStep)->Apply(eachSubject)->Iterations(3);

/// From the shape to a proved castable one, the plane searched for: what design() does, stage by stage.
static void wholeDesign(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    Best best(state);
    for (auto _ : state) {
        DesignResult result;
        best.round([&] { result = designOf(subject); });
        for (const auto& [stage, seconds] : result.seconds)
            state.counters[stage + "_s"] = seconds;
        state.counters["castable"] = result.castable;
        state.counters["worst_draft_deg"] = result.certificate.worstDraftDegrees;
        state.counters["mean_change_percent"] = 100 * result.change.meanDistance;
    }
}
BENCHMARK(wholeDesign)->Apply(eachSubject)->Iterations(1);
