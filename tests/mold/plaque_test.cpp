// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/plaque.h"

#include "mesh/measures.h"
#include "mold/section.h"
#include "support/casts.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const double lean = std::tan(radians(5));

MoldSettings lettered(const std::string& text) {
    MoldSettings settings;
    settings.plaque.text = text;
    return settings;
}

Block plate() {
    return uprightBlock({Vector3d(-40, -30, -10), Vector3d(40, 30, 12)});
}

Result<Plaque> lettersOn(int side, const std::string& text, double height, const Obstacles& openings = {}) {
    PlaqueSettings settings;
    settings.height = height;
    Block block = plate();
    block.body.grid = std::ldexp(1.0, -16);
    return plaqueOn(settings, {text}, side, block, openings, 5, 2);
}

double areaOf(const PlanShape& shape) {
    double doubled = 0;
    for (std::size_t k = 0; k < shape.size(); ++k)
        doubled += shape[k].x() * shape[(k + 1) % shape.size()].y() -
                   shape[k].y() * shape[(k + 1) % shape.size()].x();
    return doubled / 2;
}

/// The middle of a plaque's points, seen along z.
Vector2d heaviest(const PlanShape& shape) {
    Vector2d sum = Vector2d::Zero();
    for (const Vector2d& p : shape)
        sum += p / static_cast<double>(shape.size());
    return sum;
}

} // namespace

TEST(Plaque, HasTheVolumeCalculatedByHand) {
    // An I is one groove: a frustum 1 by 6 mm at the back, 0.6 mm deep, with walls of 5°.
    const Result<Plaque> plaque = lettersOn(1, "I", 7);
    ASSERT_TRUE(plaque) << plaque.error().english();
    const double narrower = 2 * 0.6 * lean;
    EXPECT_NEAR(volume(plaque->solid()), 0.6 * (6 - 7 * narrower / 2 + narrower * narrower / 3), 1e-3);
    const Eigen::AlignedBox3d box = boundingBox(plaque->solid());
    EXPECT_NEAR(box.max().z(), 12, 1e-9) << "open at the back";
    EXPECT_NEAR(box.min().z(), 12 - 0.6, 1e-4);
    EXPECT_NEAR(boundingBox(lettersOn(2, "I", 7)->solid()).min().z(), -10, 1e-9);
}

TEST(Plaque, IsReadFromOutside) {
    // The stem of an L stands left of its foot's end: seen from above that is −x, seen from below +x.
    for (const int side : {1, 2}) {
        const Result<Plaque> plaque = lettersOn(side, "L", 7);
        ASSERT_TRUE(plaque);
        ASSERT_EQ(plaque->strokes.size(), 1U);
        const PlanShape& shape = plaque->strokes.front().base;
        EXPECT_GT(areaOf(shape), 0) << "counter-clockwise from side 1";
        double stemX = 0;
        for (const Vector2d& p : shape)
            if (p.y() > plaque->place.y() + 3)
                stemX = p.x();
        const double way = stemX - plaque->place.x();
        EXPECT_TRUE(side == 1 ? way < -1 : way > 1) << side << ' ' << way;
    }
    // The first of two letters lies left of the second one.
    for (const int side : {1, 2}) {
        const Result<Plaque> plaque = lettersOn(side, "LI", 7);
        const double way = heaviest(plaque->strokes[1].base).x() - heaviest(plaque->strokes[0].base).x();
        EXPECT_TRUE(side == 1 ? way > 0 : way < 0) << side;
    }
}

TEST(Plaque, OfBothHalvesIsProvedAndAddsUp) {
    MoldSettings settings = lettered("Rabbit 7|half {half}|shrink {shrink} %");
    settings.shrink.percent.setConstant(1.5);
    const Result<Mold> mold = moldOf(frusta(60, 40, 8, 6, lean), settings);
    expectVerified(mold);
    EXPECT_EQ(count(*mold, "plaque"), 2);
    double engraved = 0;
    for (const MoldFeature& feature : mold->features)
        if (feature.kind == "plaque") {
            const int side = feature.name.back() - '0';
            EXPECT_EQ(feature.note.english(),
                      "Reads: Rabbit 7 | half " + std::to_string(side) + " | shrink 1.5 %");
            for (const auto& [key, value] : feature.numbers)
                engraved += key == "volume" ? value : 0;
        }
    EXPECT_GT(engraved, 10);
    EXPECT_NEAR(mold->otherVolume, engraved, 1e-9);
    EXPECT_EQ(lettered("Rabbit 7|half {half}").plaque.text, "Rabbit 7|half {half}");
}

TEST(Plaque, GoesWithEveryFeatureAlongObliqueDirections) {
    const KnownCast cast = sheared(ball(25, 4), 0.3, -0.2);
    MoldSettings settings = everyFeature();
    settings.bolts.count = 4;
    settings.plaque.text = "A1";
    expectVerified(moldOf(cast, settings));
    settings.spout.resting = Resting::Lying;
    settings.ejectors.count = 2;
    const Result<Mold> lying = moldOf(cast, settings);
    expectVerified(lying);
    for (const ThinSteel& thin : lying->steelOfEach)
        if (thin.first == "Plaque" || thin.second == "Plaque") {
            EXPECT_GE(thin.thickness, 2 - 1e-6) << thin.first << ' ' << thin.second;
        }
}

TEST(Plaque, KeepsClearOfWhatOpensThere) {
    const PlanShape middle = planRectangle({-5, -5}, {5, 5});
    const Result<Plaque> plaque = lettersOn(1, "AB", 7, {middle});
    ASSERT_TRUE(plaque);
    for (const DraftedPrism& stroke : plaque->strokes)
        EXPECT_GE(planDistance(stroke.base, middle), 2 - 1e-3);
    EXPECT_EQ(lettersOn(1, "AB", 7)->place, Vector2d(0, 0)) << "else in the middle";
}

TEST(Plaque, FitsItsLettersToTheRoom) {
    EXPECT_EQ(lettersOn(1, "AB", 0)->letterHeight, 8) << "the largest";
    const Result<Plaque> longer = lettersOn(1, "MOLDWRIGHT 1234", 0);
    ASSERT_TRUE(longer);
    EXPECT_LT(longer->letterHeight, 8);
    EXPECT_GE(longer->letterHeight, 3);
    EXPECT_FALSE(lettersOn(1, "MOLDWRIGHT 1234", longer->letterHeight + 0.5));
}

TEST(Plaque, ThatCannotBeIsRefusedWithTheReason) {
    const auto says = [](const Result<Plaque>& plaque, const std::string& words) {
        return !plaque && plaque.error().english().find(words) != std::string::npos;
    };
    EXPECT_TRUE(says(lettersOn(1, std::string(60, 'M'), 0), "no room on the back of half 1"));
    EXPECT_TRUE(says(lettersOn(1, "A", 2.5), "cannot be printed"));
    EXPECT_TRUE(lettersOn(1, "A", 2.8));
    PlaqueSettings deep;
    deep.depth = 3.5;
    EXPECT_TRUE(says(plaqueOn(deep, {"A"}, 1, plate(), {}, 5, 2), "less than 2 mm of steel"));
    EXPECT_FALSE(lettersOn(1, "A?", 5));
}

TEST(Plaque, AutomaticLettersTellWhatThereIs) {
    EXPECT_EQ(plaqueText("auto", {"fish_2", "", ""}), "fish 2|HALF {half}|SHRINK {shrink} %");
    EXPECT_EQ(plaqueText("auto", {"fish", "M-7", "B"}), "fish|M-7|REV B|HALF {half}|SHRINK {shrink} %");
    EXPECT_EQ(plaqueText("{revision}/{number}", {"fish", "M-7", "B"}), "B/M-7");
}

TEST(Plaque, LinesAreParted) {
    PlaqueSettings settings;
    settings.text = "A|{shrink} %|{half}{half}";
    ShrinkSettings shrink;
    shrink.percent = {1, 2, 2.5};
    EXPECT_EQ(plaqueLines(settings, shrink, 2), (std::vector<std::string>{"A", "1/2/2.5 %", "22"}));
}
