// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/window_driver.h"

#include "panels/project_tree.h"
#include "window/main_window.h"

#include <QApplication>
#include <QDebug>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <QTimer>

using namespace Qt::StringLiterals;

namespace moldwright::test {

WindowDriver::WindowDriver() {
    window().resize(1440, 900);
    QObject::connect(&bench(), &Workbench::problem, &window(),
                     [this](const QString& words) { m_problems += words + u'\n'; });
    (void)waitActive();
}

WindowDriver::~WindowDriver() = default;

bool WindowDriver::waitFor(const std::function<bool()>& condition, int milliseconds) {
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
        if (clock.elapsed() > milliseconds) {
            tellWhatIsSeen(milliseconds);
            return false;
        }
        QTest::qWait(10);
    }
    return true;
}

bool WindowDriver::waitActive() {
    // The window manager hands the focus on in its own time, also after a window before this one went
    // away; a shortcut pressed meanwhile would go nowhere.
    if (QApplication::activeWindow())
        return true;
    window().activateWindow();
    return waitFor([] { return QApplication::activeWindow() != nullptr; });
}

void WindowDriver::tellWhatIsSeen(int milliseconds) {
    const auto name = [](const QWidget* widget) {
        return widget ? QString::fromLatin1(widget->metaObject()->className()) + u' ' + widget->objectName()
                      : u"none"_s;
    };
    qWarning().noquote() << "Nothing came within" << milliseconds
                         << "ms. Active window:" << name(QApplication::activeWindow())
                         << "| focus:" << name(QApplication::focusWidget())
                         << "| asking:" << name(QApplication::activeModalWidget())
                         << "| at work:" << m_program.bench().background().busy()
                         << "| problems:" << m_problems;
}

bool WindowDriver::waitIdle(int milliseconds) {
    const bool idle =
        waitFor([this] { return !bench().background().busy() && bench().analysisIsCurrent(); }, milliseconds);
    QTest::qWait(50); // the window follows the workbench with the next events
    return idle;
}

void WindowDriver::press(const char* keys) {
    (void)waitActive();
    const QKeyCombination combination = QKeySequence(QString::fromLatin1(keys))[0];
    QWidget* target = QApplication::focusWidget() ? QApplication::focusWidget() : &window();
    QTest::keyClick(target, combination.key(), combination.keyboardModifiers());
    QTest::qWait(30);
}

void WindowDriver::click(const char* objectName) {
    auto* widget = window().findChild<QWidget*>(QString::fromLatin1(objectName));
    QVERIFY2(widget, objectName);
    QTest::mouseClick(widget, Qt::LeftButton);
    QTest::qWait(30);
}

void WindowDriver::type(const char* field, const char* text) {
    auto* box = window().findChild<QDoubleSpinBox*>(QString::fromLatin1(field));
    QVERIFY2(box, field);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QString::fromUtf8(text));
    QTest::keyClick(box, Qt::Key_Return);
    QTest::qWait(30);
}

void WindowDriver::selectRow(const char* id) {
    auto* tree = window().findChild<ProjectTree*>();
    const QModelIndex row = static_cast<ProjectModel*>(tree->model())->indexOf(QString::fromLatin1(id));
    QVERIFY2(row.isValid(), id);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualRect(row).center());
    QTest::qWait(30);
}

bool WindowDriver::openSample(const char* baseName) {
    click((std::string("sample-") + baseName).c_str());
    return waitFor([this] { return bench().project().part != nullptr; }) && waitIdle();
}

bool WindowDriver::openMesh(const QString& file, double longestSide) {
    answerFileDialog(file);
    press("Ctrl+O");
    QDoubleSpinBox* length = nullptr;
    const bool asked = waitFor([&] {
        length = window().findChild<QDoubleSpinBox*>(QStringLiteral("import-length"));
        return length && length->isVisible();
    });
    if (!asked)
        return false;
    length->setFocus();
    length->selectAll();
    QTest::keyClicks(length, QString::number(longestSide));
    shot("00-import");
    click("import-open");
    return waitFor([this] { return bench().project().part != nullptr; }) && waitIdle();
}

void WindowDriver::whenAsked(const std::function<bool()>& answer) {
    auto* timer = new QTimer(&window());
    QObject::connect(timer, &QTimer::timeout, timer, [timer, answer] {
        // The answer ends the dialog's own loop of events: nothing may be asked twice meanwhile.
        timer->stop();
        if (answer())
            timer->deleteLater();
        else
            timer->start();
    });
    timer->start(50);
}

void WindowDriver::answerFileDialog(const QString& path) {
    whenAsked([path] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog)
            return false;
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        name->setText(path);
        QTest::keyClick(name, Qt::Key_Return);
        return true;
    });
}

void WindowDriver::answerQuestion(const char* button) {
    whenAsked([button] {
        QWidget* dialog = QApplication::activeModalWidget();
        auto* answer = dialog ? dialog->findChild<QPushButton*>(QString::fromLatin1(button)) : nullptr;
        if (!answer)
            return false;
        QTest::mouseClick(answer, Qt::LeftButton);
        return true;
    });
}

void WindowDriver::shot(const char* name, const QWidget* of) {
    const QString folder = qEnvironmentVariable("MOLDWRIGHT_SCREENSHOTS");
    if (folder.isEmpty())
        return;
    QTest::qWait(250);
    const QWidget& shown = of != nullptr ? *of : window();
    shown.screen()
        ->grabWindow(shown.winId())
        .save(folder + u'/' + QString::fromLatin1(name) + QStringLiteral(".png"));
}

} // namespace moldwright::test
