// SPDX-License-Identifier: AGPL-3.0-or-later
// Suggested pins: how long the designer waits for them.
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "pins/cgal/delaunay.h"
#include "pins/suggested_pins.h"

using namespace moldwright;
using namespace moldwright::bench;

/// All of the search; beside it the Delaunay triangulation of the part's points alone, without which no
/// medial axis is had.
static void suggestedPins(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    Contest contest(state);
    std::size_t pins = 0;
    for (auto _ : state)
        contest.round([&] { pins = suggestPins(*subject.part, {}).value().pins.size(); },
                      [&] { benchmark::DoNotOptimize(delaunay(subject.part->V)); });
    contest.conclude("delaunay", "ms", 1e3);
    state.counters["pins"] = static_cast<double>(pins);
}
BENCHMARK(suggestedPins)->Apply(eachSubject)->Iterations(5);

/// Ranking them anew, as when the plane is dragged.
static void rankedPins(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    PinSuggestions found = suggestPins(*subject.part, {}).value();
    Best best(state);
    for (auto _ : state)
        best.round([&] { rankPins(found, *subject.part, subject.state, 1); });
}
BENCHMARK(rankedPins)->Apply(eachSubject)->Iterations(20);
