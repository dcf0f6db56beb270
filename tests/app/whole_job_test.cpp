// SPDX-License-Identifier: AGPL-3.0-or-later
// The whole job through the real window, by the events a user makes.
#include "app/window_driver.h"

#include "mesh/measures.h"
#include "panels/step_button.h"
#include "panels/workflow_bar.h"
#include "support/folders.h"
#include "view/part_view.h"
#include "window/main_window.h"

#include <QFile>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using test::WindowDriver;

namespace {

QString verdict(WindowDriver& driver) {
    return driver.window().findChild<VerdictButton*>()->sentence();
}

} // namespace

TEST(WholeJob, SampleToMold) {
    WindowDriver driver;
    driver.shot("01-start");
    EXPECT_EQ(verdict(driver), QStringLiteral("No part open"));
    ASSERT_TRUE(driver.openSample("rabbit"));
    driver.shot("02-opened");
    EXPECT_EQ(verdict(driver), QStringLiteral("Not castable yet"));

    driver.press("Ctrl+B");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(driver.bench().document().history().steps().size(), 1U);
    driver.shot("03-best-plane");

    driver.press("Ctrl+Return");
    ASSERT_TRUE(driver.waitFor([&] { return driver.bench().frame().has_value(); }, 180000));
    driver.shot("04-running");
    ASSERT_TRUE(driver.waitIdle(300000));
    ASSERT_TRUE(driver.bench().project().cast);
    driver.shot("05-deformed");
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable"));

    driver.press("Ctrl+M");
    ASSERT_TRUE(driver.waitIdle());
    ASSERT_TRUE(driver.bench().mold());
    QTest::qWait(900);
    driver.shot("06-mold");
    EXPECT_EQ(verdict(driver), QStringLiteral("Castable and opens"));

    const test::ScratchFolder folder;
    driver.answerFileDialog(QString::fromStdString(folder.path().string()));
    driver.press("Ctrl+Shift+E");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "mold-half-1.stl"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "mold-half-2.stl"));

    driver.answerFileDialog(QString::fromStdString((folder.path() / "cast.ply").string()));
    driver.press("Ctrl+E");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "cast.ply"));

    driver.answerFileDialog(QString::fromStdString((folder.path() / "report.pdf").string()));
    driver.press("Ctrl+P");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "report.pdf"))
        << driver.bench().messages()->at(0).text.toStdString();
}
