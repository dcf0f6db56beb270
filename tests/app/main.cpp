// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/program.h"

#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    // Whoever runs the tests keeps their preferences, and has none that the tests do not expect.
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    const QTemporaryDir state;
    if (!qEnvironmentVariableIsSet("MOLDWRIGHT_TEST_LOST_WORK")) // that one leaves something behind
        qputenv("XDG_STATE_HOME", QFile::encodeName(state.path()));
    qputenv("XDG_DATA_HOME", QFile::encodeName(state.path()));
    const QApplication application(argc, argv);
    moldwright::prepareApplication();
    return RUN_ALL_TESTS();
}
