// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/scene.h"

#include "mold/way_out.h"
#include "support/molds.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::scene;
using Eigen::Vector3d;

namespace {

/// A mold with made-up directions, opened in a scene.
class MoldInView {
public:
    explicit MoldInView(const std::optional<Vector3d>& direction1) {
        const test::KnownCast cast = test::frusta(20, 10, 5, 3, 0.2);
        Result<Mold> mold = test::moldOf(cast, {});
        if (direction1)
            mold->directions.d1 = *direction1;
        scene.setSurface(drawnMesh(std::make_shared<const IndexedMesh>(cast.mesh)), {});
        scene.setHalves(drawnMesh(mold->half1.mesh), drawnMesh(mold->half2.mesh), mold->partToMold.inverse(),
                        mold->directions);
        scene.setContacts(contactsOnTheWayOut(*mold, cast.mesh));
    }

    Scene scene;
};

} // namespace

TEST(Scene, AProvedMoldOpensWithoutContact) {
    MoldInView opened({});
    for (const double opening : {0.0, 0.02, 0.3, 1.0}) {
        opened.scene.setOpening({opening});
        EXPECT_EQ(opened.scene.facesMet(), 0) << opening;
    }
}

TEST(Scene, AHalfThatRunsIntoTheCastReddensItUntilItIsPast) {
    MoldInView opened(Vector3d(0.5, 0, 1).normalized());
    EXPECT_EQ(opened.scene.facesMet(), 0) << "closed";
    opened.scene.setOpening({0.05});
    EXPECT_EQ(opened.scene.facesMet(), 2);
    opened.scene.setFaceColours(std::vector<Rgb>(20, lightColours().part));
    EXPECT_EQ(opened.scene.facesMet(), 2) << "painted anew";
    opened.scene.setOpening({20});
    EXPECT_EQ(opened.scene.facesMet(), 0) << "far away";
    opened.scene.setOpening({0.05});
    opened.scene.setHalves(nullptr, nullptr, Eigen::Isometry3d::Identity(), {});
    EXPECT_EQ(opened.scene.facesMet(), 0) << "without halves";
}

TEST(Scene, AMoldLiesOpenLikeABookWithBothPartingFacesUp) {
    MoldInView opened({});
    const auto boxOf = [&](int side) {
        Eigen::AlignedBox3d box;
        for (const Vector3d& corner : cornersOf(opened.scene.half(side)->box))
            box.extend(opened.scene.placeOnHalf(side, corner));
        return box;
    };
    opened.scene.setOpening(openingAt(0.5));
    EXPECT_NEAR(boxOf(1).min().z(), -boxOf(2).max().z(), 1e-9) << "apart by as much";
    EXPECT_GT(boxOf(1).min().z(), 5);
    EXPECT_NEAR(boxOf(1).center().x(), boxOf(2).center().x(), 1e-9);

    opened.scene.setOpening(openingAt(1));
    EXPECT_NEAR(boxOf(1).max().z(), 0, 1e-9) << "turned over";
    EXPECT_NEAR(boxOf(2).max().z(), 0, 1e-9);
    EXPECT_TRUE(boxOf(1).intersection(boxOf(2)).isEmpty()) << "beside each other";
    // Each opens upwards now: what is above the plane in half 1 is below it.
    EXPECT_NEAR(opened.scene.placeOnHalf(1, {0, 0, 3}).z(), -3, 1e-9);
    EXPECT_NEAR(opened.scene.placeOnHalf(2, {0, 0, -3}).z(), -3, 1e-9);
    EXPECT_EQ(opened.scene.facesMet(), 0);
    for (const Vector3d& point : opened.scene.outline())
        EXPECT_TRUE(boxOf(1).merged(boxOf(2)).contains(point)) << "the cast is out of sight";

    opened.scene.setOpening({});
    EXPECT_NEAR(boxOf(1).min().z(), boxOf(2).max().z(), 1e-9) << "closed";
}
