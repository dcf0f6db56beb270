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
class OpenedMold {
public:
    explicit OpenedMold(const std::optional<Vector3d>& direction1) {
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
    OpenedMold opened({});
    for (const double opening : {0.0, 0.02, 0.3, 1.0}) {
        opened.scene.setOpening(opening);
        EXPECT_EQ(opened.scene.facesMet(), 0) << opening;
    }
}

TEST(Scene, AHalfThatRunsIntoTheCastReddensItUntilItIsPast) {
    OpenedMold opened(Vector3d(0.5, 0, 1).normalized());
    EXPECT_EQ(opened.scene.facesMet(), 0) << "closed";
    opened.scene.setOpening(0.05);
    EXPECT_EQ(opened.scene.facesMet(), 2);
    opened.scene.setFaceColours(std::vector<Rgb>(20, lightColours().part));
    EXPECT_EQ(opened.scene.facesMet(), 2) << "painted anew";
    opened.scene.setOpening(20);
    EXPECT_EQ(opened.scene.facesMet(), 0) << "far away";
    opened.scene.setOpening(0.05);
    opened.scene.setHalves(nullptr, nullptr, Eigen::Isometry3d::Identity(), {});
    EXPECT_EQ(opened.scene.facesMet(), 0) << "without halves";
}
