// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/lasso.h"

#include "base/task.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::scene;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr ViewSize view{800, 600};

/// All of the view.
Lasso wholeView(const Vector3d& from) {
    return {{{0, 0}, {800, 0}, {800, 600}, {0, 600}}, lookingFrom({}, from), view, {}};
}

SharedMesh shared(const IndexedMesh& mesh) {
    return std::make_shared<const IndexedMesh>(mesh);
}

} // namespace

TEST(Lasso, KnowsWhatIsInsideAHollowLine) {
    const std::vector<Vector2d> hook = {{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {0, 10}};
    EXPECT_TRUE(isInside(hook, {5, 5}));
    EXPECT_TRUE(isInside(hook, {25, 25}));
    EXPECT_FALSE(isInside(hook, {10, 20})) << "in the hook's hollow";
    EXPECT_FALSE(isInside(hook, {40, 5}));
    EXPECT_FALSE(isInside({}, {0, 0}));
}

TEST(Lasso, TakesOnlyFacesThatAreSeen) {
    // A small ball hidden behind a large one.
    const IndexedMesh front = test::sphere(Vector3d(10, 0, 0), 6, 3);
    const SharedMesh both = shared(test::together(front, test::sphere(Vector3d(-10, 0, 0), 3, 3)));
    const std::vector<int> faces = facesIn(wholeView(Vector3d::UnitX()), both, {});
    ASSERT_GT(faces.size(), 100U);
    for (const int f : faces) {
        EXPECT_LT(f, front.faceCount()) << "of the ball in front";
        EXPECT_GT(doubleAreaVector(*both, f).x(), 0) << "on its near side";
    }
    for (const int f : facesIn(wholeView(-Vector3d::UnitX()), both, {}))
        EXPECT_LT(doubleAreaVector(*both, f).x(), 0);
}

TEST(Lasso, TakesWhatASectionLaysOpenAndNotWhatItCutsAway) {
    const SharedMesh ball = shared(test::sphere(Vector3d::Zero(), 6, 3));
    Lasso lasso = wholeView(Vector3d::UnitX());
    const std::size_t all = facesIn(lasso, ball, {}).size();
    lasso.cut = PartingPlane{Vector3d::UnitZ(), 0};
    const std::vector<int> below = facesIn(lasso, ball, {});
    EXPECT_LT(below.size(), all * 6 / 10);
    for (const int f : below)
        EXPECT_LT(ball->corner(f, 0).z() + ball->corner(f, 1).z() + ball->corner(f, 2).z(), 0);
}
