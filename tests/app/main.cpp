// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/program.h"

#include <QApplication>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    const QApplication application(argc, argv);
    moldwright::prepareApplication();
    return RUN_ALL_TESTS();
}
