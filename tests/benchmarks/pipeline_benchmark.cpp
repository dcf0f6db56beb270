// SPDX-License-Identifier: AGPL-3.0-or-later
// The rest of the way from part to mold, piece by piece.
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "castability/certificate.h"
#include "castability/energy.h"
#include "castability/plane_search.h"
#include "exchange/tetrahedralize.h"
#include "mold/mold.h"

#include <cmath>

using namespace moldwright;
using namespace moldwright::bench;

/// Energy and its derivatives with respect to the state.
static void castabilityEnergyAndGradient(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    const double tau = std::sin(radians(1));
    Best best(state);
    for (auto _ : state) {
        StateGradient gradient;
        best.round([&] {
            benchmark::DoNotOptimize(castabilityEnergy(*subject.part, subject.state, tau, gradient));
        });
    }
    state.counters["ns_per_face"] = 1e9 * best.seconds() / subject.part->faceCount();
}
BENCHMARK(castabilityEnergyAndGradient)->Apply(eachSubject)->MinTime(0.1);

/// The six best planes of 1000 samples.
static void planeSearch(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    Best best(state);
    for (auto _ : state)
        best.round([&] { benchmark::DoNotOptimize(findPlanes(*subject.part, PlaneSearch{})); });
}
BENCHMARK(planeSearch)->Apply(eachSubject)->MinTime(0.1);

/// TetGen in its worker program, starting it and checking its answer included.
static void tetGen(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    const IndexedMesh surface = subject.frame.toWork(*subject.part);
    Best best(state);
    for (auto _ : state)
        best.round([&] { benchmark::DoNotOptimize(tetrahedralize(surface)); });
}
BENCHMARK(tetGen)->Apply(eachSubject)->Iterations(3);

/// Both mold halves around a designed cast, built and proved; the exact proof of the cast alone beside it.
static void certificateAndMold(benchmark::State& state) {
    const DesignResult designed = designOf(subjectOf(state));
    if (!designed.castable) {
        state.SkipWithError("the design is not castable");
        return;
    }
    Contest contest(state);
    for (auto _ : state)
        contest.round(
            [&] {
                benchmark::DoNotOptimize(
                    buildMold(*designed.cast, designed.labels, designed.state, 1, MoldSettings{}));
            },
            [&] { benchmark::DoNotOptimize(certify(*designed.cast, designed.labels, designed.state, 1)); });
    contest.conclude("certificate", "ms", 1e3);
}
BENCHMARK(certificateAndMold)->Apply(eachSubject)->Iterations(3);
