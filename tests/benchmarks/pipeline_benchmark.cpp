// SPDX-License-Identifier: AGPL-3.0-or-later
// The rest of the way from part to mold, piece by piece.
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "castability/certificate.h"
#include "castability/energy.h"
#include "castability/plane_search.h"
#include "castability/state_cost.h"
#include "exchange/tetrahedralize.h"
#include "mold/mold.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moldwright;
using namespace moldwright::bench;

/// 1000 planes with normal directions, energy and volume of each, in vector code on all threads; beside the
/// plain energy alone, face by face on all threads, of 50 of them. Times are per face and plane.
static void thousandPlanes(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    const double tau = std::sin(radians(1));
    const FaceArrays faces(*subject.part);
    const PartingPlane plane = subject.state.plane;
    std::vector<MoldState> states;
    for (int i = 0; i < 1000; ++i) {
        const PartingPlane moved{plane.normal, plane.offset + 0.01 * (i - 500)};
        states.push_back({moved, Directions::normalTo(moved)});
    }
    constexpr std::size_t few = 50;
    double ours = std::numeric_limits<double>::infinity();
    double plain = ours;
    for (auto _ : state) {
        ours = std::min(ours, secondsOf([&] { benchmark::DoNotOptimize(stateCosts(faces, states, tau)); }));
        plain =
            std::min(plain, secondsOf([&] {
                         for (std::size_t i = 0; i < few; ++i)
                             benchmark::DoNotOptimize(castabilityEnergy(*subject.part, states[i * 20], tau));
                     }));
        state.SetIterationTime(ours);
    }
    const double oursPerFace = ours / 1000 / subject.part->faceCount();
    const double plainPerFace = plain / static_cast<double>(few) / subject.part->faceCount();
    state.counters["best_ms"] = 1e3 * ours;
    state.counters["ns_per_face"] = 1e9 * oursPerFace;
    state.counters["plain_ns_per_face"] = 1e9 * plainPerFace;
    state.counters["ratio"] = oursPerFace / plainPerFace;
}
BENCHMARK(thousandPlanes)->Apply(eachSubject)->Iterations(5);

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
                    buildMold(trayOf({designed.cast, designed.labels, designed.state}), 1, MoldSettings{}));
            },
            [&] { benchmark::DoNotOptimize(certify(*designed.cast, designed.labels, designed.state, 1)); });
    contest.conclude("certificate", "ms", 1e3);
}
BENCHMARK(certificateAndMold)->Apply(eachSubject)->Iterations(3);
