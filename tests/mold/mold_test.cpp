// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold.h"

#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

Result<Mold> moldOf(const KnownCast& cast, double draft = 1, const MoldSettings& settings = {}) {
    return buildMold(test::trayOf(cast), draft, settings);
}

/// Volume of a frustum over a × b, height h, lean l: the integral of (a − 2lz)(b − 2lz).
double frustum(double a, double b, double h, double l) {
    return a * b * h - (a + b) * l * h * h + 4.0 / 3 * l * l * h * h * h;
}

const double lean = std::tan(radians(5));

} // namespace

TEST(Mold, OfADraftedBoxHasTheVolumesCalculatedByHand) {
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean));
    expectVerified(mold);
    const double up = frustum(20, 10, 5, lean);
    const double down = frustum(20, 10, 3, lean);
    EXPECT_NEAR(mold->cavityVolume, up + down, 1e-3);
    EXPECT_NEAR(mold->half1.volume, 30 * 20 * 10 - up, 1e-3);
    EXPECT_NEAR(mold->half2.volume, 30 * 20 * 8 - down, 1e-3);
    EXPECT_NEAR(mold->half1.size.x() * mold->half1.size.y(), 600, 1e-9);
    EXPECT_DOUBLE_EQ(mold->half1.size.z(), 10);
    EXPECT_DOUBLE_EQ(mold->half2.size.z(), 8);
    EXPECT_NEAR(mold->partingArea, 200, 1e-4);
    EXPECT_NEAR(mold->clampForce, 2 * 4 / 100.0 * 1.1, 1e-6);
    EXPECT_NEAR(mold->minWall, 5, 1e-6);
}

TEST(Mold, HalvesMeetInThePlaneZ0AndHoldFloats) {
    const Result<Mold> mold = moldOf(moved(ring(10, 3, 40, 16), {1, 2, 3}, 0.7, {5, 6, 7}));
    expectVerified(mold);
    const IndexedMesh& upper = *mold->half1.mesh;
    const IndexedMesh& lower = *mold->half2.mesh;
    EXPECT_EQ(upper.V.col(2).minCoeff(), 0);
    EXPECT_EQ(lower.V.col(2).maxCoeff(), 0);
    for (const IndexedMesh* mesh : {&upper, &lower, mold->cast.get()})
        EXPECT_EQ(mesh->V, mesh->V.cast<float>().cast<double>());
    EXPECT_EQ((upper.V.col(2).array() == 0).count(), (lower.V.col(2).array() == 0).count());
}

TEST(Mold, OfARingHasSteelInItsMiddle) {
    const int around = 40;
    const Result<Mold> mold = moldOf(ring(10, 3, around, 16));
    expectVerified(mold);
    const double polygon = 0.5 * around * std::sin(2 * std::numbers::pi / around);
    EXPECT_NEAR(mold->partingArea, polygon * (13 * 13 - 7 * 7), 1e-3);
    const double block = mold->half1.size.x() * mold->half1.size.y() * 8; // 3 mm of ring and 5 of ceiling
    EXPECT_NEAR(mold->half1.volume, block - mold->cavityVolume / 2, 1e-2);
    EXPECT_EQ(diagnose(*mold->half1.mesh).genus, 0);
}

TEST(Mold, OfAFlatBackedPartHasAPlate) {
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 0, lean));
    expectVerified(mold);
    EXPECT_NEAR(mold->half2.volume, 30 * 20 * 5, 1e-6);
    EXPECT_DOUBLE_EQ(mold->half2.size.z(), 5);
    EXPECT_NEAR(mold->half1.volume, 30 * 20 * 10 - frustum(20, 10, 5, lean), 1e-3);
}

TEST(Mold, OpensAlongObliqueDirections) {
    const KnownCast cast = moved(sheared(ball(20, 4), 0.3, -0.2), {3, 1, -2}, 1.1, {-40, 10, 3});
    const Result<Mold> mold = moldOf(cast);
    expectVerified(mold);
    EXPECT_NEAR(mold->cavityVolume, volume(cast.mesh), 1e-5 * mold->cavityVolume);
    EXPECT_NEAR(mold->directions.d1.z(), cast.state.directions.d1.dot(cast.state.plane.normal), 1e-12);
    const Vector3d onPlane = cast.state.plane.offset * cast.state.plane.normal;
    EXPECT_NEAR((mold->partToMold * onPlane).z(), 0, 1e-12);
}

TEST(Mold, OfSeveralPartsHasACavityEach) {
    KnownCast cast = frusta(20, 10, 5, 3, lean);
    IndexedMesh second = frusta(8, 6, 4, 2, lean).mesh;
    second.V.col(1).array() += 20;
    cast.mesh = together(cast.mesh, second);
    const Result<Mold> mold = moldOf(cast);
    expectVerified(mold);
    EXPECT_NEAR(mold->partingArea, 200 + 48, 1e-3);
}

TEST(Mold, SizesRoundUpToTheStep) {
    MoldSettings settings;
    settings.wall = 4.2;
    settings.step = 10;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), 1, settings);
    expectVerified(mold);
    EXPECT_NEAR(mold->half1.size.x() * mold->half1.size.y(), 30 * 20, 1e-9);
    EXPECT_DOUBLE_EQ(mold->half1.size.z(), 10);
    EXPECT_DOUBLE_EQ(mold->half2.size.z(), 10);
}

TEST(Mold, OfWallsWithoutDraftIsBuiltButNotVerified) {
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, 0));
    ASSERT_TRUE(mold.has_value());
    EXPECT_FALSE(mold->verified());
    EXPECT_EQ(mold->castCertificate.violatingFaces.size(), 16U);
    EXPECT_EQ(mold->problems.size(), 3U); // the cast and either half
}

TEST(Mold, OfCrossingCurvesIsRefused) {
    KnownCast cast = frusta(20, 10, 5, 3, lean);
    IndexedMesh second = cast.mesh;
    second.V.col(0).array() += 7;
    cast.mesh = together(cast.mesh, second);
    const Result<Mold> mold = moldOf(cast);
    ASSERT_FALSE(mold.has_value());
    EXPECT_EQ(mold.error().code, ErrorCode::BadInput);
}

TEST(Mold, CanBeCancelled) {
    const Task task;
    task.cancel();
    const KnownCast cast = ball(10, 3);
    const Result<Mold> mold = buildMold(test::trayOf(cast), 1, {}, task);
    ASSERT_FALSE(mold.has_value());
    EXPECT_EQ(mold.error().code, ErrorCode::Cancelled);
}

TEST(Mold, HearsACancelInTheMiddleOfEveryStage) {
    const KnownCast cast = ball(10, 3);
    MoldSettings settings = everyFeature();
    settings.layout.rows = settings.layout.columns = 2;
    std::vector<std::string> stages;
    const auto note = [&](double, const std::string& stage) { stages.push_back(stage); };
    expectVerified(buildMold(test::trayOf(cast), 1, settings, Task(note)));
    stages.pop_back(); // told when all is done
    for (std::size_t number = 0; number < stages.size(); ++number) {
        std::size_t begun = 0;
        Task* running = nullptr;
        Task task([&](double, const std::string&) {
            if (begun++ == number)
                running->cancel();
        });
        running = &task;
        const Result<Mold> mold = buildMold(test::trayOf(cast), 1, settings, task);
        ASSERT_FALSE(mold.has_value()) << stages[number];
        EXPECT_EQ(mold.error().code, ErrorCode::Cancelled);
        EXPECT_EQ(begun, number + 1) << "no other stage begins";
    }
}
