// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/binary_parts.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>

using namespace moldwright;
using namespace moldwright::test;

TEST(BinaryParts, AreLittleEndianWithTheirCountsFirst) {
    EXPECT_EQ(labelsPart({1, 2, 0}), std::string("\3\0\0\0\0\0\0\0\1\2\0", 11));
    EXPECT_EQ(numbersPart({1.0}), std::string("\1\0\0\0\0\0\0\0\0\0\0\0\0\0\xf0\x3f", 16));
}

TEST(BinaryParts, MeshesComeBackBitByBit) {
    const IndexedMesh ball = sphere({1, 2, 3}, 0.1, 2);
    const auto back = readMeshPart(meshPart(ball));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->V, ball.V);
    EXPECT_EQ(back->F, ball.F);
}

TEST(BinaryParts, WhatDoesNotFitIsRefused) {
    const IndexedMesh cube = box({0, 0, 0}, {1, 1, 1});
    std::string tooLong = meshPart(cube) + "x";
    EXPECT_FALSE(readMeshPart(tooLong).has_value());
    EXPECT_FALSE(readMeshPart("").has_value());
    std::string huge = meshPart(cube);
    huge[6] = 1; // 2^48 more points than there are
    EXPECT_FALSE(readMeshPart(huge).has_value());
    std::string negative = labelsPart({1});
    negative[7] = '\xff';
    EXPECT_FALSE(readLabelsPart(negative).has_value());
    EXPECT_FALSE(readLabelsPart(labelsPart({3})).has_value());
}

TEST(BinaryParts, IndicesAndNumbersAreChecked) {
    IndexedMesh cube = box({0, 0, 0}, {1, 1, 1});
    cube.F(3, 1) = 8;
    EXPECT_FALSE(readMeshPart(meshPart(cube)).has_value());
    cube.F(3, 1) = -1;
    EXPECT_FALSE(readMeshPart(meshPart(cube)).has_value());
    cube.F(3, 1) = 0;
    cube.V(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(readMeshPart(meshPart(cube)).has_value());
    EXPECT_FALSE(readNumbersPart(numbersPart({1, std::numeric_limits<double>::infinity()})).has_value());
}

TEST(BinaryParts, IndicesComeBackWhereTheyAscendBelowTheirEnd) {
    EXPECT_EQ(readIndicesPart(indicesPart({0, 4, 9}), 10), std::vector({0, 4, 9}));
    EXPECT_EQ(readIndicesPart(indicesPart({}), 0), std::vector<int>());
    EXPECT_FALSE(readIndicesPart(indicesPart({0, 4, 9}), 9));
    EXPECT_FALSE(readIndicesPart(indicesPart({4, 4}), 10));
    EXPECT_FALSE(readIndicesPart(indicesPart({-1, 4}), 10));
    EXPECT_FALSE(readIndicesPart(indicesPart({1, 4}).substr(1), 10));
}
