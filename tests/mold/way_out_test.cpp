// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/way_out.h"

#include "support/molds.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

TEST(WayOut, IsFreeWhereTheMoldIsProved) {
    for (const double shrink : {0.0, 2.0}) {
        MoldSettings settings = everyFeature();
        settings.shrink.percent.setConstant(shrink);
        settings.shrink.origin = {150, 0, -40}; // far from the part, which goes away from it
        const KnownCast cast = moved(sheared(ball(15, 4), 0.2, -0.1), Vector3d(1, 2, 3).normalized(), 0.7,
                                     Vector3d(30, -20, 10));
        const Result<Mold> mold = moldOf(cast, settings, 0.5);
        ASSERT_NO_FATAL_FAILURE(expectVerified(mold));
        for (const ContactWays& half : contactsOnTheWayOut(*mold, cast.mesh))
            EXPECT_FALSE(half.any()) << shrink;
    }
}

TEST(WayOut, IsBarredAlongAnotherDirection) {
    const KnownCast cast = frusta(20, 10, 5, 3, 0.2);
    Result<Mold> mold = moldOf(cast, {});
    ASSERT_TRUE(mold.has_value());
    mold->directions.d1 = Vector3d(0.5, 0, 1).normalized(); // walls lean by 0.2 only
    const auto ways = contactsOnTheWayOut(*mold, cast.mesh);
    EXPECT_FALSE(ways[1].any());
    int met = 0;
    for (int f = 0; f < cast.mesh.faceCount(); ++f)
        if (ways[0].touches(static_cast<std::size_t>(f), 1)) {
            ++met;
            EXPECT_LT((mold->partToMold.linear() * doubleAreaVector(cast.mesh, f)).dot(mold->directions.d1),
                      0);
        }
    EXPECT_EQ(met, 2) << "the wall that the half runs into";
}
