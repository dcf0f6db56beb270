// SPDX-License-Identifier: AGPL-3.0-or-later
// How long a run stands still when the designer changes something in it.
#include "benchmarks/subjects.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <vector>

using namespace moldwright;
using namespace moldwright::bench;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kChangedAfter = 8; ///< steps
constexpr int kWatched = 40;     ///< steps that heed the change

/// What comes to the view, and when.
struct Seen {
    Clock::time_point when;
    bool changed;
};

double milliseconds(Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

/// The frames of a run that is changed after some steps, and stopped some steps later.
std::vector<Seen> framesAround(const Subject& subject, const std::function<void(LiveSettings&)>& change) {
    DesignRequest request;
    request.part = subject.part;
    request.plane = subject.state.plane;
    LiveSettings live = request;
    std::vector<Seen> seen;
    request.newest = [&]() -> std::optional<LiveSettings> {
        if (seen.size() < kChangedAfter)
            return std::nullopt;
        LiveSettings changed = live;
        change(changed);
        return changed;
    };
    request.bendMeanwhile = [] { return true; };
    LiveSettings wanted = live;
    change(wanted);
    const Task task;
    int heeding = 0;
    (void)design(request, task, [&](const DesignFrame& frame) {
        seen.push_back({Clock::now(), frame.settings == wanted});
        heeding += seen.back().changed;
        if (heeding >= kWatched)
            task.cancel();
    });
    return seen;
}

/// Counters: `heard_ms` until the first frame that follows the change, `longest_ms` the longest stand-still
/// from the change on, `step_ms` between frames before it.
void report(benchmark::State& state, const std::function<void(const Subject&, LiveSettings&)>& change) {
    const Subject& subject = subjectOf(state);
    for (auto _ : state) {
        const auto seen = framesAround(subject, [&](LiveSettings& live) { change(subject, live); });
        if (seen.size() <= kChangedAfter)
            continue; // castable before
        const Clock::time_point changed = seen[kChangedAfter - 1].when;
        const auto heard = std::ranges::find(seen, true, &Seen::changed);
        double longest = 0;
        for (std::size_t i = kChangedAfter; i < seen.size(); ++i)
            longest = std::max(longest, milliseconds(seen[i].when - seen[i - 1].when));
        state.counters["step_ms"] = milliseconds(changed - seen.front().when) / (kChangedAfter - 1);
        state.counters["longest_ms"] = longest;
        if (heard != seen.end())
            state.counters["heard_ms"] = milliseconds(heard->when - changed);
        state.SetIterationTime(longest / 1e3);
    }
}

} // namespace

static void changedDraft(benchmark::State& state) {
    report(state, [](const Subject&, LiveSettings& live) { live.draftDegrees = 3; });
}
BENCHMARK(changedDraft)->Apply(eachSubject)->Iterations(1);

static void changedPlane(benchmark::State& state) {
    report(state, [](const Subject& subject, LiveSettings& live) {
        live.plane = subject.state.plane;
        live.plane->offset += 0.5;
    });
}
BENCHMARK(changedPlane)->Apply(eachSubject)->Iterations(1);

/// Pins the point farthest from the plane.
static void changedPins(benchmark::State& state) {
    report(state, [](const Subject& subject, LiveSettings& live) {
        int farthest = 0;
        const Points& V = subject.part->V;
        for (int v = 0; v < subject.part->vertexCount(); ++v)
            if (std::abs(subject.state.plane.distance(V.row(v))) >
                std::abs(subject.state.plane.distance(V.row(farthest))))
                farthest = v;
        live.pins = {{V.row(farthest)}};
    });
}
BENCHMARK(changedPins)->Apply(eachSubject)->Iterations(1);
