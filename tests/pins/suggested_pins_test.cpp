// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/suggested_pins.h"

#include "known_axes.h"

#include "base/parallel.h"
#include "mesh/measures.h"
#include "pins/cgal/inside_test.h"
#include "support/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moldwright;
using namespace moldwright::test;

namespace {

std::vector<IndexedMesh> someShapes() {
    return {capsule(0.25, 1, 48, 40),     torus(1, 0.3, 80, 24),
            ellipsoid(1, 0.6, 0.3, 4),    box({-1, -0.6, -0.3}, {1, 0.6, 0.3}),
            sphere({3, 4, 5}, 2, 4),      together(sphere({0, 0, 0}, 1, 3), sphere({4, 0, 0}, 0.5, 3)),
            box({0, 0, 0}, {10, 10, 0.2})};
}

IndexedMesh moved(const IndexedMesh& mesh, double scale, const Eigen::Isometry3d& motion) {
    IndexedMesh result = mesh;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        result.V.row(v) = (motion * (scale * mesh.point(v))).transpose();
    return result;
}

/// Symmetric shapes have several axes that are equally good, and rounding chooses between them.
IndexedMesh lopsided(IndexedMesh mesh) {
    const double size = diagonal(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Eigen::Vector3d p = mesh.point(v) / size;
        mesh.V.row(v) +=
            0.03 * size *
            Eigen::RowVector3d(std::sin(7 * p.y() + 1), std::sin(5 * p.z()), std::sin(4 * p.x() + 2));
    }
    return mesh;
}

Eigen::Isometry3d someMotion() {
    return Eigen::Translation3d(30, -7, 11) *
           Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.7, 0.5).normalized());
}

} // namespace

TEST(SuggestedPins, EveryPinLiesInsideWithItsBallAndNoTwoAreNear) {
    for (const IndexedMesh& mesh : someShapes()) {
        const PinSuggestions found = suggestPins(mesh, {}).value();
        const double size = diagonal(mesh);
        const InsideTest solid(mesh);
        ASSERT_FALSE(found.pins.empty());
        EXPECT_LE(found.pins.size(), 40u);
        for (std::size_t i = 0; i < found.pins.size(); ++i) {
            const SuggestedPin& pin = found.pins[i];
            EXPECT_TRUE(solid.inside(pin.point));
            EXPECT_GT(pin.radius, 0);
            EXPECT_GE(pin.rank, 0);
            EXPECT_LE(pin.rank, 1);
            EXPECT_LE(pin.rank, i == 0 ? 1 : found.pins[i - 1].rank);
            for (int v = 0; v < mesh.vertexCount(); ++v)
                EXPECT_GT((mesh.point(v) - pin.point).norm(), pin.radius - 2e-3 * size);
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT((found.pins[j].point - pin.point).norm(), 0.02 * size);
        }
    }
}

TEST(SuggestedPins, TheSurfaceIsSharedOutAmongThem) {
    for (const IndexedMesh& mesh : someShapes()) {
        const PinSuggestions found = suggestPins(mesh, {}).value();
        double whole = 0;
        for (const SuggestedPin& pin : found.pins)
            whole += pin.areaShare;
        EXPECT_NEAR(whole, 1, 1e-9);
        ASSERT_EQ(found.pinOfFace.size(), static_cast<std::size_t>(mesh.faceCount()));
        for (const int pin : found.pinOfFace) {
            EXPECT_GE(pin, 0);
            EXPECT_LT(pin, static_cast<int>(found.pins.size()));
        }
    }
}

TEST(SuggestedPins, TheSameSeedGivesTheSamePinsForAnyNumberOfThreads) {
    const IndexedMesh mesh = torus(1, 0.3, 80, 24);
    setThreadCount(1);
    const PinSuggestions one = suggestPins(mesh, {}).value();
    setThreadCount(4);
    const PinSuggestions four = suggestPins(mesh, {}).value();
    setThreadCount(0);
    ASSERT_EQ(one.pins.size(), four.pins.size());
    for (std::size_t i = 0; i < one.pins.size(); ++i) {
        EXPECT_EQ(one.pins[i].point, four.pins[i].point);
        EXPECT_EQ(one.pins[i].rank, four.pins[i].rank);
    }
    EXPECT_EQ(one.pinOfFace, four.pinOfFace);
}

TEST(SuggestedPins, TurningMovingAndScalingThePartDoesTheSameToThePins) {
    const Eigen::Isometry3d motion = someMotion();
    for (const IndexedMesh& shape : someShapes()) {
        const IndexedMesh mesh = lopsided(shape);
        const PinSuggestions before = suggestPins(mesh, {}).value();
        for (const double scale : {0.01, 1.0, 37.0}) {
            const PinSuggestions after = suggestPins(moved(mesh, scale, motion), {}).value();
            ASSERT_EQ(before.pins.size(), after.pins.size()) << mesh.vertexCount();
            const double tolerance = 0.01 * diagonal(mesh) * scale;
            for (const SuggestedPin& pin : before.pins) {
                const Eigen::Vector3d there = motion * (scale * pin.point);
                EXPECT_TRUE(std::any_of(after.pins.begin(), after.pins.end(),
                                        [&](const SuggestedPin& p) {
                                            return (p.point - there).norm() < tolerance &&
                                                   p.kind == pin.kind &&
                                                   std::abs(p.radius - scale * pin.radius) < tolerance;
                                        }))
                    << mesh.vertexCount() << " points, scale " << scale;
            }
        }
    }
}

TEST(SuggestedPins, ACapsuleHasATipAtEachEnd) {
    const PinSuggestions found = suggestPins(capsule(0.25, 1, 64, 60), {}).value();
    for (const double end : {-1.25, 1.25})
        EXPECT_TRUE(std::any_of(found.pins.begin(), found.pins.end(), [&](const SuggestedPin& pin) {
            return pin.kind == PinKind::Tip && (pin.point - Eigen::Vector3d(0, 0, end)).norm() < 0.06 * 2.6;
        }));
}

TEST(SuggestedPins, NoMoreThanAskedForAndTheEndsStayLongest) {
    const IndexedMesh mesh = capsule(0.1, 2, 32, 100);
    for (const int count : {2, 5, 9}) {
        const PinSuggestions found = suggestPins(mesh, {count, 1}).value();
        EXPECT_EQ(found.pins.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(std::count_if(found.pins.begin(), found.pins.end(),
                                [](const SuggestedPin& p) { return p.kind == PinKind::Tip; }),
                  2);
    }
}

TEST(SuggestedPins, ARegionOffThePlaneGainsByBeingMovedOntoIt) {
    // Two balls: the plane runs through the middle of one, the other hangs above it.
    const IndexedMesh mesh = together(sphere({0, 0, 0}, 1, 3), sphere({4, 0, 1.5}, 1, 3));
    PinSuggestions found = suggestPins(mesh, {}).value();
    MoldState state;
    rankPins(found, mesh, state, 1);
    double onPlane = -1;
    double above = -1;
    for (const SuggestedPin& pin : found.pins)
        (pin.point.x() > 2 ? above : onPlane) = std::max(pin.point.x() > 2 ? above : onPlane, pin.gain);
    EXPECT_GT(above, 0.5);
    EXPECT_LT(onPlane, 0.1);
    const auto best =
        std::max_element(found.pins.begin(), found.pins.end(),
                         [](const SuggestedPin& a, const SuggestedPin& b) { return a.rank < b.rank; });
    EXPECT_GT(best->point.x(), 2);
}

TEST(SuggestedPins, ACancelledSearchSaysSo) {
    Task task;
    task.cancel();
    const Result<PinSuggestions> found = suggestPins(torus(1, 0.3, 80, 24), {}, task);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::Cancelled);
}
