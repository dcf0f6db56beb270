// SPDX-License-Identifier: AGPL-3.0-or-later
// What the designer changes while a design runs is taken up, and the run goes on from where it is.
#include "design/carried_pins.h"
#include "design/design.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>

using namespace moldwright;

namespace {

/// A sausage bent up and aside like a banana, about 40 mm long: every level plane leaves undercuts.
SharedMesh banana() {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 3);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Eigen::Vector3d x = mesh.point(v).cwiseProduct(Eigen::Vector3d(20, 5, 5));
        mesh.V.row(v) << x.x(), x.y() + 0.008 * x.x() * x.x(), x.z() + 0.012 * x.x() * x.x();
    }
    return std::make_shared<const IndexedMesh>(mesh);
}

DesignRequest level() {
    DesignRequest request;
    request.part = banana();
    request.plane = PartingPlane{};
    return request;
}

/// The design of `request` when `change` is made after its step `step`.
Result<DesignResult> changedAt(int step, DesignRequest request,
                               const std::function<void(LiveSettings&)>& change,
                               std::vector<DesignFrame>* frames = nullptr) {
    const LiveSettings live = request;
    std::atomic<int> steps = 0;
    request.newest = [&]() -> std::optional<LiveSettings> {
        if (steps < step)
            return std::nullopt;
        LiveSettings changed = live;
        change(changed);
        return changed;
    };
    return design(request, {}, [&](const DesignFrame& frame) {
        steps = frame.step;
        if (frames)
            frames->push_back(frame);
    });
}

void expectProved(const Result<DesignResult>& result, double draftDegrees) {
    ASSERT_TRUE(result) << result.error().english();
    ASSERT_TRUE(result->castable) << result->certificate.reason;
    EXPECT_GE(result->certificate.worstDraftDegrees, draftDegrees);
    EXPECT_TRUE(result->warnings.empty());
}

/// How far the part's own points went from one frame to the next, at most, over the diagonal.
double leap(const DesignFrame& from, const DesignFrame& to, const IndexedMesh& part) {
    return (*to.partPoints - *from.partPoints).rowwise().norm().maxCoeff() / diagonal(part);
}

constexpr int kEarly = 6; ///< a step amid the bending

} // namespace

TEST(LiveDesign, WithoutAChangeNothingIsDifferent) {
    DesignRequest request = level();
    const Result<DesignResult> plain = design(request);
    request.newest = [&] { return std::optional<LiveSettings>(request); };
    const Result<DesignResult> asked = design(request);
    expectProved(plain, 1);
    expectProved(asked, 1);
    EXPECT_EQ(plain->cast->V, asked->cast->V);
    EXPECT_EQ(plain->cast->F, asked->cast->F);
}

TEST(LiveDesign, MoreDraftIsReachedFromThePresentShape) {
    std::vector<DesignFrame> frames;
    const Result<DesignResult> result =
        changedAt(kEarly, level(), [](LiveSettings& live) { live.draftDegrees = 4; }, &frames);
    expectProved(result, 4);
    EXPECT_EQ(result->settings.draftDegrees, 4);
    ASSERT_GT(frames.size(), kEarly + 1U);
    EXPECT_LT(leap(frames[kEarly - 1], frames[kEarly], *level().part), 0.02);
}

TEST(LiveDesign, MoreDraftIsReachedWheneverItIsAskedFor) {
    const auto more = [](LiveSettings& live) { live.draftDegrees = 3; };
    std::vector<DesignFrame> unchanged;
    ASSERT_TRUE(changedAt(1 << 20, level(), more, &unchanged));
    for (const int step : {1, unchanged.back().step}) {
        std::vector<DesignFrame> frames;
        const Result<DesignResult> result = changedAt(step, level(), more, &frames);
        expectProved(result, 3);
        EXPECT_EQ(result->settings.draftDegrees, 3);
    }
}

TEST(LiveDesign, APlaneChangedMeanwhileIsTheCastsAndTheShapeGoesOn) {
    const PartingPlane other{Eigen::Vector3d(0.15, 0.1, 1).normalized(), 0.8};
    std::vector<DesignFrame> frames;
    const Result<DesignResult> result =
        changedAt(kEarly, level(), [&](LiveSettings& live) { live.plane = other; }, &frames);
    expectProved(result, 1);
    EXPECT_EQ(result->state.plane, other);
    ASSERT_GT(frames.size(), kEarly + 1U);
    EXPECT_EQ(frames[kEarly].state.plane, other);
    EXPECT_LT(leap(frames[kEarly - 1], frames[kEarly], *level().part), 0.04);
    EXPECT_GT(leap(frames[0], frames[kEarly], *level().part), 1e-3) << "it did not begin anew";
}

TEST(LiveDesign, TheShapeIsBentOnUntilAnotherPlaneIsReady) {
    const PartingPlane other{Eigen::Vector3d(0.15, 0.1, 1).normalized(), 0.8};
    DesignRequest request = level();
    request.bendMeanwhile = [] { return true; };
    std::vector<DesignFrame> frames;
    const Result<DesignResult> result =
        changedAt(kEarly, request, [&](LiveSettings& live) { live.plane = other; }, &frames);
    expectProved(result, 1);
    EXPECT_EQ(result->state.plane, other);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].step, static_cast<int>(i) + 1);
        EXPECT_EQ(frames[i].state.plane, *frames[i].settings.plane);
    }
    const auto heedsOther = [&](const DesignFrame& frame) { return frame.state.plane == other; };
    const auto first = std::ranges::find_if(frames, heedsOther);
    ASSERT_GE(first - frames.begin(), kEarly);
    EXPECT_TRUE(std::all_of(first, frames.end(), heedsOther)) << "a leg that is over was seen";
    EXPECT_LT(leap(frames[kEarly - 1], *first, *request.part), 0.04) << "it begins where the change was made";
}

TEST(LiveDesign, WhatIsChangedWhileAnotherPlaneIsMadeReadyCountsToo) {
    const PartingPlane other{Eigen::Vector3d(0.15, 0.1, 1).normalized(), 0.8};
    DesignRequest request = level();
    request.bendMeanwhile = [] { return true; };
    const LiveSettings live = request;
    std::atomic<int> steps = 0;
    request.newest = [&]() -> std::optional<LiveSettings> {
        LiveSettings changed = live;
        if (steps >= kEarly)
            changed.plane = other;
        if (steps >= kEarly + 1)
            changed.draftDegrees = 3;
        return changed;
    };
    const Result<DesignResult> result =
        design(request, {}, [&](const DesignFrame& frame) { steps = frame.step; });
    expectProved(result, 3);
    EXPECT_EQ(result->state.plane, other);
    EXPECT_EQ(result->settings.draftDegrees, 3);
}

TEST(LiveDesign, WhatIsChangedAfterTheStopDoesNotCostTheShapeReached) {
    const PartingPlane other{Eigen::Vector3d(0.15, 0.1, 1).normalized(), 0.8};
    DesignRequest request = level();
    request.keepUnfinished = true;
    const LiveSettings live = request;
    const Task task;
    request.newest = [&]() -> std::optional<LiveSettings> {
        if (!task.stopped())
            return std::nullopt;
        LiveSettings changed = live;
        changed.plane = other;
        return changed;
    };
    const Result<DesignResult> result = design(request, task, [&](const DesignFrame& frame) {
        if (frame.step == kEarly)
            task.cancel();
    });
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_TRUE(result->cutShort);
    ASSERT_TRUE(result->cast);
    EXPECT_EQ(result->settings.plane, live.plane);
}

TEST(LiveDesign, APinSetMeanwhileEndsInThePlane) {
    const Eigen::Vector3d tip(17, 2.3, 3.5);
    const Result<DesignResult> result =
        changedAt(kEarly, level(), [&](LiveSettings& live) { live.pins.push_back({tip}); });
    expectProved(result, 1);
    ASSERT_EQ(result->pins.size(), 1U);
    EXPECT_LE(result->pins[0].distanceFromPlane, 1e-6 * diagonal(*level().part));
}

TEST(LiveDesign, DirectionsGivenMeanwhileAreTheCasts) {
    const Eigen::Vector3d d = Eigen::Vector3d(0.15, 0.05, 1).normalized();
    const Result<DesignResult> result = changedAt(kEarly, level(), [&](LiveSettings& live) {
        live.directionsChoice = DirectionsChoice::Given;
        live.directions = {d, -d};
    });
    expectProved(result, 1);
    EXPECT_EQ(result->state.directions.d1, d);
    EXPECT_EQ(result->state.directions.d2, -d);
}

TEST(LiveDesign, ARegionWeighedMeanwhileIsStrainedLess) {
    DesignRequest request = level();
    std::vector<double> weights(static_cast<std::size_t>(request.part->faceCount()), 1);
    KeptRegion region;
    for (int f = 0; f < request.part->faceCount(); ++f)
        if (request.part->corner(f, 0).x() > 12) {
            weights[static_cast<std::size_t>(f)] = 64;
            region.faces.push_back(f);
        }
    request.regions = {region};
    const Result<DesignResult> plain = design(request);
    const Result<DesignResult> weighed =
        changedAt(kEarly, request, [&](LiveSettings& live) { live.faceWeights = weights; });
    expectProved(plain, 1);
    expectProved(weighed, 1);
    EXPECT_LT(weighed->regions[0].strain, 0.8 * plain->regions[0].strain);
}

TEST(LiveDesign, DirectionsFollowTheShapeWhereAsked) {
    DesignRequest request = level();
    const Result<DesignResult> once = design(request);
    request.followDirections = true;
    const Result<DesignResult> followed = design(request);
    expectProved(once, 1);
    expectProved(followed, 1);
    EXPECT_NE(once->state.directions, followed->state.directions);
}

TEST(LiveDesign, ThePublishedMethodTakesChangesToo) {
    DesignRequest request = level();
    request.method = DeformationMethod::Paper;
    const PartingPlane other{Eigen::Vector3d(0.1, 0, 1).normalized(), 1};
    std::vector<DesignFrame> frames;
    const Result<DesignResult> result = changedAt(
        3, request,
        [&](LiveSettings& live) {
            live.plane = other;
            live.smoothing = 0.5;
            live.pins = {{{0, 0, 0}}};
        },
        &frames);
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_EQ(result->state.plane, other);
    EXPECT_LE(result->pins.at(0).distanceFromPlane, 1e-6 * diagonal(*request.part));
    EXPECT_LT(leap(frames[2], frames[3], *request.part), 0.1);
}

TEST(LiveDesign, AnotherRunBeginsFromAnyFrame) {
    std::vector<DesignFrame> frames;
    DesignRequest request = level();
    ASSERT_TRUE(changedAt(1 << 20, request, [](LiveSettings&) {}, &frames));
    const DesignFrame from = frames[kEarly];
    request.plane = from.state.plane;
    request.start = from.partPoints;
    frames.clear();
    const Result<DesignResult> result = changedAt(1 << 20, request, [](LiveSettings&) {}, &frames);
    expectProved(result, 1);
    EXPECT_LT(leap(from, frames.front(), *request.part), 0.02);
    EXPECT_GT((*from.partPoints - request.part->V).norm(), 1e-3);
    EXPECT_EQ(result->before.topRows(request.part->vertexCount()).rows(), request.part->vertexCount());
}

TEST(CarriedPins, GoWithTheShape) {
    const SharedMesh part = banana();
    IndexedMesh shape = *part;
    const Eigen::Isometry3d motion =
        Eigen::Translation3d(3, 4, 5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    shape.V = (part->V * motion.linear().transpose()).rowwise() + motion.translation().transpose();
    const Eigen::Vector3d inside(1, 0, 0);
    const std::vector<Pin> carried = carriedPins({{inside}, {part->point(7)}}, *part, shape);
    EXPECT_LT((carried[0].point - motion * inside).norm(), 1e-9);
    EXPECT_EQ(carried[1].point, shape.point(7));
}
