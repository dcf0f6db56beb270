// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/point_groups.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;
using namespace moldwright::test;

TEST(PointGroups, HoldEveryPointOnceInTightBoxes) {
    // Of the two balls many points are the same: groups must end there too.
    const IndexedMesh twice = together(sphere({1, 2, 3}, 5, 4), sphere({1, 2, 3}, 5, 4));
    for (const int most : {1, 7, 64, 1'000'000}) {
        std::vector<int> all;
        for (const PointGroup& group : groupsOfPoints(twice.V, most)) {
            ASSERT_FALSE(group.points.empty());
            EXPECT_LE(static_cast<int>(group.points.size()), most);
            EXPECT_TRUE(std::is_sorted(group.points.begin(), group.points.end()));
            Eigen::AlignedBox3d box;
            for (const int v : group.points)
                box.extend(twice.point(v));
            EXPECT_EQ(box.min(), group.box.min());
            EXPECT_EQ(box.max(), group.box.max());
            all.insert(all.end(), group.points.begin(), group.points.end());
        }
        std::sort(all.begin(), all.end());
        ASSERT_EQ(static_cast<int>(all.size()), twice.vertexCount());
        for (int v = 0; v < twice.vertexCount(); ++v)
            EXPECT_EQ(all[static_cast<std::size_t>(v)], v);
    }
    EXPECT_TRUE(groupsOfPoints(Points(0, 3)).empty());
}

TEST(PointGroups, LieTogether) {
    const IndexedMesh ball = sphere({0, 0, 0}, 1, 5);
    double widest = 0;
    for (const PointGroup& group : groupsOfPoints(ball.V))
        widest = std::max(widest, group.box.sizes().maxCoeff());
    EXPECT_LT(widest, 0.6) << "of a ball of 4,098 points, 64 near ones at a time";
}
