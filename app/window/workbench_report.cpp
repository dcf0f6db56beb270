// SPDX-License-Identifier: AGPL-3.0-or-later
// The report: drawn by a program of its own, so that a fault in the graphics costs a message and no work.
#include "window/workbench.h"

#include "project/project_file.h"
#include "window/preferences.h"
#include "window/sentence.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

QString renderProgram() {
    const QString given = qEnvironmentVariable("MOLDWRIGHT_RENDER");
    return given.isEmpty() ? QCoreApplication::applicationDirPath() + u"/moldwright-render"_s : given;
}

/// Runs the program on its order; an empty text when the report is there, else what went wrong.
QString render(const QByteArray& order, const Task& task) {
    QProcess program;
    program.start(renderProgram(), {});
    if (!program.waitForStarted())
        return Workbench::tr("moldwright-render could not be started.");
    program.write(order);
    program.closeWriteChannel();
    while (!program.waitForFinished(50))
        if (program.state() == QProcess::NotRunning || task.stopped())
            break;
    if (program.state() != QProcess::NotRunning) {
        program.kill();
        program.waitForFinished();
        return Workbench::tr("It was stopped.");
    }
    if (program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0)
        return {};
    const QString complaint = QString::fromUtf8(program.readAllStandardError()).trimmed();
    return complaint.section(u'\n', -1);
}

} // namespace

void Workbench::writeReport(const QString& file) {
    const Project project = m_document.committed();
    const QString language = preferences::locale().name();
    m_background.start(tr("Drawing the report"), [=, this](const Task& task) -> Background::Finish {
        const QTemporaryDir folder;
        const QString input = folder.filePath(u"project.moldwright"_s);
        const Result<void> written = saveProject(input.toStdString(), {project, {}, {}});
        const QByteArray order = QJsonDocument(QJsonObject{{u"task"_s, u"report"_s},
                                                           {u"project"_s, input},
                                                           {u"out"_s, file},
                                                           {u"language"_s, language}})
                                     .toJson();
        const QString trouble = written ? render(order, task) : sentence(written.error().message);
        return [=, this] {
            if (!trouble.isEmpty()) {
                say(Standing::Failing, tr("The report was not written. %1").arg(trouble));
                Q_EMIT problem(tr("The report was not written."), trouble);
                return;
            }
            say(Standing::Done, tr("Report written to %1.").arg(QDir::toNativeSeparators(file)));
            Q_EMIT reportWritten(file);
        };
    });
}

} // namespace moldwright
