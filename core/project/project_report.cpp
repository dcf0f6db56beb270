// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/project_report.h"

#include "project/variant_figures.h"
#include "project/variants.h"
#include "report/figures.h"

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

std::vector<std::string> variantRow(const IndexedMesh& part, const Variant& variant) {
    const std::string none = "–";
    std::vector<std::string> row = {variant.variantName};
    if (!variant.cast) {
        row.insert(row.end(), {"not run", none, none, none, none, none, none, none});
        return row;
    }
    const VariantFigures figures = variantFigures(part, variant);
    const auto& block = figures.blockSize;
    row.insert(
        row.end(),
        {figures.castable ? "yes" : "no", figureRoundedDown(figures.worstDraftDegrees, 2) + "°",
         figures.strain ? figure(100 * *figures.strain, 1) + " %" : none, figure(figures.largestDistance, 2),
         figures.rmsDistance ? figure(*figures.rmsDistance, 2) : none, figure(figures.filledVolume / 1000, 2),
         block ? figure(block->x(), 0) + " × " + figure(block->y(), 0) + " × " + figure(block->z(), 0) : none,
         figures.steps > 0 ? std::to_string(figures.steps) : none});
    return row;
}

/// None for a project with one design.
std::optional<ReportTable> variantTable(const Project& project) {
    if (project.others.empty() || !project.part)
        return std::nullopt;
    ReportTable table;
    table.title = "Variants of this part";
    table.columns = {"Variant", "Castable",    "Worst draft", "Strain", "Farthest, mm",
                     "RMS, mm", "Filled, cm³", "Block, mm",   "Steps"};
    for (std::size_t i = 0; i < variantCount(project); ++i)
        table.rows.push_back(variantRow(*project.part, variantAt(project, i)));
    table.strongRow = project.place;
    table.note =
        "This report is of variant " + project.variantName +
        ". Castable: proved in exact arithmetic. Strain is the root of the mean square over the "
        "surface of both principal stretches less 1. Farthest and RMS are distances between cast and "
        "part after the best rigid fit. The block is that of the mold with the variant's own settings.";
    return table;
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
    subject.variants = variantTable(project);
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
