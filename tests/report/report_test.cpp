// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/material_choice.h"
#include "report/figures.h"
#include "report/report_data.h"
#include "report/sha256.h"
#include "support/casts.h"
#include "support/materials.h"
#include "support/molds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace moldwright;
using namespace moldwright::test;

namespace {

ReportSubject subjectWith(const KnownCast& cast) {
    ReportSubject subject;
    subject.partName = "Box";
    subject.part = std::make_shared<const IndexedMesh>(cast.mesh);
    subject.cast = subject.part;
    subject.state = cast.state;
    subject.change = Change{0.01, 0.05, 0.998, 0};
    subject.mold = std::make_shared<const Mold>(moldOf(cast, {}).value());
    return subject;
}

std::string valueOf(const ReportSection& section, const std::string& label) {
    for (const ReportRow& row : section.rows)
        if (row.label == label)
            return row.value;
    return "no such row";
}

} // namespace

TEST(Figures, HaveATrueMinusAndThinSpaces) {
    EXPECT_EQ(figure(-0.23791, 4), "−0.2379");
    EXPECT_EQ(figure(-0.00001, 2), "0.00");
    EXPECT_EQ(figure(1234567.5, 1), "1\u2009234\u2009567.5");
    EXPECT_EQ(figure(999, 0), "999");
}

TEST(Figures, AProvedAngleIsRoundedDown) {
    EXPECT_EQ(figureRoundedDown(1.259, 2), "1.25");
    EXPECT_EQ(figure(1.259, 2), "1.26");
}

TEST(Figures, VolumesAndAreasAreInCentimetres) {
    EXPECT_EQ(volumeInCm3(54'230), "54.2 cm³");
    EXPECT_EQ(volumeInCm3(102'400), "102 cm³");
    EXPECT_EQ(areaInCm2(123), "1.23 cm²");
}

TEST(Sha256, OfTheStandardsExamples) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(ReportData, TellsTheShrinkThatTheMoldWasMadeWith) {
    const auto shrinkOf = [](const ShrinkSettings& shrink) {
        ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
        Mold mold = *subject.mold;
        mold.settings.shrink = shrink;
        subject.mold = std::make_shared<const Mold>(std::move(mold));
        const auto rows = reportData(subject).titleBlock;
        return std::ranges::find(rows, "Shrink", &ReportRow::label)->value;
    };
    EXPECT_EQ(shrinkOf({}), "none, factor 1");
    EXPECT_EQ(shrinkOf({Eigen::Vector3d::Constant(1.5), ShrinkFormula::Plus, Eigen::Vector3d::Zero()}),
              "1.5 %, 1 + S: factor 1.015");
    EXPECT_EQ(shrinkOf({Eigen::Vector3d::Constant(5), ShrinkFormula::Divide, Eigen::Vector3d::Zero()}),
              "5 %, 1/(1 − S): factor 1.0526");
    EXPECT_EQ(shrinkOf({{1, 2, 0}, ShrinkFormula::Plus, Eigen::Vector3d::Zero()}),
              "x 1, y 2, z 0 %, 1 + S: factors 1.01, 1.02, 1");
}

TEST(ReportData, OfAProvedMold) {
    const ReportData data = reportData(subjectWith(frusta(20, 10, 5, 3, 0.1)));
    EXPECT_TRUE(data.proved);
    EXPECT_EQ(data.verdict, "Castable. The mold opens.");
    EXPECT_NE(data.statement.find("draft 5.71° or more, where 1.0° is required"), std::string::npos);
    EXPECT_EQ(valueOf(data.numbers, "Projected area in the plane"), "2.00 cm²");
    EXPECT_EQ(valueOf(data.numbers, "Clamp force, 4 bar × 1.1"), "0.09 kN");
    EXPECT_EQ(valueOf(data.numbers, "Smallest steel, cavity to outside"), "5.00 mm");
    EXPECT_EQ(valueOf(data.planeAndDirections, "Direction 2"), "(0.0000, 0.0000, −1.0000)\n0.0° to −n");
    EXPECT_EQ(valueOf(data.kept, "Volume, cast over part"), "99.8 %");
    EXPECT_TRUE(data.openItems.empty());
    for (const ReportCheck& check : data.checks)
        EXPECT_TRUE(check.holds) << check.text;
}

TEST(ReportData, TellsHowTheMoldLeans) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    EXPECT_EQ(valueOf(reportData(subject).numbers, "Tilted while it is filled"), "no such row");
    Mold mold = *subject.mold;
    mold.leaning = LeaningMold{12, 270, 35.2, 1.8, true};
    subject.mold = std::make_shared<const Mold>(mold);
    EXPECT_EQ(valueOf(reportData(subject).numbers, "Tilted while it is filled"),
              "12° towards half 2\nair: 2 mm³, upright 35 mm³");
    mold.leaning->applied = false;
    subject.mold = std::make_shared<const Mold>(mold);
    EXPECT_EQ(valueOf(reportData(subject).numbers, "Better tilted while it is filled"),
              "12° towards half 2\nair: 2 mm³, upright 35 mm³");
}

TEST(ReportData, TellsOfImportantRegionsAndWhichMissedTheirLimit) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    subject.regions = {{"eye", 0.12, 0.2}, {"logo", 0.5, 0.25}, {"nose", 3, 0}};
    const ReportData data = reportData(subject);
    ASSERT_EQ(data.regions.size(), 3U);
    EXPECT_FALSE(data.regions[0].holds);
    EXPECT_TRUE(data.regions[1].holds);
    EXPECT_EQ(data.regions[1].text, "eye: shape changed by 0.12 mm, 0.20 mm allowed");
    EXPECT_TRUE(data.regions[2].holds);
    ASSERT_EQ(data.openItems.size(), 1U);
    EXPECT_EQ(data.openItems[0], "logo: shape changed by 0.50 mm, more than the 0.25 mm allowed.");
}

TEST(ReportData, NamesWhatDoesNotHold) {
    const ReportData data = reportData(subjectWith(frusta(20, 10, 5, 3, 0)));
    EXPECT_FALSE(data.proved);
    EXPECT_EQ(data.verdict, "Not castable yet");
    EXPECT_FALSE(data.openItems.empty());
    EXPECT_EQ(std::count_if(data.checks.begin(), data.checks.end(), [](const auto& c) { return !c.holds; }),
              2);
}

TEST(ReportData, OfAPartAloneSaysWhatIsMissing) {
    ReportSubject subject;
    subject.part = std::make_shared<const IndexedMesh>(ball(10, 2).mesh);
    const ReportData data = reportData(subject);
    EXPECT_FALSE(data.proved);
    EXPECT_FALSE(data.bars.has_value());
    EXPECT_EQ(data.openItems.size(), 1U);
}

TEST(ReportData, BarsHoldTheWholeAreaWhereItBelongs) {
    const double lean = 0.1;
    const KnownCast cast = frusta(20, 10, 5, 3, lean);
    const std::array<DraftBars, 2> bars = draftBars(cast.mesh, cast.state.directions);
    const double top = (20 - 2 * lean * 5) * (10 - 2 * lean * 5);
    EXPECT_NEAR(bars[0].area[17], top, 1e-9);
    // Walls: two trapezoids each, mid-width times slant height; 5.71° is the second bar.
    const double slant = 5 * std::sqrt(1 + lean * lean);
    EXPECT_NEAR(bars[0].area[1], 2 * slant * (20 - lean * 5 + 10 - lean * 5), 1e-9);
    EXPECT_NEAR(bars[1].worst, degrees(std::atan(lean)), 1e-9);
    const double whole = std::accumulate(bars[0].area.begin(), bars[0].area.end(), 0.0);
    EXPECT_NEAR(whole, bars[0].area[1] + bars[0].area[17], 1e-9);
}

TEST(ReportData, ListsOnlyDefaultsThatWereUsed) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    Mold mold = *subject.mold;
    mold.settings.wall = 9;
    const std::size_t all = reportData(subject).defaults.size();
    subject.mold = std::make_shared<const Mold>(mold);
    EXPECT_EQ(reportData(subject).defaults.size(), all - 1);
}

TEST(ReportData, HasTheTitleOfThePart) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    subject.revision = "B";
    const auto rows = reportData(subject).titleBlock;
    EXPECT_EQ(std::ranges::find(rows, "Number", &ReportRow::label)->value, "–");
    EXPECT_EQ(std::ranges::find(rows, "Revision", &ReportRow::label)->value, "B");
}

TEST(ReportData, TellsTheMaterialAndWhatWasTakenOfIt) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    Mold mold = *subject.mold;
    Material resin = test::materialCalled("Resin");
    resin.shrinkPercent = {0.5, "", "maker", "ask the data sheet"};
    resin.density = {1.05, "", "maker"};
    mold.settings = withMaterial(mold.settings, resin);
    mold.settings.density = 2; // otherwise: no default
    subject.mold = std::make_shared<const Mold>(mold);
    const ReportData data = reportData(subject);
    EXPECT_EQ(std::ranges::find(data.titleBlock, "Material", &ReportRow::label)->value, "Resin");
    const auto used = std::ranges::find(data.materialValues, "Shrink", &ReportDefault::name);
    ASSERT_NE(used, data.materialValues.end());
    EXPECT_EQ(used->value, "0.5 %");
    EXPECT_EQ(used->source, "maker; ask the data sheet");
    EXPECT_EQ(data.materialValues.size(), 1U) << "density was set otherwise";
    const auto mix = std::ranges::find(data.numbers.rows, "Mix, with 10 % allowance", &ReportRow::label);
    EXPECT_TRUE(mix->value.ends_with(" g")) << mix->value;
}

TEST(ReportData, ListsFeaturesByNameWithTheirSizes) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    EXPECT_FALSE(reportData(subject).features) << "a cavity alone needs no page";
    MoldSettings settings = everyFeature();
    settings.keys.clearance = 0.3;
    const KnownCast cast = frusta(20, 10, 5, 3, 0.1);
    subject.mold = std::make_shared<const Mold>(moldOf(cast, settings).value());
    const ReportData data = reportData(subject);
    ASSERT_TRUE(data.features);
    const auto& rows = data.features->rows;
    const auto keys = std::ranges::find(rows, "Key", [](const auto& row) { return row.front(); });
    ASSERT_NE(keys, rows.end());
    EXPECT_EQ((*keys)[1], "4");
    EXPECT_EQ((*keys)[2], "⌀ 6 – 7 mm, height 3.5 mm, clearance 0.3 mm, lean 5°");
    const auto isListed = [&](const char* name) {
        return std::ranges::find(data.featureDefaults, name, &ReportDefault::name) !=
               data.featureDefaults.end();
    };
    EXPECT_TRUE(isListed("Keys, diameter"));
    EXPECT_FALSE(isListed("Keys, clearance")) << "it was chosen";
    EXPECT_FALSE(isListed("Bolt holes, diameter")) << "there are none";
}

TEST(ReportData, TellsWhatTheBuilderNoted) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    Mold mold = *subject.mold;
    mold.notes = {{"The ways are not equally long.", {}}};
    mold.features.push_back({"key", "Key", {}, {}, {"Its walls lean.", {}}});
    mold.features.push_back({"key", "Key", {}, {}, {"Its walls lean.", {}}});
    subject.mold = std::make_shared<const Mold>(mold);
    EXPECT_EQ(reportData(subject).notes,
              (std::vector<std::string>{"The ways are not equally long.", "Key: Its walls lean."}));
}

TEST(ReportData, ListsCavitiesOfEachPartApart) {
    const KnownCast box = frusta(20, 10, 5, 3, 0.1);
    Tray tray = test::trayOf(box);
    tray.push_back(test::trayOf(ball(6, 3)).front());
    tray[0].name = "box";
    tray[1].name = "ball";
    tray[1].count = 2;
    ReportSubject subject = subjectWith(box);
    subject.mold = std::make_shared<const Mold>(buildMold(tray, 1, {}).value());
    const ReportData data = reportData(subject);
    ASSERT_TRUE(data.features) << "cavities of two parts need a page";
    std::vector<std::string> rows;
    for (const auto& row : data.features->rows)
        rows.push_back(row[0] + " " + row[1]);
    EXPECT_EQ(rows, (std::vector<std::string>{"Cavity (box) 1", "Cavity (ball) 2"}));
}

TEST(ReportData, SaysWhetherAllWaysAreOfOneLength) {
    ReportSubject subject = subjectWith(frusta(20, 10, 5, 3, 0.1));
    Mold mold = *subject.mold;
    mold.features.push_back({"runner", "Runner", {}, {}, {}});
    const auto lastRow = [&](std::vector<double> ways) {
        mold.pathLengths = std::move(ways);
        subject.mold = std::make_shared<const Mold>(mold);
        return reportData(subject).features->rows.back();
    };
    EXPECT_EQ(lastRow({120, 120.01, 120, 120}),
              (std::vector<std::string>{"Way from the spout to each cavity", "4", "equally long, 120 mm"}));
    EXPECT_EQ(lastRow({50, 480}),
              (std::vector<std::string>{"Way from the spout to each cavity", "2", "50 – 480 mm"}));
    EXPECT_EQ(lastRow({50})[0], "Runner") << "one cavity has nothing to compare";
}

TEST(ReportData, SpeaksTheReadersLanguage) {
    const Phrases loud([](std::string english) {
        std::ranges::transform(english, english.begin(),
                               [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        return english;
    });
    const ReportData data = reportData(subjectWith(frusta(20, 10, 5, 3, 0.1)), loud);
    EXPECT_EQ(data.verdict, "CASTABLE. THE MOLD OPENS.");
    EXPECT_EQ(valueOf(data.numbers, "CLAMP FORCE, 4 BAR × 1.1"), "0.09 kN") << "values stay as they are";
    EXPECT_EQ(valueOf(data.numbers, "SMALLEST STEEL, CAVITY TO OUTSIDE"), "5.00 mm");
    for (const ReportCheck& check : data.checks)
        EXPECT_EQ(check.text.find("the"), std::string::npos) << check.text;
}
