// SPDX-License-Identifier: AGPL-3.0-or-later
// Work that is in no file yet: written aside, found again after a crash, and gone when it is not needed.
#include "app/document_hash.h"
#include "app/window_driver.h"

#include "panels/banner.h"
#include "window/document.h"
#include "window/main_window.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

using namespace moldwright;
using namespace Qt::StringLiterals;
using test::WindowDriver;

namespace {

constexpr const char* childNote = "MOLDWRIGHT_TEST_LOST_WORK";

/// A state folder of its own for each test.
class RecoveryWindow : public testing::Test {
protected:
    RecoveryWindow() : m_before(qgetenv("XDG_STATE_HOME")) {
        if (!qEnvironmentVariableIsSet(childNote))
            qputenv("XDG_STATE_HOME", QFile::encodeName(m_folder.path()));
    }
    ~RecoveryWindow() override { qputenv("XDG_STATE_HOME", m_before); }

    [[nodiscard]] QString file(const QString& name) const { return m_folder.filePath(name); }

private:
    QTemporaryDir m_folder;
    QByteArray m_before;
};

QStringList foldersLeft() {
    return QDir(RecoveryFolder::root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
}

QStringList copiesLeft() {
    QStringList files;
    for (const QString& folder : foldersLeft())
        files << QDir(RecoveryFolder::root() + u'/' + folder).entryList({u"copy-*"_s}, QDir::Files);
    return files;
}

/// Opens a sample and changes it: a plane, pins with a name, another variant.
void makeWork(WindowDriver& driver) {
    ASSERT_TRUE(driver.openSample("praline"));
    driver.press("Ctrl+G");
    ASSERT_TRUE(driver.waitIdle());
    driver.window().actions()[u"accept-tips"_s]->trigger();
    driver.press("Ctrl+D");
    driver.window().actions()[u"plane-x"_s]->trigger();
    driver.bench().addPin(driver.bench().figures(driver.bench().project().part).box.center());
    driver.bench().renamePin(static_cast<int>(driver.bench().project().pins.size()) - 1, u"Nuß 核"_s);
}

bool waitAside(WindowDriver& driver) {
    bool aside = false;
    const auto link = QObject::connect(&driver.program().autosave(), &Autosave::written, &driver.window(),
                                       [&] { aside = true; });
    const bool came = driver.waitFor([&] { return aside; });
    QObject::disconnect(link);
    return came;
}

/// What a program leaves behind that is killed with this project open.
void leaveBehind(const Project& project, const QString& file = {}) {
    RecoveryFolder folder;
    ASSERT_TRUE(folder.write(copyOf(project, file, scene::lightColours())));
}

Project somePart(WindowDriver& driver) {
    EXPECT_TRUE(driver.openSample("praline"));
    return driver.bench().document().committed();
}

bool offered(WindowDriver& driver) {
    return driver.waitFor([&] { return driver.window().findChild<QPushButton*>(u"lost-open"_s) != nullptr; });
}

} // namespace

/// The program that is killed: run by the test below, in a process of its own.
TEST_F(RecoveryWindow, WorksUntilItIsKilled) {
    if (!qEnvironmentVariableIsSet(childNote))
        GTEST_SKIP() << "run by another test only";
    WindowDriver driver;
    makeWork(driver);
    ASSERT_TRUE(waitAside(driver));
    QFile note(qEnvironmentVariable(childNote));
    ASSERT_TRUE(note.open(QIODevice::WriteOnly));
    note.write(QByteArray::number(qulonglong(test::hashOf(driver.bench().document().committed()))));
    note.close();
    QFile::rename(note.fileName(), note.fileName() + u".whole"_s);
    QTest::qWait(600000);
}

TEST_F(RecoveryWindow, WorkOfAKilledProgramIsOfferedByNameAndTimeAndIsTheSame) {
    const QString note = file(u"note"_s);
    QProcess killed;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QString::fromLatin1(childNote), note);
    killed.setProcessEnvironment(environment);
    killed.setProcessChannelMode(QProcess::ForwardedChannels);
    killed.start(QCoreApplication::applicationFilePath(),
                 {u"--gtest_filter=RecoveryWindow.WorksUntilItIsKilled"_s});
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(note + u".whole"_s); }, 120000));

    { // While it lives its work is its own.
        const WindowDriver other;
        QTest::qWait(500);
        EXPECT_TRUE(const_cast<WindowDriver&>(other).program().recovery().found().empty());
    }
    killed.kill();
    ASSERT_TRUE(killed.waitForFinished());

    WindowDriver driver;
    ASSERT_TRUE(offered(driver));
    const LostWork& work = driver.program().recovery().found().front();
    EXPECT_EQ(work.name, u"Praline"_s);
    EXPECT_LT(work.when.secsTo(QDateTime::currentDateTime()), 300);
    EXPECT_FALSE(work.picture.isNull());
    driver.shot("60-lost-work");
    driver.click("lost-open");
    ASSERT_TRUE(driver.waitIdle());
    QFile told(note + u".whole"_s);
    ASSERT_TRUE(told.open(QIODevice::ReadOnly));
    EXPECT_EQ(test::hashOf(driver.bench().document().committed()), told.readAll().toULongLong());
    EXPECT_TRUE(driver.bench().document().isChanged()) << "it is in no file";
    EXPECT_TRUE(driver.bench().document().file().isEmpty());
    driver.shot("61-recovered");

    // It stays aside until it is saved.
    EXPECT_EQ(foldersLeft().size(), 1);
    ASSERT_TRUE(waitAside(driver));
    EXPECT_EQ(foldersLeft().size(), 1);
    driver.answerFileDialog(file(u"saved.moldwright"_s));
    driver.press("Ctrl+S");
    EXPECT_TRUE(driver.waitFor([&] { return foldersLeft().isEmpty(); }));
}

TEST_F(RecoveryWindow, NothingIsLeftAfterASaveOrAnOrderlyEnd) {
    {
        WindowDriver driver;
        makeWork(driver);
        ASSERT_TRUE(waitAside(driver));
        EXPECT_EQ(copiesLeft().size(), 1);
        for (int i = 0; i < RecoveryFolder::copiesKept; ++i) {
            driver.window().actions()[u"turn-x"_s]->trigger();
            ASSERT_TRUE(waitAside(driver));
        }
        EXPECT_EQ(copiesLeft().size(), RecoveryFolder::copiesKept);
        driver.answerFileDialog(file(u"saved.moldwright"_s));
        driver.press("Ctrl+S");
        EXPECT_TRUE(driver.waitFor([&] { return foldersLeft().isEmpty(); }));
        ASSERT_TRUE(driver.waitIdle()); // the command waits for the end of saving
        driver.window().actions()[u"turn-x"_s]->trigger();
        ASSERT_TRUE(waitAside(driver));
        EXPECT_EQ(foldersLeft().size(), 1);
        driver.press("Ctrl+Z");
        EXPECT_TRUE(driver.waitFor([&] { return foldersLeft().isEmpty(); })) << "it is in its file again";
        driver.press("Ctrl+Shift+Z");
        ASSERT_TRUE(waitAside(driver));
        EXPECT_EQ(foldersLeft().size(), 1);
    }
    EXPECT_TRUE(foldersLeft().isEmpty());
}

TEST_F(RecoveryWindow, ADamagedCopyGivesWayToTheOneBeforeAndNoneIsReadThatEndedTheProgramTwice) {
    Project project;
    {
        WindowDriver driver;
        project = somePart(driver);
    }
    leaveBehind(project);
    const QString path = RecoveryFolder::root() + u'/' + foldersLeft().front();
    QFile damaged(path + u"/copy-000002.moldwright"_s);
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write("PK no more");
    damaged.close();
    {
        WindowDriver driver;
        ASSERT_TRUE(offered(driver));
        const std::vector<LostWork>& found = driver.program().recovery().found();
        ASSERT_EQ(found.size(), 1U);
        ASSERT_TRUE(found.front().project);
        EXPECT_EQ(test::hashOf(*found.front().project), test::hashOf(project));
    } // It was neither opened nor given up.
    ASSERT_EQ(foldersLeft().size(), 1);
    QFile failures(path + u"/failures"_s);
    ASSERT_TRUE(failures.open(QIODevice::WriteOnly));
    failures.write("2");
    failures.close();
    WindowDriver driver;
    ASSERT_TRUE(offered(driver));
    EXPECT_FALSE(driver.program().recovery().found().front().project);
    driver.shot("62-lost-work-unreadable");
    driver.click("lost-discard");
    EXPECT_TRUE(driver.waitFor([&] { return foldersLeft().isEmpty(); }));
    QTest::qWait(50);
    EXPECT_EQ(driver.window().findChild<QPushButton*>(u"lost-open"_s), nullptr);
}

TEST_F(RecoveryWindow, WhoHasAPartOpenIsToldOnceAndCanOpenItByACommand) {
    Project project;
    {
        WindowDriver driver;
        project = somePart(driver);
    }
    WindowDriver driver;
    QTest::qWait(200);
    ASSERT_TRUE(driver.openSample("bent_beam"));
    EXPECT_FALSE(driver.window().actions()[u"recover"_s]->isEnabled());
    leaveBehind(project, u"/somewhere/praline.moldwright"_s);
    driver.program().recovery().look();
    auto* banner = driver.window().findChild<Banner*>();
    ASSERT_TRUE(driver.waitFor([&] { return banner->isVisible(); }));
    // The command follows with the next events.
    ASSERT_TRUE(driver.waitFor([&] { return driver.window().actions()[u"recover"_s]->isEnabled(); }));
    driver.shot("63-lost-work-told");
    driver.click("banner-action");
    ASSERT_TRUE(driver.waitIdle());
    EXPECT_EQ(test::hashOf(driver.bench().document().committed()), test::hashOf(project));
    EXPECT_TRUE(driver.bench().document().isChanged());
}

TEST_F(RecoveryWindow, WhereNothingCanBeWrittenItIsSaidOnceAndTheWorkGoesOn) {
    QFile inTheWay(file(u"Moldwright"_s));
    ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
    inTheWay.close();
    WindowDriver driver;
    ASSERT_TRUE(driver.openSample("praline"));
    const auto warnings = [&] {
        int count = 0;
        for (int row = 0; row < driver.bench().messages()->rowCount(); ++row)
            count +=
                driver.bench().messages()->index(row, 0).data().toString().contains(u"safe only while"_s);
        return count;
    };
    driver.press("Shift+X");
    ASSERT_TRUE(driver.waitFor([&] { return warnings() == 1; }));
    driver.press("Shift+Y");
    QTest::qWait(4000);
    EXPECT_EQ(warnings(), 1);
    EXPECT_TRUE(inTheWay.remove());
    EXPECT_TRUE(waitAside(driver)) << "it is tried again";
}
