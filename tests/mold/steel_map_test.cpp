// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/steel_map.h"

#include "base/parallel.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector3d;

namespace {

const double lean = std::tan(radians(5));

/// Area of the walls and the lid of a frustum over a × b, height h, lean l.
double wallArea(double a, double b, double h, double l) {
    const double top = (a - 2 * l * h) * (b - 2 * l * h);
    return top + (2 * a + 2 * b - 4 * l * h) * h * std::hypot(1, l);
}

double areaOf(const SteelMap& map) {
    double area = 0;
    for (const double part : map.areas)
        area += part;
    return area;
}

/// Each wall has the least of `steel` at its corners.
void expectSteel(const SteelMap& map, const std::function<double(const Vector3d&)>& steel) {
    for (int f = 0; f < map.surface->faceCount(); ++f) {
        const double thickness = map.thickness[static_cast<std::size_t>(f)];
        if (thickness < 0)
            continue;
        double least = map.beyond();
        for (int k = 0; k < 3; ++k)
            least = std::min(least, steel(map.surface->corner(f, k)));
        ASSERT_NEAR(thickness, least, 1e-5) << map.surface->corner(f, 0).transpose();
    }
}

/// The thinnest steel of both maps.
double leastOf(const Mold& mold) {
    return std::min(steelMap(mold, 1)->least, steelMap(mold, 2)->least);
}

} // namespace

TEST(SteelMap, OfADraftedBoxIsWhatTheHandCalculates) {
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), {});
    expectVerified(mold);
    const Result<SteelMap> map = steelMap(*mold, 1);
    ASSERT_TRUE(map);
    EXPECT_TRUE(diagnose(*map->surface).usable());
    // Walls of 5 mm at the plane; the ceiling is 10 mm above it.
    expectSteel(*map, [](const Vector3d& p) { return std::min(5 + lean * p.z(), 10 - p.z()); });
    EXPECT_NEAR(map->least, 5, 1e-6);
    EXPECT_NEAR(areaOf(*map), wallArea(20, 10, 5, lean), 1e-3) << "walls of the cavity, and nothing else";
    // With the limit of 2 mm classes are 1 mm wide: all of it has 5 to 6 mm.
    EXPECT_NEAR(map->areas[4], areaOf(*map), 1e-9);
    const Result<SteelMap> other = steelMap(*mold, 2);
    EXPECT_NEAR(areaOf(*other), wallArea(20, 10, 3, lean), 1e-3);
    // Down to 3 mm there is the floor, 8 mm below the plane, and the walls.
    expectSteel(*other, [](const Vector3d& p) { return std::min(5 - lean * p.z(), 8 + p.z()); });
}

TEST(SteelMap, ShowsWhatIsThinnerThanTheLimit) {
    MoldSettings settings;
    settings.ceiling = 1.5;
    settings.step = 0;
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    ASSERT_TRUE(mold);
    const SteelMap map = *steelMap(*mold, 1);
    expectSteel(map, [](const Vector3d& p) { return std::min(5 + lean * p.z(), 6.5 - p.z()); });
    EXPECT_NEAR(map.least, 1.5, 1e-5);
    const double lid = (20 - 10 * lean) * (10 - 10 * lean);
    // Besides the lid all wall faces that reach within 2 mm of the ceiling, so those that begin above 4.5 mm
    // and those that only touch: faces have edges of half a millimetre.
    EXPECT_GT(map.areas[0], lid);
    EXPECT_LT(map.areas[0], lid + 60 * 1.1);
    EXPECT_NEAR(map.leastPlace.z(), 5, 0.5);
}

TEST(SteelMap, BetweenCavitiesIsTheirDistance) {
    MoldSettings settings;
    settings.layout = {1, 2, Arrangement::Grid, Alternation::None, 4};
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    ASSERT_TRUE(mold);
    const SteelMap map = *steelMap(*mold, 1);
    EXPECT_NEAR(map.least, 4, 1e-6);
    EXPECT_NEAR(std::abs(map.leastPlace.x()), 2, 0.2) << "at the walls that face each other";
    // From x = −2 − lean·z the other wall is nearest at its foot, or square to it.
    for (int f = 0; f < map.surface->faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            const Vector3d p = map.surface->corner(f, k);
            const double thickness = map.thickness[static_cast<std::size_t>(f)];
            if (thickness >= 0 && p.z() == 0 && std::abs(std::abs(p.x()) - 2) < 1e-6) {
                ASSERT_NEAR(thickness, 4, 1e-6);
            } else if (thickness >= 0 && std::abs(p.x()) > 11) {
                ASSERT_GE(thickness, 5 - 1e-6) << "the far walls have the outside's";
            }
        }
}

TEST(SteelMap, OfAFlatBackIsThePlateBehindIt) {
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 0, lean), {});
    ASSERT_TRUE(mold);
    const SteelMap map = *steelMap(*mold, 2);
    EXPECT_NEAR(areaOf(map), 200, 1e-3);
    expectSteel(map, [](const Vector3d& /*p*/) { return 5.0; });
}

TEST(SteelMap, AgreesWithTheThinnestSteelThatIsTold) {
    MoldSettings standing = everyFeature();
    standing.layout = {2, 2, Arrangement::Grid, Alternation::None, 3};
    standing.bolts.count = 2;
    MoldSettings lying = everyFeature();
    lying.spout.resting = Resting::Lying;
    lying.slits.count = 0;
    lying.ejectors.count = 2;
    for (const MoldSettings& settings : {standing, lying})
        for (const KnownCast& cast :
             {frusta(40, 30, 8, 6, lean), ball(15, 3), sheared(ball(15, 3), 0.3, -0.2)}) {
            const Result<Mold> mold = moldOf(cast, settings);
            ASSERT_TRUE(mold) << mold.error().english();
            EXPECT_NEAR(leastOf(*mold), mold->minWall, 0.02);
        }
}

TEST(SteelMap, KeysAreNoWalls) {
    MoldSettings settings;
    settings.keys.count = 4;
    settings.keys.clearance = 0; // their walls touch those of their sockets
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), settings);
    ASSERT_TRUE(mold);
    const SteelMap map = *steelMap(*mold, 2);
    for (int f = 0; f < map.surface->faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (map.thickness[static_cast<std::size_t>(f)] >= 0) {
                ASSERT_LE(map.surface->corner(f, k).z(), 0);
            }
    EXPECT_GT(areaOf(*steelMap(*mold, 1)), wallArea(20, 10, 5, lean) + 100) << "their sockets are";
}

TEST(SteelMap, IsTheSameForAnyNumberOfThreads) {
    const Result<Mold> mold = moldOf(ball(15, 3), everyFeature());
    ASSERT_TRUE(mold);
    setThreadCount(1);
    const SteelMap one = *steelMap(*mold, 1);
    setThreadCount(4);
    const SteelMap four = *steelMap(*mold, 1);
    setThreadCount(0);
    EXPECT_EQ(one.thickness, four.thickness);
    EXPECT_EQ(one.surface->V, four.surface->V);
}

TEST(SteelMap, CanBeCancelled) {
    const Result<Mold> mold = moldOf(frusta(20, 10, 5, 3, lean), {});
    ASSERT_TRUE(mold);
    const Task task;
    task.cancel();
    const Result<SteelMap> map = steelMap(*mold, 1, task);
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().code, ErrorCode::Cancelled);
}

TEST(SteelScale, HasItsLimitAtABorderOfClasses) {
    const SteelScale scale{2};
    EXPECT_EQ(scale.classOf(0), 0);
    EXPECT_EQ(scale.classOf(1.999), 0);
    EXPECT_EQ(scale.classOf(2), 1);
    EXPECT_EQ(scale.classOf(3), 2);
    EXPECT_EQ(scale.classOf(6.5), 5);
    EXPECT_EQ(scale.classOf(100), 6);
    EXPECT_EQ(SteelScale{0}.classOf(0), 1) << "without a limit nothing is below it";
}
