// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/project_report.h"

#include <array>
#include <chrono>
#include <cstdlib>

namespace moldwright {

namespace {

std::vector<ReportRegion> measuredRegions(const Project& project) {
    std::vector<ReportRegion> regions;
    const std::vector<RegionMeasure>& measures = project.cast->regions;
    // A file of old may hold a cast whose regions were not measured.
    for (std::size_t i = 0; i < project.importance.size() && i < measures.size(); ++i)
        if (!project.importance[i].faces.empty())
            regions.push_back(
                {project.importance[i].name, measures[i].maxDistance, project.importance[i].keepWithin});
    return regions;
}

} // namespace

ReportData projectReport(const Project& project, const Evaluation& evaluation, const std::string& fileHash,
                         const std::string& date) {
    ReportSubject subject;
    subject.partName = project.name;
    subject.sourceFile = project.sourceFile;
    subject.fileHash = fileHash;
    subject.date = date;
    subject.part = project.part;
    subject.state = project.state;
    subject.draftDegrees = project.design.draftDegrees;
    subject.partAnalysis = evaluation.part;
    if (project.cast) {
        subject.cast = project.cast->mesh;
        subject.state = project.cast->state;
        subject.draftDegrees = project.cast->draftDegrees;
        subject.change = project.cast->change;
        subject.mold = evaluation.mold;
        subject.regions = measuredRegions(project);
    }
    return reportData(subject);
}

std::string reportDate() {
    using namespace std::chrono;
    constexpr std::array<const char*, 12> months = {"January",   "February", "March",    "April",
                                                    "May",       "June",     "July",     "August",
                                                    "September", "October",  "November", "December"};
    auto now = floor<days>(system_clock::now());
    if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) // NOLINT(concurrency-mt-unsafe)
        now = floor<days>(sys_seconds(seconds(std::strtoll(fixed, nullptr, 10))));
    const year_month_day today(now);
    return std::to_string(static_cast<unsigned>(today.day())) + " " +
           months.at(static_cast<unsigned>(today.month()) - 1) + " " +
           std::to_string(static_cast<int>(today.year()));
}

} // namespace moldwright
