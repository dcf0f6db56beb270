// SPDX-License-Identifier: AGPL-3.0-or-later
// Filling what cannot leave the mold, at a plane that leaves much undercut.
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "castability/certificate.h"
#include "castability/float_rounding.h"
#include "castability/parting_line.h"
#include "deformation/finish.h"
#include "fill/fill_plan.h"
#include "mesh/check.h"
#include "mesh/measures.h"

using namespace moldwright;
using namespace moldwright::bench;

namespace {

/// The subject on the plane square to its y axis through its centre: none that a search would choose.
PartedMesh poorlyParted(const Subject& subject) {
    MoldState state;
    state.plane = {Eigen::Vector3d::UnitY(), boundingBox(*subject.part).center().y()};
    state.directions = Directions::normalTo(state.plane);
    return insertPartingLine(WorkingFrame(*subject.part, state).toWork(*subject.part), 0.1);
}

} // namespace

/// Both halves filled and checked; beside it the search for self-intersections alone, of the result, which is
/// what any check of it must cost.
static void fillAll(benchmark::State& state) {
    const PartedMesh parted = poorlyParted(subjectOf(state));
    Best best(state);
    double check = std::numeric_limits<double>::infinity();
    Result<FilledPart> filled = fill(parted, {});
    for (auto _ : state) {
        best.round([&] { filled = fill(parted, {}); });
        if (filled)
            check = std::min(
                check, secondsOf([&] { benchmark::DoNotOptimize(selfIntersections(filled->surface.mesh)); }));
    }
    if (!filled)
        return state.SkipWithError(filled.error().english().c_str());
    state.counters["faces"] = parted.mesh.faceCount();
    state.counters["filled_percent"] = 100 * filled->volume / volume(parted.mesh);
    state.counters["us_per_face"] = 1e6 * best.seconds() / parted.mesh.faceCount();
    state.counters["over_check"] = best.seconds() / check;
}
BENCHMARK(fillAll)->Apply(eachSubject)->Iterations(5);

/// Filled with walls that lean, what is left cleaned up, proved: from the parted part to the certificate.
static void fillDrafted(benchmark::State& state) {
    constexpr double kDraft = 1;
    const PartedMesh parted = poorlyParted(subjectOf(state));
    const double step = std::numeric_limits<float>::epsilon() * parted.mesh.V.cwiseAbs().maxCoeff();
    Best best(state);
    double vertical = std::numeric_limits<double>::infinity();
    Certificate certificate;
    for (auto _ : state) {
        vertical = std::min(vertical, secondsOf([&] { benchmark::DoNotOptimize(fill(parted, {})); }));
        best.round([&] {
            const Result<FilledPart> filled = fillWithDraft(parted, {}, kDraft);
            if (!filled)
                return;
            LabelledSurface surface{filled->surface.mesh, filled->surface.labels, filled->sourceVertex};
            finishSurface(surface, {{}, kDraft, step}, {}, {});
            certificate = certify(roundKeepingDraft(surface.mesh, surface.labels, {}, kDraft), surface.labels,
                                  {}, kDraft);
        });
    }
    if (!certificate.holds())
        return state.SkipWithError("not proved");
    state.counters["faces"] = parted.mesh.faceCount();
    state.counters["us_per_face"] = 1e6 * best.seconds() / parted.mesh.faceCount();
    state.counters["over_vertical"] = best.seconds() / vertical;
}
BENCHMARK(fillDrafted)->Apply(eachSubject)->Iterations(5);

/// The same with the regions that the topological certificate asks for.
static void fillPlanned(benchmark::State& state) {
    const PartedMesh parted = poorlyParted(subjectOf(state));
    Best best(state);
    Result<FillPlan> plan = planFill(parted, {});
    for (auto _ : state)
        best.round([&] { plan = planFill(parted, {}); });
    if (!plan)
        return state.SkipWithError(plan.error().english().c_str());
    state.counters["regions"] = static_cast<double>(plan->regions.size());
    state.counters["needed"] = static_cast<double>(plan->needed().size());
}
BENCHMARK(fillPlanned)->Apply(eachSubject)->Iterations(3);
