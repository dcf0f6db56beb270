// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/hollow_casting.h"

#include "mesh/measures.h"
#include "mold/mold_files.h"
#include "support/casts.h"
#include "support/molds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace moldwright;
using namespace moldwright::test;

TEST(HollowCasting, KeepsTheWallOfABox) {
    const double whole = 40 * 30 * 20;
    const double inner = 36 * 26 * 16;
    EXPECT_NEAR(shellVolume(box({0, 0, 0}, {40, 30, 20}), 2), whole - inner, 0.01 * whole);
}

TEST(HollowCasting, KeepsTheWallOfABall) {
    const IndexedMesh round = sphere({1, 2, 3}, 20, 4);
    const double whole = volume(round);
    EXPECT_NEAR(shellVolume(round, 3) / whole, 1 - std::pow(17.0 / 20, 3), 0.01);
}

TEST(HollowCasting, OfAThinWallIsItsSurfaceTimesItsThickness) {
    for (const double wall : {0.2, 0.5}) {
        const double inner = (40 - 2 * wall) * (30 - 2 * wall) * (20 - 2 * wall);
        const double byHand = 40 * 30 * 20 - inner;
        EXPECT_NEAR(shellVolume(box({0, 0, 0}, {40, 30, 20}), wall), byHand, 0.03 * byHand) << wall;
        const IndexedMesh round = sphere({1, 2, 3}, 20, 5);
        const double shell = volume(round) * (1 - std::pow(1 - wall / 20, 3));
        EXPECT_NEAR(shellVolume(round, wall), shell, 0.03 * shell) << wall;
    }
}

TEST(HollowCasting, OfThickWallsIsSolid) {
    const IndexedMesh slab = box({0, 0, 0}, {40, 30, 6});
    EXPECT_NEAR(shellVolume(slab, 4), volume(slab), 1e-9);
}

TEST(HollowCasting, IsToldWithItsMass) {
    MoldSettings settings;
    settings.layout.columns = 2;
    settings.hollow.wall = 2;
    settings.density = 1.2;
    const Result<Mold> mold = moldOf(frusta(40, 30, 10, 10, 0.02), settings);
    expectVerified(mold);
    const auto hollow = nlohmann::json::parse(moldJson(*mold))["shot"]["hollow"];
    EXPECT_EQ(hollow["wall"], 2.0);
    EXPECT_NEAR(hollow["volume_cm3"].get<double>() + hollow["poured_out_cm3"].get<double>(),
                mold->cavityVolume / 1000, 1e-9);
    EXPECT_NEAR(hollow["mass_each_g"].get<double>(), hollow["volume_cm3"].get<double>() * 1.2 / 2, 1e-9);
    EXPECT_GT(hollow["poured_out_cm3"].get<double>(), 0.4 * mold->cavityVolume / 1000);
}
