// SPDX-License-Identifier: AGPL-3.0-or-later
// Algorithm 1 from end to end on shapes made in code.
#include "design/design.h"

#include "base/parallel.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/casts.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace moldwright;

namespace {

SharedMesh shared(IndexedMesh mesh) {
    return std::make_shared<const IndexedMesh>(std::move(mesh));
}

/// A sausage bent up and aside like a banana, about 40 mm long: every level plane leaves undercuts.
SharedMesh banana() {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 3);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Eigen::Vector3d x = mesh.point(v).cwiseProduct(Eigen::Vector3d(20, 5, 5));
        mesh.V.row(v) << x.x(), x.y() + 0.008 * x.x() * x.x(), x.z() + 0.012 * x.x() * x.x();
    }
    return shared(mesh);
}

DesignRequest level(SharedMesh part) {
    DesignRequest request;
    request.part = std::move(part);
    request.plane = PartingPlane{};
    return request;
}

/// The proof is made anew, from the geometry alone: labels too.
void expectProved(const DesignResult& result, double draftDegrees) {
    ASSERT_TRUE(result.castable) << result.certificate.reason;
    const Certificate proof =
        certify(*result.cast, labelSides(*result.cast, result.state.plane), result.state, draftDegrees);
    EXPECT_TRUE(proof.holds()) << proof.reason;
    EXPECT_GE(proof.worstDraftDegrees, draftDegrees);
    EXPECT_TRUE(diagnose(*result.cast).usable());
    EXPECT_EQ(result.cast->V.cast<float>().cast<double>(), result.cast->V) << "an STL holds it exactly";
}

} // namespace

TEST(Design, BendsABananaUntilItIsCastableAndStaysNearIt) {
    const DesignRequest request = level(banana());
    int frames = 0;
    double lastEnergy = -1;
    const Result<DesignResult> result = design(request, {}, [&](const DesignFrame& frame) {
        EXPECT_EQ(frame.step, ++frames);
        EXPECT_FALSE(frame.stage.empty());
        lastEnergy = frame.energy;
    });
    ASSERT_TRUE(result) << result.error().english();
    expectProved(*result, 1);
    EXPECT_GT(frames, 3);
    EXPECT_LT(lastEnergy, 1e-4);
    EXPECT_EQ(result->energy, 0);
    EXPECT_EQ(result->violatingAreaFraction, 0);
    EXPECT_GT(result->tets, 100);
    EXPECT_GT(result->change.meanDistance, 1e-4) << "it did have to bend";
    EXPECT_LT(result->change.meanDistance, 0.05);
    EXPECT_NEAR(result->change.volumeRatio, 1, 0.15);
}

TEST(Design, BothHalvesLeaveAlongThePressAxis) {
    const Eigen::Vector3d axis = Eigen::Vector3d(0.1, -0.2, -1).normalized();
    DesignRequest request = level(banana());
    request.limits = {30, axis, 0};
    for (const bool given : {true, false}) {
        if (!given)
            request.plane.reset();
        const Result<DesignResult> result = design(request);
        ASSERT_TRUE(result) << result.error().english();
        expectProved(*result, 1);
        EXPECT_LT(result->state.directions.d1.cross(axis).norm(), 1e-12);
        EXPECT_LT(result->state.directions.d2.cross(axis).norm(), 1e-12);
        EXPECT_LE(degrees(std::acos(result->state.directions.d1.dot(result->state.plane.normal))), 30.001);
    }
}

TEST(Design, AnAxisThatNoPlaneSoTurnedAllowsIsRefused) {
    DesignRequest request = level(banana());
    request.limits = {30, Eigen::Vector3d::UnitX(), 20};
    const Result<DesignResult> result = design(request);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Impossible);
    EXPECT_NE(result.error().english().find("30°"), std::string::npos) << result.error().english();
}

TEST(Design, FillsTheHoleOfAStandingRingWhereAsked) {
    const IndexedMesh ring =
        test::rotated(test::torus(16, 5, 48, 24), Eigen::Vector3d::UnitX(), std::numbers::pi / 2);
    DesignRequest request = level(shared(ring));
    request.plane->offset = -18;
    const Result<DesignResult> named = design(request);
    ASSERT_TRUE(named) << named.error().english();
    EXPECT_FALSE(named->castable);
    ASSERT_FALSE(named->obstructions.empty());
    EXPECT_FALSE(named->cast);
    request.fill = FillChoice::Auto;
    const Result<DesignResult> filled = design(request);
    ASSERT_TRUE(filled) << filled.error().english();
    expectProved(*filled, 1);
    EXPECT_FALSE(filled->obstructions.empty()) << "what was filled is still told";
    // The disc that closes the hole, and what lies beside it under the ring's flanks.
    EXPECT_GT(filled->change.filledVolumeFraction, 0.3);
    EXPECT_LT(filled->change.filledVolumeFraction, 1.5);
}

TEST(Design, JoinsPiecesByFillingOnlyWhereAllowed) {
    // A ball that hovers over another: its foot down to the plane would grow into the lower one.
    const IndexedMesh pieces =
        test::together(test::sphere({0, 0, 0}, 10, 2), test::sphere({0, 0, 25}, 10, 2));
    DesignRequest request = level(shared(pieces));
    request.fill = FillChoice::Auto;
    const Result<DesignResult> apart = design(request);
    ASSERT_TRUE(apart) << apart.error().english();
    EXPECT_FALSE(apart->castable);
    ASSERT_FALSE(apart->obstructions.empty());
    EXPECT_EQ(apart->obstructions.front().kind, Obstruction::Kind::ClosedPiece);
    request.mergePieces = true;
    const Result<DesignResult> joined = design(request);
    ASSERT_TRUE(joined) << joined.error().english();
    expectProved(*joined, 1);
    EXPECT_EQ(connectedComponents(*joined->cast).count, 1);
}

TEST(Design, LeavesItsInputsAloneWhereverItIsCancelled) {
    DesignRequest request = level(banana());
    request.plane.reset();
    const IndexedMesh before = *request.part;
    int reports = 0;
    const Task whole([&](double, const std::string&) { ++reports; });
    ASSERT_TRUE(design(request, whole));
    std::mt19937 random(7);
    int cancelledRuns = 0;
    for (int run = 0; run < 50; ++run) {
        int left = 1 + static_cast<int>(random() % static_cast<unsigned>(reports));
        const Task* running = nullptr;
        const Task task([&](double, const std::string&) {
            if (--left == 0)
                running->cancel();
        });
        running = &task;
        const Result<DesignResult> result = design(request, task);
        cancelledRuns += !result;
        if (!result) {
            EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
        }
        EXPECT_EQ(request.part->V, before.V);
        EXPECT_EQ(request.part->F, before.F);
    }
    EXPECT_GT(cancelledRuns, 40) << "only a last report may come too late";
}

TEST(Design, KeepsWhatItReachedWhereAsked) {
    DesignRequest request = level(banana());
    request.keepUnfinished = true;
    const Task task;
    const Result<DesignResult> result = design(request, task, [&](const DesignFrame& frame) {
        if (frame.step == 5)
            task.cancel();
    });
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_TRUE(result->cutShort);
    EXPECT_TRUE(result->cast);
    EXPECT_FALSE(result->castable);
}

TEST(Design, FindsAPlaneForABananaThatHardlyChangesIt) {
    DesignRequest request = level(banana());
    request.plane.reset();
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    expectProved(*result, 1);
    EXPECT_LT(result->change.meanDistance, 0.01);
}

TEST(Design, ARingLyingFlatKeepsItsHole) {
    const Result<DesignResult> result = design(level(shared(test::torus(20, 5, 40, 16))));
    ASSERT_TRUE(result) << result.error().english();
    expectProved(*result, 1);
    EXPECT_EQ(diagnose(*result->cast).genus, 1);
    EXPECT_LT(result->change.meanDistance, 0.01);
}

TEST(Design, AFlatBackedFrustumStaysAsItIs) {
    IndexedMesh mesh = test::frusta(40, 30, 10, 0, 0.2).mesh;
    const SharedMesh part = shared(test::splitInFour(test::splitInFour(mesh)));
    const Result<DesignResult> result = design(level(part));
    ASSERT_TRUE(result) << result.error().english();
    expectProved(*result, 5);
    EXPECT_LT(result->change.maxDistance, 1e-6);
    EXPECT_NEAR(result->change.volumeRatio, 1, 1e-6);
    for (int f = 0; f < result->cast->faceCount(); ++f)
        if (result->labels[static_cast<std::size_t>(f)] == 2) {
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(result->cast->corner(f, k).z(), 0) << "the second half is a plate";
        }
}

TEST(Design, TwoLinkedRingsAreImpossibleWithTheReasonNamed) {
    IndexedMesh other =
        test::rotated(test::torus(20, 4, 30, 12), Eigen::Vector3d::UnitX(), std::numbers::pi / 2);
    other.V.col(0).array() += 20;
    const Result<DesignResult> result =
        design(level(shared(test::together(test::torus(20, 4, 30, 12), other))));
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_FALSE(result->castable);
    ASSERT_EQ(result->obstructions.size(), 2U) << "above and below";
    for (const Obstruction& arch : result->obstructions) {
        EXPECT_EQ(arch.kind, Obstruction::Kind::Link);
        EXPECT_NE(arch.message.english().find("hang in one"), std::string::npos) << arch.message.english();
        EXPECT_NEAR(arch.place.x(), 20, 1);
    }
}

TEST(Design, EndsSoonWhenCancelledMidWay) {
    const Task task;
    int frames = 0;
    const Result<DesignResult> result = design(level(banana()), task, [&](const DesignFrame&) {
        if (++frames == 2)
            task.cancel();
    });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
    EXPECT_LT(frames, 6);
}

TEST(Design, AskedToFinishItBendsNoFurtherAndProvesWhatItHas) {
    DesignRequest request = level(banana());
    bool asked = false;
    int bent = 0;
    int bentAfterwards = 0;
    request.finishNow = [&] { return asked; };
    const Result<DesignResult> result = design(request, {}, [&](const DesignFrame& frame) {
        const bool bending = frame.stage == "deformation";
        bentAfterwards += bending && asked;
        bent += bending;
        asked = asked || bent == 3;
    });
    ASSERT_TRUE(result) << result.error().english();
    expectProved(*result, 1);
    EXPECT_EQ(bent, 3);
    EXPECT_EQ(bentAfterwards, 0);
}

TEST(Design, FramesOfASplitPartKnowTheSideOfEachFace) {
    double worst = -90;
    const Result<DesignResult> result = design(level(banana()), {}, [&](const DesignFrame& frame) {
        ASSERT_EQ(static_cast<int>(frame.labels.size()), frame.shape->faceCount());
        worst = frame.worstDraftDegrees;
    });
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_GT(worst, -10) << "no slivers on the wrong side at the parting line";
}

TEST(Design, GivesTheSameBytesForAnyNumberOfThreads) {
    std::vector<DesignResult> results;
    for (const int threads : {1, 2}) {
        setThreadCount(threads);
        const Result<DesignResult> result = design(level(banana()));
        ASSERT_TRUE(result) << result.error().english();
        results.push_back(*result);
    }
    setThreadCount(0);
    EXPECT_TRUE(results[0].cast->V == results[1].cast->V);
    EXPECT_TRUE(results[0].cast->F == results[1].cast->F);
    EXPECT_EQ(results[0].labels, results[1].labels);
    EXPECT_EQ(results[0].state, results[1].state);
    EXPECT_EQ(results[0].change.meanDistance, results[1].change.meanDistance);
}

TEST(Design, KeepsGivenDirectionsAndAHigherDraft) {
    DesignRequest request = level(banana());
    request.draftDegrees = 3;
    request.directionsChoice = DirectionsChoice::Given;
    request.directions = {Eigen::Vector3d(0.1, 0, 1).normalized(), -Eigen::Vector3d::UnitZ()};
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    expectProved(*result, 3);
    EXPECT_EQ(result->state.directions, request.directions);
    EXPECT_EQ(result->state.plane, *request.plane);
}

TEST(Design, ThePublishedMethodBringsTheEnergyDown) {
    DesignRequest request = level(banana());
    request.method = DeformationMethod::Paper;
    double first = -1;
    const Result<DesignResult> result = design(request, {}, [&](const DesignFrame& frame) {
        if (first < 0)
            first = frame.energy;
    });
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_GT(result->plasticSteps, 0);
    EXPECT_GT(result->localGlobalIterations, result->plasticSteps);
    EXPECT_LT(result->energy, 0.5 * first);
    EXPECT_EQ(result->cast->F, request.part->F) << "nothing is split";
}
