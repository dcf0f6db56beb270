// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/obstructions.h"

#include "design/parting.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

using namespace moldwright;

namespace {

/// A ring of radius 20 and thickness 10 that stands upright about the origin.
IndexedMesh standingRing() {
    return test::rotated(test::torus(20, 5, 40, 16), Eigen::Vector3d::UnitX(), std::numbers::pi / 2);
}

MoldState level(double height) {
    return {{Eigen::Vector3d::UnitZ(), height}, {}};
}

} // namespace

TEST(Obstructions, ALinkIsToldFromAHandle) {
    // Both rings stand on the plane, the first's foot inside the second.
    const IndexedMesh first =
        test::rotated(test::torus(20, 3, 40, 16), Eigen::Vector3d::UnitX(), std::numbers::pi / 2);
    IndexedMesh second = test::rotated(first, Eigen::Vector3d::UnitZ(), std::numbers::pi / 2);
    second.V.col(0).array() += 20;
    const auto links = [](const std::vector<Obstruction>& found) {
        return std::count_if(found.begin(), found.end(), [](const Obstruction& obstruction) {
            return obstruction.kind == Obstruction::Kind::Link;
        });
    };
    const auto linked = obstructionsAt(test::together(first, second), level(0)).obstructions;
    EXPECT_EQ(linked.size(), 4U) << "four arches";
    EXPECT_EQ(links(linked), 2) << "on each side the second spans the first's foot";
    second.V.col(0).array() += 60;
    const auto apart = obstructionsAt(test::together(first, second), level(0)).obstructions;
    EXPECT_EQ(apart.size(), 4U);
    EXPECT_EQ(links(apart), 0);
}

TEST(Obstructions, NothingStandsInTheWayOfARingLyingFlat) {
    const IndexedMesh ring = test::torus(20, 5, 40, 16);
    EXPECT_TRUE(obstructionsAt(ring, level(0)).obstructions.empty());
    EXPECT_TRUE(planePasses(ring, level(0)));
}

TEST(Obstructions, AStandingRingIsAnArchOnBothSides) {
    const auto found = obstructionsAt(standingRing(), level(0)).obstructions;
    ASSERT_EQ(found.size(), 2U);
    for (const Obstruction& arch : found) {
        EXPECT_EQ(arch.kind, Obstruction::Kind::Handle);
        EXPECT_NE(arch.message.english().find("An arch"), std::string::npos);
        const double up = arch.side == 1 ? 1 : -1;
        EXPECT_LT((arch.place - Eigen::Vector3d(0, 0, up * 12.5)).norm(), 1);
        EXPECT_NEAR(arch.size, std::hypot(50, 10, 25), 2);
    }
    EXPECT_NE(found[0].side, found[1].side);
    EXPECT_FALSE(planePasses(standingRing(), level(0)));
}

TEST(Obstructions, EachTellsWhatWouldTakeItAwayAndWhatThatTakes) {
    DesignRequest request;
    request.part = std::make_shared<const IndexedMesh>(standingRing());
    request.plane = level(-17).plane;
    request.directionsChoice = DirectionsChoice::Normal;
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    ASSERT_FALSE(result->obstructions.empty());
    EXPECT_EQ(result->parted->faceCount(), static_cast<int>(result->partedLabels.size()));
    const Obstruction& handle = result->obstructions.front();
    const auto remedy = [&](Remedy::Kind kind) {
        const auto found = std::find_if(handle.remedies.begin(), handle.remedies.end(),
                                        [&](const Remedy& r) { return r.kind == kind; });
        return found == handle.remedies.end() ? nullptr : &*found;
    };
    const Remedy* plane = remedy(Remedy::Kind::Plane);
    ASSERT_NE(plane, nullptr);
    EXPECT_TRUE(planePasses(*request.part, *plane->state));
    EXPECT_FALSE(planePasses(*request.part, {*request.plane, {}}));
    const Remedy* fill = remedy(Remedy::Kind::Fill);
    ASSERT_NE(fill, nullptr);
    // The hole's own space, as far as it lies above the plane or needs a wall down to it.
    EXPECT_GT(fill->volume, 0.1 * volume(*request.part));
    EXPECT_LT(fill->volume, 40 * 10 * 40);
    EXPECT_EQ(remedy(Remedy::Kind::Merge), nullptr) << "nothing is apart";
}

TEST(Obstructions, APieceThatFloatsMayBeJoined) {
    DesignRequest request;
    request.part = std::make_shared<const IndexedMesh>(
        test::together(test::sphere({0, 0, 0}, 10, 3), test::sphere({0, 0, 22}, 8, 3)));
    request.plane = level(0).plane;
    request.directionsChoice = DirectionsChoice::Normal;
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    ASSERT_EQ(result->obstructions.size(), 1U);
    EXPECT_EQ(result->obstructions[0].kind, Obstruction::Kind::ClosedPiece);
    const auto& remedies = result->obstructions[0].remedies;
    const auto merge = std::find_if(remedies.begin(), remedies.end(),
                                    [](const Remedy& r) { return r.kind == Remedy::Kind::Merge; });
    ASSERT_NE(merge, remedies.end());
    EXPECT_GT(merge->volume, 0);
    EXPECT_NE(merge->message.english().find("joined"), std::string::npos);
}

TEST(Obstructions, ARingAboveThePlaneIsAHandle) {
    const auto found = obstructionsAt(standingRing(), level(-22)).obstructions;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, Obstruction::Kind::Handle);
    EXPECT_EQ(found[0].side, 1);
    const std::string words = found[0].message.english();
    EXPECT_NE(words.find("A handle"), std::string::npos) << words;
    EXPECT_NE(words.find("side 1"), std::string::npos) << words;
    EXPECT_NEAR(found[0].place.z(), 1.5, 1); // half way between 25 and −22
}

TEST(Obstructions, APartBesideThePlaneNeverMeetsIt) {
    const auto found = obstructionsAt(test::sphere({0, 0, 30}, 10, 2), level(0)).obstructions;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, Obstruction::Kind::ClosedPiece);
    EXPECT_LT((found[0].place - Eigen::Vector3d(0, 0, 30)).norm(), 1e-6);
}

TEST(Obstructions, PlacesAreInThePartsFrame) {
    const Eigen::Vector3d shift(100, -50, 7);
    IndexedMesh ring = standingRing();
    ring.V.rowwise() += shift.transpose();
    const auto found = obstructionsAt(ring, level(shift.z())).obstructions;
    ASSERT_EQ(found.size(), 2U);
    for (const Obstruction& arch : found)
        EXPECT_LT((arch.place - shift - Eigen::Vector3d(0, 0, arch.side == 1 ? 12.5 : -12.5)).norm(), 1);
}
