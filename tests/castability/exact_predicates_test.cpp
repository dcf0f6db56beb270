// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/exact_predicates.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moldwright;
using Eigen::Vector3d;

TEST(ExactPredicates, TurnsAreExactNextToALine) {
    // Kettner et al. 2008: points within ulps of the line x = y, where floating point answers at random.
    const double ulp = std::ldexp(1.0, -53);
    const Vector3d b(12, 12, 7);
    const Vector3d c(24, 24, -3);
    for (int i = 0; i < 32; ++i)
        for (int j = 0; j < 32; ++j) {
            const Vector3d a(0.5 + i * ulp, 0.5 + j * ulp, 1);
            EXPECT_EQ(turnAlong(a, b, c, Vector3d::UnitZ()), (j > i) - (j < i)) << i << " " << j;
            EXPECT_EQ(turnAlong(a, b, c, -Vector3d::UnitZ()), (j < i) - (j > i)) << i << " " << j;
        }
}

TEST(ExactPredicates, PositionsAlongADirectionAreEqualOnIt) {
    const Vector3d d(0.1, 0.7, -0.3);
    const Vector3d p(1, 2, 3);
    const Vector3d q(1 + 0.1 * 8, 2 + 0.7 * 8, 3 - 0.3 * 8); // on p + 8d, but for rounding
    for (const int axis : {0, 1}) {
        EXPECT_EQ(compareAlong(p, p, d, axis), 0);
        EXPECT_EQ(compareAlong(p, q, d, axis), -compareAlong(q, p, d, axis));
        EXPECT_NEAR(positionAlong(p, d)[axis], positionAlong(q, d)[axis], 1e-14);
    }
    // Powers of two are exact: the images coincide.
    EXPECT_EQ(compareAlong({0, 0, 0}, {0.25, 1, -0.5}, {0.25, 1, -0.5}, 0), 0);
    EXPECT_EQ(compareAlong({0, 0, 0}, {0.25, 1, -0.5}, {0.25, 1, -0.5}, 1), 0);
}

TEST(ExactPredicates, TheImageTurnsAsTheFaceDoes) {
    const Vector3d a(0, 0, 0);
    const Vector3d b(1, 0.2, 0.1);
    const Vector3d c(0.3, 1, -0.4);
    for (const Vector3d& d : {Vector3d(0.1, 0.2, 1), Vector3d(0.1, 0.2, -1), Vector3d(1, -0.3, 0.2),
                              Vector3d(-1, 0.3, 0.2), Vector3d(0.2, 1, 0.3), Vector3d(0.2, -1, 0.3)}) {
        const Eigen::Vector2d e = positionAlong(b, d) - positionAlong(a, d);
        const Eigen::Vector2d f = positionAlong(c, d) - positionAlong(a, d);
        const double turn = e.x() * f.y() - e.y() * f.x();
        EXPECT_EQ(turnAlong(a, b, c, d), turn > 0 ? 1 : -1) << d.transpose();
        EXPECT_EQ(compareAlong(a, b, d, 0), e.x() > 0 ? 1 : -1);
        EXPECT_EQ(compareAlong(a, b, d, 1), e.y() > 0 ? 1 : -1);
    }
}

TEST(ExactPredicates, LeavingIsDecidedExactlyAtTheBound) {
    // Normal (3, 0, 4)/5 against z: N·d = 4/5.
    const Vector3d a(0, 0, 0);
    const Vector3d b(4, 0, -3);
    const Vector3d c(0, 1, 0);
    const Vector3d up = Vector3d::UnitZ();
    const double below = std::nextafter(0.8, 0.0); // 0.8 itself is above 4/5
    EXPECT_TRUE(leavesAlong(a, b, c, up, below));
    EXPECT_FALSE(leavesAlong(a, b, c, up, 0.8));
    EXPECT_TRUE(leavesAlong(a, b, c, 3 * up, below));
    EXPECT_FALSE(leavesAlong(a, c, b, up, 0));
    EXPECT_FALSE(leavesAlong(a, b, b, up, 0));
}

TEST(ExactPredicates, AnswersDoNotDependOnWhereTheFaceBegins) {
    const Vector3d d(0.3, -0.2, 0.9);
    for (int i = 1; i < 200; ++i) {
        // Three points on a line in the image, up to rounding.
        const Vector3d way(std::sin(i), std::cos(3.0 * i), 0.1 * i);
        const Vector3d a(0.1 * i, 0.2, 0.3);
        const Vector3d b = a + way / 3;
        const Vector3d c = a + 0.7 * way + std::sin(7.0 * i) * d;
        EXPECT_EQ(turnAlong(a, b, c, d), turnAlong(b, c, a, d)) << i;
        EXPECT_EQ(turnAlong(a, b, c, d), -turnAlong(b, a, c, d)) << i;
    }
}

TEST(ExactPredicates, ThinFacesHaveAccurateAreas) {
    for (int i = 1; i < 50; ++i) {
        const Vector3d a(0.1, 0.2, 0.3 * i);
        const Vector3d way(std::sin(i), std::cos(3.0 * i), 0.1);
        const Vector3d b = a + way / 3;
        const Vector3d c = a + 0.7 * way;
        const Vector3d area = accurateAreaVector(a, b, c);
        EXPECT_LE((area - accurateAreaVector(b, c, a)).norm(), 1e-15 * area.norm()) << i;
    }
}
