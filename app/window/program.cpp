// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/program.h"

#include "theme/moldwright_style.h"
#include "theme/theme.h"
#include "window/main_window.h"
#include "window/preferences.h"
#include "window/sentence.h"

#include <QApplication>
#include <QFont>
#include <QFontDatabase>

namespace moldwright {

using namespace Qt::StringLiterals;

void prepareApplication() {
    QApplication::setOrganizationName(u"Moldwright"_s);
    QApplication::setApplicationName(u"Moldwright"_s);
    QApplication::setApplicationVersion(QStringLiteral(MOLDWRIGHT_VERSION));
    QApplication::setDesktopFileName(u"moldwright"_s);
    useTheme(preferences::themeChoice());
    QApplication::setStyle(new MoldwrightStyle);
    QApplication::setPalette(theme().palette);
    QFont font(QFontDatabase::families().contains(u"Noto Sans"_s) ? u"Noto Sans"_s
                                                                  : QApplication::font().family());
    font.setPixelSize(12);
    QApplication::setFont(font);
}

Program::Program() : m_autosave(m_bench.document()) {
    keepWork();
    setLanguage(preferences::language());
    m_recovery.look();
}

Program::~Program() = default;

void Program::setLanguage(const QString& language) {
    preferences::setLanguage(language);
    m_language.emplace(preferences::locale());
    showWindow();
}

void Program::keepWork() {
    connect(&m_autosave, &Autosave::failed, &m_bench, [this](const Error& error) {
        m_bench.say(
            Standing::Warning,
            tr("What is not saved is safe only while Moldwright runs. %1").arg(sentence(error.message)));
    });
    connect(&m_recovery, &Recovery::reopened, this, [this](const LostWork& work) {
        m_autosave.goOnIn(work.folder);
        m_bench.openLost(*work.project);
        m_bench.say(Standing::Warning, tr("%1 is open as it was, and is not saved.").arg(work.name));
    });
}

void Program::showWindow() {
    if (m_window)
        m_window->keepLayout();
    auto window = std::make_unique<MainWindow>(m_bench, m_recovery);
    // Queued: the window that asks is the one that goes.
    connect(window.get(), &MainWindow::languageChosen, this, &Program::setLanguage, Qt::QueuedConnection);
    window->show();
    m_window = std::move(window);
}

int runWindow(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    QApplication application(argc, argv);
    prepareApplication();
    Program program;
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() > 1)
        program.window().openPath(arguments[1]);
    return QApplication::exec();
}

} // namespace moldwright
