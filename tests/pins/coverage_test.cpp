// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/coverage.h"

#include "known_axes.h"

#include "mesh/measures.h"
#include "pins/surface_samples.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;

TEST(Coverage, TheCornersOfABoxAreReachedAfterRepair) {
    const IndexedMesh mesh = box({-1, -0.6, -0.3}, {1, 0.6, 0.3});
    const double size = diagonal(mesh);
    const Points samples = surfaceSamples(mesh, 0, 7);
    MedialMesh axis = reducedAxis(mesh, 40);
    EXPECT_GT(missOf(axis, samples).outside, 0.04 * size);
    const MedialMesh whole = wholeAxis(mesh);
    for (const MedialBall& ball : missingBalls(samples, whole, axis.balls, 0.03 * size, 500))
        axis.balls.push_back(ball);
    const Miss miss = missOf(axis, samples);
    EXPECT_LT(miss.outside, 0.04 * size);
    EXPECT_LT(miss.inside, 0.04 * size);
}

TEST(Coverage, AddsNothingWhereAllIsReachedAndNoMoreThanAllowed) {
    const IndexedMesh mesh = capsule(0.25, 1, 48, 40);
    const Points samples = surfaceSamples(mesh, 0, 7);
    const MedialMesh axis = reducedAxis(mesh, 200);
    EXPECT_TRUE(missingBalls(samples, axis, axis.balls, 0.01, 40).empty());
    EXPECT_EQ(missingBalls(samples, axis, {}, 0.0001, 3).size(), 3u);
    // One ball after the other, until none is farther than asked.
    const std::vector<MedialBall> all = missingBalls(samples, axis, {}, 0.1, 1000);
    EXPECT_LT(all.size(), 30u);
    EXPECT_LT(missOf({all, {}, {}}, samples).outside, 0.1 + 1e-12);
}
