// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/program.h"

#include "exchange/mesh_file.h"
#include "language/spoken_language.h"
#include "project/pipeline.h"
#include "render/pictures.h"
#include "render/report_job.h"

#include <nlohmann/json.hpp>

#include <QGuiApplication>

#include <fstream>
#include <iostream>
#include <iterator>

namespace moldwright::render {

namespace {

std::string orderFrom(int argc, char** argv) {
    if (argc < 2)
        return {std::istreambuf_iterator<char>(std::cin), {}};
    std::ifstream file(argv[1]);
    return {std::istreambuf_iterator<char>(file), {}};
}

Result<void> report(const Job& job, int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    const SpokenLanguage language(job.language.empty() ? QLocale::c()
                                                       : QLocale(QString::fromStdString(job.language)));
    const Result<ReportAnswer> answer = writeReport(job);
    if (!answer)
        return std::unexpected(answer.error());
    std::cout << nlohmann::json{{"pages", answer->pages}, {"missing", answer->missingPictures}} << "\n";
    return {};
}

Result<void> drawMesh(const Job& job) {
    Result<ReadMesh> file = readMesh(job.source);
    if (!file)
        return std::unexpected(file.error());
    return drawSurface(std::make_shared<const IndexedMesh>(std::move(file->mesh)), job.look, job.out);
}

Result<void> draw(const Job& job) {
    if (job.task == Job::Task::Surface)
        return drawMesh(job);
    const Result<Project> project = projectOf(job);
    if (!project)
        return std::unexpected(project.error());
    if (job.task == Job::Task::Thumbnail)
        return drawThumbnail(*project, job.out, job.width, job.height);
    const Result<Evaluation> evaluation = evaluate(*project);
    if (!evaluation)
        return std::unexpected(evaluation.error());
    return drawReportPictures(*project, *evaluation, job.out);
}

int exitCodeOf(ErrorCode code) {
    switch (code) {
    case ErrorCode::Usage:
        return 2;
    case ErrorCode::BadInput:
    case ErrorCode::WriteFailed:
        return 3;
    default:
        return 70;
    }
}

} // namespace

int runProgram(int argc, char** argv) {
    const Result<Job> job = readJob(orderFrom(argc, argv));
    Result<void> done;
    if (!job)
        done = std::unexpected(job.error());
    else
        done = job->task == Job::Task::Report ? report(*job, argc, argv) : draw(*job);
    if (done)
        return 0;
    std::cerr << done.error().english() << "\n";
    return exitCodeOf(done.error().code);
}

} // namespace moldwright::render
