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

std::vector<std::string> variantRow(const IndexedMesh& part, const Variant& variant, const Phrases& say) {
    const std::string none = "–";
    std::vector<std::string> row = {variant.variantName};
    if (!variant.cast) {
        row.insert(row.end(), {say(MW_TEXT("Report", "not run")), none, none, none, none, none, none, none});
        return row;
    }
    const VariantFigures figures = variantFigures(part, variant);
    const auto& block = figures.blockSize;
    row.insert(
        row.end(),
        {figures.castable ? say(MW_TEXT("Report", "yes")) : say(MW_TEXT("Report", "no")),
         figureRoundedDown(figures.worstDraftDegrees, 2) + "°",
         figures.strain ? figure(100 * *figures.strain, 1) + " %" : none, figure(figures.largestDistance, 2),
         figures.rmsDistance ? figure(*figures.rmsDistance, 2) : none, figure(figures.filledVolume / 1000, 2),
         block ? figure(block->x(), 0) + " × " + figure(block->y(), 0) + " × " + figure(block->z(), 0) : none,
         figures.steps > 0 ? std::to_string(figures.steps) : none});
    return row;
}

/// None for a project with one design.
std::optional<ReportTable> variantTable(const Project& project, const Phrases& say) {
    if (project.others.empty() || !project.part)
        return std::nullopt;
    ReportTable table;
    table.title = say(MW_TEXT("Report", "Variants of this part"));
    for (const char* column :
         {MW_TEXT("Report", "Variant"), MW_TEXT("Report", "Castable"), MW_TEXT("Report", "Worst draft"),
          MW_TEXT("Report", "Strain"), MW_TEXT("Report", "Farthest, mm"), MW_TEXT("Report", "RMS, mm"),
          MW_TEXT("Report", "Filled, cm³"), MW_TEXT("Report", "Block, mm"), MW_TEXT("Report", "Steps")})
        table.columns.push_back(say(column));
    for (std::size_t i = 0; i < variantCount(project); ++i)
        table.rows.push_back(variantRow(*project.part, variantAt(project, i), say));
    table.strongRow = project.place;
    table.note = say(
        MW_TEXT(
            "Report",
            "This report is of variant {0}. Castable: proved in exact arithmetic. Strain is the root of "
            "the mean square over the surface of both principal stretches less 1. Farthest and RMS are "
            "distances between cast and part after the best rigid fit. The block is that of the mold with "
            "the variant's own settings."),
        {project.variantName});
    return table;
}

} // namespace

ReportData projectReport(const Project& project, const Evaluation& evaluation, const std::string& fileHash,
                         const std::string& date, const Phrases& say) {
    ReportSubject subject;
    subject.partName = project.name;
    subject.partNumber = project.number;
    subject.revision = project.revision;
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
    subject.variants = variantTable(project, say);
    return reportData(subject, say);
}

std::string reportDate(const Phrases& say) {
    using namespace std::chrono;
    constexpr std::array<const char*, 12> inMonth = {
        MW_TEXT("Report", "{0} January {1}"),   MW_TEXT("Report", "{0} February {1}"),
        MW_TEXT("Report", "{0} March {1}"),     MW_TEXT("Report", "{0} April {1}"),
        MW_TEXT("Report", "{0} May {1}"),       MW_TEXT("Report", "{0} June {1}"),
        MW_TEXT("Report", "{0} July {1}"),      MW_TEXT("Report", "{0} August {1}"),
        MW_TEXT("Report", "{0} September {1}"), MW_TEXT("Report", "{0} October {1}"),
        MW_TEXT("Report", "{0} November {1}"),  MW_TEXT("Report", "{0} December {1}")};
    auto now = floor<days>(system_clock::now());
    if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) // NOLINT(concurrency-mt-unsafe)
        now = floor<days>(sys_seconds(seconds(std::strtoll(fixed, nullptr, 10))));
    const year_month_day today(now);
    return say(
        inMonth.at(static_cast<unsigned>(today.month()) - 1),
        {std::to_string(static_cast<unsigned>(today.day())), std::to_string(static_cast<int>(today.year()))});
}

} // namespace moldwright
