// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/report_job.h"

#include "language/core_words.h"
#include "project/project_report.h"
#include "render/report_pdf.h"
#include "render/report_text.h"
#include "report/sha256.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>

#include <fstream>
#include <iterator>

namespace moldwright::render {

namespace {

constexpr int pictureTimeLimit = 120'000; // ms

/// Has the pictures drawn; says what went wrong, or nothing.
std::string orderPictures(const Job& report, const QTemporaryDir& folder) {
    Job job = report;
    job.task = Job::Task::Pictures;
    job.out = folder.path().toStdString();
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(), {});
    program.write(QByteArray::fromStdString(jobText(job)));
    program.closeWriteChannel();
    if (!program.waitForFinished(pictureTimeLimit)) {
        program.kill();
        program.waitForFinished();
        return "The pictures took too long to draw.";
    }
    if (program.exitStatus() != QProcess::NormalExit)
        return "The graphics driver failed while the pictures were drawn.";
    return program.exitCode() == 0 ? "" : program.readAllStandardError().trimmed().toStdString();
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

Result<ReportAnswer> writeReport(const Job& job) {
    const Result<Project> project = projectOf(job);
    if (!project)
        return std::unexpected(project.error());
    const Result<Evaluation> evaluation = evaluate(*project);
    if (!evaluation)
        return std::unexpected(evaluation.error());
    // A word of the report may mean something else elsewhere: its own translation goes first.
    const Phrases say([](const std::string& english) {
        const std::string own = ReportText::tr(english.c_str()).toStdString();
        return own != english ? own : inSpokenLanguage(english);
    });
    const ReportData data =
        projectReport(*project, *evaluation, sha256(bytesOf(job.source)), reportDate(say), say);
    const QTemporaryDir folder;
    ReportAnswer answer;
    answer.missingPictures = orderPictures(job, folder);
    const Result<int> pages = writeReportPdf(data, folder.path().toStdString(), job.out);
    if (!pages)
        return std::unexpected(pages.error());
    answer.pages = *pages;
    return answer;
}

} // namespace moldwright::render
