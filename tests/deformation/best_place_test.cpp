// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/best_place.h"

#include "castability/mold_state.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace moldwright;

namespace {

const double kTau = std::sin(radians(2));

/// The objective as best_place.h states it.
double worstSpare(const std::vector<FaceToPlace>& faces, const Eigen::Vector3d& v) {
    double worst = std::numeric_limits<double>::infinity();
    for (const FaceToPlace& face : faces) {
        const Eigen::Vector3d c = (face.a - v).cross(face.b - v);
        worst = std::min(worst, (c.dot(face.direction) - kTau * c.norm()) / (face.b - face.a).norm());
    }
    return worst;
}

/// The faces of a fan over a closed polygon, all looking along `direction`.
std::vector<FaceToPlace> fan(const std::vector<Eigen::Vector3d>& rim, const Eigen::Vector3d& direction) {
    std::vector<FaceToPlace> faces;
    for (std::size_t i = 0; i < rim.size(); ++i)
        faces.push_back({rim[i], rim[(i + 1) % rim.size()], direction});
    return faces;
}

} // namespace

TEST(BestPlace, IsTheMiddleOfASquareAsLowAsAllowed) {
    const auto faces = fan({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d place = bestPlace(faces, {0.05, 0.1, 0.8}, {2, 0.2, 1}, kTau);
    EXPECT_NEAR(place.x(), 0.5, 0.02);
    EXPECT_NEAR(place.y(), 0.5, 0.02);
    EXPECT_GE(place.z(), 0.2);
    EXPECT_GT(worstSpare(faces, place), 0.47);
}

TEST(BestPlace, IsOnTheLowerSideForADirectionThatLooksDown) {
    const auto faces = fan({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, -Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d place = bestPlace(faces, {0.9, 0.9, -0.5}, {2, -1, -0.1}, kTau);
    EXPECT_NEAR(place.x(), 0.5, 0.02);
    EXPECT_LE(place.z(), -0.1);
}

/// Nothing found by chance in the bounds is better, also where no place is good.
TEST(BestPlace, IsNotBeatenByAnyOfManyOthers) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    int feasible = 0;
    for (int trial = 0; trial < 60; ++trial) {
        std::vector<Eigen::Vector3d> rim;
        const int corners = 3 + trial % 6;
        for (int i = 0; i < corners; ++i) {
            const double angle = 6.283 * (i + 0.7 * unit(random)) / corners;
            rim.push_back(Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.4 * unit(random)));
        }
        const Eigen::Vector3d direction =
            Eigen::Vector3d(0.5 * unit(random), 0.5 * unit(random), 1).normalized();
        const auto faces = fan(rim, direction);
        const Eigen::Vector3d start(0.3 * unit(random), 0.3 * unit(random), 0.5);
        const Eigen::Vector3d place = bestPlace(faces, start, {2, 0.1, 1}, kTau);
        const double found = worstSpare(faces, place);
        feasible += found > 0;
        EXPECT_GE(found, worstSpare(faces, start));
        for (int k = 0; k < 2000; ++k) {
            const Eigen::Vector3d other = start + 1.1 * Eigen::Vector3d(unit(random), unit(random), 0);
            EXPECT_GE(found + 0.03, worstSpare(faces, {other.x(), other.y(), 0.55 + 0.45 * unit(random)}));
        }
    }
    EXPECT_GT(feasible, 20);
    EXPECT_LT(feasible, 60);
}
