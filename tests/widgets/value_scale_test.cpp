// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/value_scale.h"

#include "mesh/cluster.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace moldwright;
using namespace moldwright::scene;

namespace {

/// Lightness as the eye sees it, CIE L*.
double lightness(Rgb colour) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const auto [r, g, b] = colour.unit();
    const double y = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

} // namespace

TEST(ValueScale, TakesTheLeastRoundStepThatHoldsNearlyAll) {
    const auto stepFor = [](double largest) {
        std::vector<double> values(1000);
        std::iota(values.begin(), values.end(), 1);
        for (double& value : values)
            value *= largest / 990;
        return scaleFor(values).step;
    };
    EXPECT_NEAR(stepFor(7), 1, 1e-12);
    EXPECT_NEAR(stepFor(7.1), 2, 1e-12);
    EXPECT_NEAR(stepFor(14.1), 5, 1e-12);
    EXPECT_NEAR(stepFor(36), 10, 1e-12);
    EXPECT_NEAR(stepFor(0.03), 0.005, 1e-12);
    EXPECT_EQ(scaleFor(std::vector<double>(5, 0)).step, 1) << "nothing to show";
}

TEST(ValueScale, FacesWithoutAValueDoNotCount) {
    std::vector<double> values(100000, 0);
    values[17] = 6;
    EXPECT_NEAR(scaleFor(values).step, 1, 1e-12);
}

TEST(ValueScale, TheLastClassTakesAllThatIsMore) {
    const ValueScale scale{2};
    EXPECT_EQ(scale.classOf(0), 0);
    EXPECT_EQ(scale.classOf(1.99), 0);
    EXPECT_EQ(scale.classOf(2), 1);
    EXPECT_EQ(scale.classOf(13), 6);
    EXPECT_EQ(scale.classOf(1e9), 6);
    EXPECT_EQ(scale.classOf(-1e-12), 0);
}

TEST(ValueScale, ReadsInGrey) {
    for (std::size_t c = 1; c < valueColours().size(); ++c)
        EXPECT_LT(lightness(valueColours()[c]), lightness(valueColours()[c - 1]) - 9) << c;
    for (std::size_t c = 1; c < draftClassColours().size(); ++c)
        EXPECT_GT(lightness(draftClassColours()[c]), lightness(draftClassColours()[c - 1]) + 6) << c;
}

TEST(CarriedOver, ACoarserMeshTellsTheSame) {
    const IndexedMesh fine = test::sphere({0, 0, 0}, 10, 5);
    const IndexedMesh coarse = cluster(fine, 2000);
    std::vector<double> heights(static_cast<std::size_t>(fine.faceCount()));
    for (int f = 0; f < fine.faceCount(); ++f)
        heights[static_cast<std::size_t>(f)] = fine.corner(f, 0).z();
    const std::vector<double> carried = carriedOver(fine, heights, coarse);
    ASSERT_EQ(carried.size(), static_cast<std::size_t>(coarse.faceCount()));
    for (int f = 0; f < coarse.faceCount(); ++f)
        EXPECT_NEAR(carried[static_cast<std::size_t>(f)], coarse.corner(f, 0).z(), 1.2) << f;
}
