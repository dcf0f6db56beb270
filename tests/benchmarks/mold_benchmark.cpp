// SPDX-License-Identifier: AGPL-3.0-or-later
// Mold halves as graphs over the plane beside a general boolean, and whole molds with every feature.
#include "benchmarks/corefinement.h"
#include "benchmarks/subjects.h"
#include "benchmarks/timing.h"

#include "castability/certificate.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mold/half.h"
#include "mold/mold.h"
#include "mold/mold_files.h"
#include "mold/mold_sketch.h"
#include "support/casts.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>

using namespace moldwright;
using namespace moldwright::bench;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kWall = 5; ///< mm

/// A ring on the plane with hills, of about so many faces; both sides are heights over the plane.
IndexedMesh hillyRing(int faces) {
    const int around = static_cast<int>(std::sqrt(faces * 1.6));
    IndexedMesh cast = test::ring(24, 12, around, 4 * ((faces / (2 * around) + 3) / 4)).mesh;
    for (int v = 0; v < cast.vertexCount(); ++v)
        cast.V(v, 2) *= 1 + 0.25 * std::sin(0.9 * cast.V(v, 0)) * std::cos(0.7 * cast.V(v, 1));
    cast.V = cast.V.cast<float>().cast<double>();
    return cast;
}

/// Copies of a cast in rows and columns with a block about them.
struct CopiedCast {
    IndexedMesh cast;
    std::vector<Vector2d> places;
    Eigen::AlignedBox3d block;

    CopiedCast(int faces, int side) : cast(hillyRing(faces)) {
        const Eigen::AlignedBox3d box = boundingBox(cast);
        const double pitch = std::ceil(box.sizes().head<2>().maxCoeff()) + kWall;
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j)
                places.emplace_back(i * pitch, j * pitch);
        for (const Vector2d& place : places)
            block.extend(box.translated(Vector3d(place.x(), place.y(), 0)));
        block.min() = (block.min().array() - kWall).floor();
        block.max() = (block.max().array() + kWall).ceil();
    }

    [[nodiscard]] std::array<IndexedMesh, 2> halves() const {
        std::array<IndexedMesh, 2> made;
        for (const int side : {1, 2}) {
            const auto shown = std::make_shared<const IndexedMesh>(
                sideOf(cast, side, side == 1 ? block.max().z() : block.min().z()));
            HalfSurfaces surfaces;
            for (const Vector2d& place : places)
                surfaces.voids.push_back({shown, place});
            made[side == 1 ? 0 : 1] = assembleHalf(side, surfaces, uprightBlock(block)).value();
        }
        return made;
    }

    [[nodiscard]] Corefinement peer() const {
        const Vector3d& low = block.min();
        const Vector3d& high = block.max();
        std::vector<PlacedSurface> all;
        const auto shared = std::make_shared<const IndexedMesh>(cast);
        for (const Vector2d& place : places)
            all.push_back({shared, place});
        return {{test::box({low.x(), low.y(), 0}, high), test::box(low, {high.x(), high.y(), 0})},
                sumOf(all).mesh};
    }
};

MoldSettings everythingOn(int side) {
    MoldSettings settings;
    settings.layout.rows = settings.layout.columns = side;
    settings.spout.on = settings.vents.on = true;
    settings.keys.count = settings.bolts.count = 4;
    settings.slits.count = 2;
    settings.ejectors.count = 1;
    settings.ejectors.diameter = 2;
    return settings;
}

} // namespace

/// From a cast to both halves of a block about copies of it. Corefinement is run once; of 16 cavities with
/// 300,000 faces each it would take minutes and gigabytes, so there ours stands alone.
static void moldHalves(benchmark::State& state) {
    const auto faces = static_cast<int>(state.range(0));
    const auto side = static_cast<int>(state.range(1));
    const CopiedCast tray(faces, side);
    state.counters["faces"] = tray.cast.faceCount();
    state.counters["cavities"] = side * side;
    Best best(state);
    std::array<IndexedMesh, 2> halves;
    for (auto _ : state)
        best.round([&] { halves = tray.halves(); });
    if (faces * side * side > 2'000'000)
        return;
    Corefinement peer = tray.peer();
    bool done = false;
    const double seconds = secondsOf([&] { done = peer.run(); });
    const double volumes = volume(halves[0]) + volume(halves[1]);
    if (!done || std::abs(peer.volume() - volumes) > 1e-9 * volumes)
        return state.SkipWithError("corefinement gives other halves");
    state.counters["corefinement_ms"] = 1e3 * seconds;
    state.counters["times_faster"] = seconds / best.seconds();
}
BENCHMARK(moldHalves)
    ->ArgsProduct({{30'000, 100'000, 300'000}, {1, 4}})
    ->ArgNames({"faces", "side"})
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// A design's mold with spouts, vents, keys, slits, bolts and ejector holes: built and proved; beside it the
/// search for self-intersections alone of what is written, which any proof of it must do.
static void moldWithEverything(benchmark::State& state) {
    const Subject& subject = subjectOf(state);
    const auto side = static_cast<int>(state.range(1));
    const DesignResult designed = designOf(subject);
    const Tray tray = trayOf({designed.cast, designed.labels, designed.state});
    Best best(state);
    double check = std::numeric_limits<double>::infinity();
    Result<Mold> mold = failure(ErrorCode::Internal, "not built");
    for (auto _ : state) {
        best.round([&] { mold = buildMold(tray, 1, everythingOn(side)); });
        if (!mold || !mold->verified())
            return state.SkipWithError(mold ? "not proved" : mold.error().english().c_str());
        check = std::min(check, secondsOf([&] {
                             for (const SharedMesh& mesh : {mold->half1.mesh, mold->half2.mesh, mold->cast})
                                 benchmark::DoNotOptimize(selfIntersections(*mesh));
                         }));
    }
    const test::ScratchFolder folder;
    const double writing =
        secondsOf([&] { benchmark::DoNotOptimize(writeMold(*mold, "part", folder.path())); });
    state.counters["faces"] = static_cast<double>(designed.cast->faceCount());
    state.counters["cavities"] = side * side;
    state.counters["written_ms"] = 1e3 * writing;
    state.counters["over_check"] = best.seconds() / check;
}
BENCHMARK(moldWithEverything)
    ->ArgsProduct({{1, 2, 3}, {1, 4}})
    ->ArgNames({"row", "side"})
    ->Iterations(2)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// One step of a drag: a spout, or a key, put elsewhere by hand in a mold with every feature, and where all
/// of them stand then with the steel between each pair.
static void liveDrag(benchmark::State& state) {
    const auto faces = static_cast<int>(state.range(0));
    const auto side = static_cast<int>(state.range(1));
    const bool spout = state.range(2) == 0;
    const auto cast = std::make_shared<const IndexedMesh>(hillyRing(faces));
    const SideLabels labels = labelSides(*cast, {});
    const MoldSettings settings = everythingOn(side);
    Result<MoldSketcher> sketcher = failure(ErrorCode::Internal, "not prepared");
    const double preparing =
        secondsOf([&] { sketcher = MoldSketcher::prepared(trayOf({cast, labels, {}}), 1, settings); });
    if (!sketcher)
        return state.SkipWithError(sketcher.error().english().c_str());
    const Result<MoldSketch> start = sketcher->sketch({});
    if (!start)
        return state.SkipWithError(start.error().english().c_str());
    PlacedFeature dragged{spout ? Placeable::Spout : Placeable::Key, 0, {}};
    for (const MoldFeature& feature : start->features)
        if (feature.stands && feature.stands->kind == dragged.kind && feature.stands->number == 0)
            dragged.place = feature.stands->place;
    Best best(state);
    double worst = 0;
    for (auto _ : state) {
        dragged.place.x() += 0.1;
        Result<MoldSketch> sketch = failure(ErrorCode::Internal, "not sketched");
        best.round(
            [&] { worst = std::max(worst, secondsOf([&] { sketch = sketcher->sketch({dragged}); })); });
        if (!sketch)
            return state.SkipWithError(sketch.error().english().c_str());
    }
    state.counters["faces"] = cast->faceCount();
    state.counters["cavities"] = side * side;
    state.counters["worst_ms"] = 1e3 * worst;
    state.counters["updates_per_s"] = 1 / worst;
    state.counters["prepared_ms"] = 1e3 * preparing;
}
BENCHMARK(liveDrag)
    ->ArgsProduct({{100'000, 300'000}, {1, 4}, {0, 1}})
    ->ArgNames({"faces", "side", "key"})
    ->Iterations(10)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
