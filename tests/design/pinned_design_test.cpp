// SPDX-License-Identifier: AGPL-3.0-or-later
// Pins from the request to the finished cast.
#include "deformation/tet_topology.h"
#include "design/design.h"
#include "design/pinned_planes.h"
#include "design/pins_in_plane.h"
#include "exchange/tetrahedralize.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace moldwright;

namespace {

const IndexedMesh& ball() {
    static const IndexedMesh mesh = test::sphere({0, 0, 0}, 10, 3);
    return mesh;
}

/// A bar along x whose ends hang 12 below its middle.
SharedMesh bow() {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 1, 4);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double x = mesh.V(v, 0);
        mesh.V.row(v) << 40 * x, 7 * mesh.V(v, 1), 6 * mesh.V(v, 2) - 12 * x * x;
    }
    return std::make_shared<const IndexedMesh>(mesh);
}

DesignRequest requestWith(std::vector<Pin> pins) {
    DesignRequest request;
    request.part = bow();
    request.pins = std::move(pins);
    return request;
}

void expectInPlane(const Result<DesignResult>& result, const DesignRequest& request) {
    ASSERT_TRUE(result) << result.error().english();
    EXPECT_TRUE(result->castable) << result->certificate.reason;
    ASSERT_EQ(result->pins.size(), request.pins.size());
    for (const PinnedPoint& pin : result->pins) {
        EXPECT_LE(pin.distanceFromPlane, 1e-6 * diagonal(*request.part));
        EXPECT_LE(std::abs(result->state.plane.distance(pin.place)), 1e-6 * diagonal(*request.part));
        EXPECT_TRUE(boundingBox(*result->cast).contains(pin.place));
    }
}

} // namespace

TEST(PinsInPlane, APinInsideIsAPointOfTheTetrahedra) {
    const MoldState state{{Eigen::Vector3d(1, 1, 4).normalized(), 0}, {}};
    const Eigen::Vector3d inPlane = Eigen::Vector3d(4, 0, -1); // square to the normal
    const Result<PartedSolid> solid = partSolid(ball(), state, {}, {{inPlane, -1}});
    ASSERT_TRUE(solid) << solid.error().english();
    ASSERT_EQ(solid->pins.size(), 1U);
    EXPECT_EQ(solid->pins[0].place.z(), 0);
    EXPECT_LT((solid->frame.toPart(solid->pins[0].place) - inPlane).norm(), 1e-9);
    const auto inner = innerPoints(solid->tets, solid->surface.mesh.vertexCount(), innerPlaces(solid->pins));
    ASSERT_EQ(inner.size(), 1U);
    EXPECT_GE(inner[0], solid->surface.mesh.vertexCount());
    EXPECT_EQ(invertedCount(solid->tets.T, solid->tets.V), 0);
}

TEST(PinsInPlane, APinnedPointOfTheSurfaceIsOnThePartingLineEvenWhereThePlaneOnlyTouchesIt) {
    // The plane touches the ball at its top alone.
    int top = 0;
    ball().V.col(2).maxCoeff(&top);
    const MoldState state{{Eigen::Vector3d::UnitZ(), ball().V(top, 2)}, {}};
    const Result<PartedPart> part = partSurface(ball(), state, {}, {{ball().point(top), top}});
    ASSERT_TRUE(part) << part.error().english();
    EXPECT_EQ(part->surface.mesh.V(top, 2), 0);
    bool onLine = false;
    for (const auto& [a, b] : partingEdges(part->surface.mesh, part->surface.labels))
        onLine = onLine || a == top || b == top;
    EXPECT_TRUE(onLine);
    EXPECT_TRUE(diagnose(part->surface.mesh).usable());
}

TEST(PinsInPlane, ChangeIsMeasuredFromThePartAsItWasBefore) {
    IndexedMesh drawn = ball();
    drawn.V.col(2) *= 0.5;
    const Result<PartedPart> part = partSurface(drawn, {}, {});
    ASSERT_TRUE(part);
    const IndexedMesh before = beforePinning(*part, drawn, ball());
    ASSERT_EQ(before.vertexCount(), part->surface.mesh.vertexCount());
    EXPECT_NEAR(volume(before), volume(ball()), 0.01 * volume(ball()));
    EXPECT_EQ(before.V.topRows(ball().vertexCount()), ball().V);
    EXPECT_NEAR(before.V.rowwise().norm().minCoeff(), 10, 0.3);
}

TEST(PinnedDesign, PointsInsideEndInTheGivenPlane) {
    DesignRequest request = requestWith({{{-36, 0, -9.7}}, {{0, 0, 0}}, {{36, 0, -9.7}}});
    request.plane = PartingPlane{Eigen::Vector3d(0.05, 0.1, 1).normalized(), -1};
    const Result<DesignResult> result = design(request);
    expectInPlane(result, request);
    ASSERT_TRUE(result);
    // The bow was straightened: it no longer hangs down.
    EXPECT_LT(boundingBox(*result->cast).sizes().z(), 0.85 * boundingBox(*request.part).sizes().z());
    EXPECT_GT(result->change.maxDistance, 0.01);
}

TEST(PinnedDesign, PointsOfTheSurfaceEndInThePlane) {
    DesignRequest request = requestWith({{{-30, 4.63, -6.75}},
                                         {{-30, -4.63, -6.75}},
                                         {{0, 7, 0}},
                                         {{0, -7, 0}},
                                         {{30, 4.63, -6.75}},
                                         {{30, -4.63, -6.75}}});
    request.plane = PartingPlane{Eigen::Vector3d(0.1, 0.05, 1).normalized(), -1};
    expectInPlane(design(request), request);
}

TEST(PinnedDesign, APlaneIsFoundThatSuitsThePins) {
    const DesignRequest request = requestWith({{{-36, 0, -9.7}}, {{0, 1, 0}}, {{36, 0, -9.7}}});
    expectInPlane(design(request), request);
}

TEST(PinnedDesign, PlanesForPinsBeginNearThem) {
    const DesignRequest request = requestWith({{{-20, 0, -3}}, {{20, 0, -3}}, {{0, 5, -3}}, {{0, -5, -3}}});
    const FrameSink nobody;
    DesignRun run(request, {}, nobody);
    const std::vector<PartingPlane> planes = planesForPins(run, 3);
    ASSERT_EQ(planes.size(), 3U);
    double squares = 0;
    for (const Pin& pin : request.pins)
        squares += std::pow(planes[0].distance(pin.point), 2);
    EXPECT_LT(std::sqrt(squares / 4), 3);
}

TEST(PinnedDesign, ThePublishedMethodHoldsItsPinsThroughPostProcessing) {
    DesignRequest request = requestWith({{{-40, 0, -12}}, {{0, 0, 0}}});
    request.plane = PartingPlane{};
    request.method = DeformationMethod::Paper;
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    ASSERT_EQ(result->pins.size(), 2U);
    for (const PinnedPoint& pin : result->pins)
        EXPECT_LE(pin.distanceFromPlane, 1e-6 * diagonal(*request.part));
}
