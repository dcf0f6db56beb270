// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/draft_cone.h"

#include "castability/mold_state.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <numbers>

using namespace moldwright;

namespace {

constexpr double kDraft = 3;
const Eigen::Vector2d kRun(0.3, -0.4);

/// Draft of the surface with this gradient over the plane sheared by kRun.
double draftOf(const Eigen::Vector2d& g) {
    const Eigen::Vector3d along(kRun.x(), kRun.y(), 1);
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX() + g.x() * along;
    const Eigen::Vector3d y = Eigen::Vector3d::UnitY() + g.y() * along;
    return draftDegrees(x.cross(y).normalized().dot(along.normalized()));
}

} // namespace

TEST(DraftCone, SteepnessOneIsTheDraft) {
    const DraftCone cone(kRun, kDraft);
    for (double angle = 0; angle < 6.3; angle += 0.3) {
        const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
        double low = 0;
        double high = 1000;
        for (int i = 0; i < 60; ++i)
            (cone.steepness((low + high) / 2 * u) <= 1 ? low : high) = (low + high) / 2;
        EXPECT_NEAR(draftOf(low * u), kDraft, 1e-9);
    }
}

TEST(DraftCone, TheConeItselfLeansByTheDraft) {
    const DraftCone cone(kRun, kDraft);
    for (double angle = 0; angle < 6.3; angle += 0.3) {
        const Eigen::Vector2d p(2 * std::cos(angle), 2 * std::sin(angle));
        const double h = 1e-5;
        const Eigen::Vector2d gradient(
            (cone.fall(p - Eigen::Vector2d(h, 0)) - cone.fall(p + Eigen::Vector2d(h, 0))) / (2 * h),
            (cone.fall(p - Eigen::Vector2d(0, h)) - cone.fall(p + Eigen::Vector2d(0, h))) / (2 * h));
        EXPECT_NEAR(draftOf(gradient), kDraft, 1e-5);
        EXPECT_LE(cone.fall(p.normalized() * cone.reach(1)), 1e6);
        EXPECT_GE(cone.fall(p.normalized() * cone.reach(1)), 1 - 1e-12);
    }
}

TEST(DraftCone, ARidgeIsTheHighestOfTheConesOnIt) {
    const DraftCone cone(kRun, kDraft);
    const Eigen::Vector2d along(3, 1);
    for (const auto& heights : {Eigen::Vector2d(10, 12), Eigen::Vector2d(10, 40), Eigen::Vector2d(90, 10)})
        for (double angle = 0; angle < 6.3; angle += 0.2) {
            const Eigen::Vector2d p = along / 3 + Eigen::Vector2d(2 * std::cos(angle), 2 * std::sin(angle));
            double highest = -1e9;
            for (int i = 0; i <= 10000; ++i) {
                const double t = i / 10000.0;
                highest =
                    std::max(highest, heights[0] + t * (heights[1] - heights[0]) - cone.fall(p - t * along));
            }
            EXPECT_NEAR(cone.ridge(along, heights, p), highest, 1e-2);
            EXPECT_GE(cone.ridge(along, heights, p), highest - 1e-9);
        }
}

TEST(DraftCone, GradientOfAPlane) {
    const Eigen::Vector2d g(0.7, -1.3);
    const Eigen::Vector2d a(1, 2);
    const Eigen::Vector2d b(4, 1);
    const Eigen::Vector2d c(2, 5);
    EXPECT_LT((gradientOf(a, b, c, {g.dot(a) + 3, g.dot(b) + 3, g.dot(c) + 3}) - g).norm(), 1e-12);
}
