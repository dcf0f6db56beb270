// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/report_pdf.h"

#include "render/pictures.h"
#include "render/report_blocks.h"
#include "render/report_text.h"

#include <algorithm>

namespace moldwright::render {

namespace {

constexpr double column = 86.3; ///< width of one of two columns, mm
constexpr double second = Paper::right - column;

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

/// Whether there is anything for the page of features, material and notes.
bool hasFeaturesPage(const ReportData& data) {
    return data.features || !data.materialValues.empty() || !data.notes.empty();
}

/// Whether notes have a page of their own: they could run off the end of that one.
bool notesStandApart(const ReportData& data) {
    constexpr std::size_t lines = 34;
    std::size_t needed = data.featureDefaults.size() + data.materialValues.size();
    needed += data.features ? data.features->rows.size() : 0;
    constexpr std::size_t lettersOfLine = 80;
    for (const std::string& note : data.notes)
        needed += 1 + static_cast<std::size_t>(words(note).size()) / lettersOfLine;
    return needed > lines && !data.notes.empty();
}

int pageCount(const ReportData& data) {
    return 2 + (hasFeaturesPage(data) ? 1 : 0) + (notesStandApart(data) ? 1 : 0) + (data.variants ? 1 : 0);
}

QImage imageIn(const std::filesystem::path& folder, const char* name) {
    return QImage(QString::fromStdString((folder / name).string()));
}

double drawVerdict(Paper& paper, const ReportData& data, double y) {
    if (data.proved)
        paper.mark(Paper::right - 10.5, y + 1, 9.5, true);
    const double title = paper.text(Paper::left, y, 165, words(data.verdict), {19, true});
    return y + title - 0.6 +
           paper.text(Paper::left, y + title - 0.6, 165, words(data.statement), {9, false, ink::secondary});
}

/// Two columns of label and value, row by row.
double drawTitleBlock(Paper& paper, const std::vector<ReportRow>& rows, double y) {
    for (std::size_t i = 0; i < rows.size(); i += 2) {
        for (std::size_t k = i; k < std::min(i + 2, rows.size()); ++k) {
            const double x = k == i ? Paper::left : 105;
            paper.text(x, y + 0.9, 25, words(rows[k].label), {9, false, ink::secondary});
            paper.text(x + 26, y + 0.9, 63, words(rows[k].value), {9});
        }
        y += 6.5;
        paper.line(Paper::left, y, Paper::right, y, 0.5, ink::hairline);
    }
    return y;
}

double drawPictures(Paper& paper, const ReportData& data, const std::filesystem::path& pictures, double y) {
    constexpr double wide = 57;
    constexpr double tall = 46;
    const double gap = (Paper::right - Paper::left - 3 * wide) / 2;
    const auto place = [&](int k) { return QRectF(Paper::left + k * (wide + gap), y, wide, tall); };
    drawPicture(paper, place(0), imageIn(pictures, partPicture), ReportText::tr("Part"),
                words(data.partCaption));
    drawPicture(paper, place(1), imageIn(pictures, castPicture), ReportText::tr("Cast"),
                words(data.castCaption));
    const double end = drawPicture(paper, place(2), imageIn(pictures, draftPicture), ReportText::tr("Draft"),
                                   ReportText::tr("Scale below, dark is bad"));
    return drawDraftScale(paper, end, data.requiredDraft);
}

double drawHistograms(Paper& paper, const ReportData& data, double y) {
    if (!data.bars)
        return y;
    double highest = 0;
    for (const DraftBars& bars : *data.bars)
        highest = std::max(highest, *std::max_element(bars.area.begin(), bars.area.end()));
    y += paper.text(Paper::left, y, 100, ReportText::tr("Draft, area in cm² per 5°"), {10, true}) + 0.8;
    drawBars(paper, Paper::left, y, column, (*data.bars)[0], 1, highest, data.requiredDraft);
    return drawBars(paper, second, y, column, (*data.bars)[1], 2, highest, data.requiredDraft);
}

void drawFirstPage(Paper& paper, const ReportData& data, const std::filesystem::path& pictures) {
    drawHeader(paper, data, ReportText::tr("Part and cast"));
    double y = drawVerdict(paper, data, 26.5);
    y = drawTitleBlock(paper, data.titleBlock, y + 2.5);
    y = drawPictures(paper, data, pictures, y + 5);
    const double left = drawSection(paper, Paper::left, y + 2.5, column, data.planeAndDirections);
    const double right = drawSection(paper, second, y + 2.5, column, data.numbers);
    y = drawHistograms(paper, data, std::max(left, right) + 4);
    constexpr double low = 268;
    if (data.bars)
        drawPicture(paper, {Paper::left, y + 1, column, low - y - 1}, imageIn(pictures, halvesPicture),
                    ReportText::tr("Mold"), ReportText::tr("Half 2 left, half 1 right, parting faces up"));
    if (!data.kept.rows.empty())
        y = drawSection(paper, second, y + 2, column, data.kept);
    paper.text(second, y + 2, column,
               ReportText::tr("Not a simulation of filling, warpage or cooling.\nOpen items: %1.")
                   .arg(data.openItems.empty() ? ReportText::tr("none")
                                               : ReportText::tr("%1, see page 2").arg(data.openItems.size())),
               {7.5, false, ink::secondary});
    drawFooter(paper, data, 1, pageCount(data));
}

double drawChecks(Paper& paper, const QString& title, const std::vector<ReportCheck>& checks, double y) {
    y += paper.text(Paper::left, y, 120, title, {10, true}) + 1.2;
    for (const ReportCheck& check : checks) {
        paper.mark(Paper::left, y + 1.2, 3.6, check.holds);
        paper.text(Paper::left + 6, y + 0.9, 174, words(check.text), {9});
        y += 6.2;
        paper.line(Paper::left, y, Paper::right, y, 0.5, ink::hairline);
    }
    return y;
}

/// As many as the page has room for; those that missed their limit come first.
double drawRegions(Paper& paper, const ReportData& data, double y) {
    constexpr std::size_t most = 4;
    if (data.regions.empty())
        return y;
    const std::size_t shown = std::min(most, data.regions.size());
    const auto first = data.regions.begin();
    y = drawChecks(paper, ReportText::tr("Important regions, each after its own best fit"),
                   {first, first + static_cast<std::ptrdiff_t>(shown)}, y);
    if (shown < data.regions.size())
        y += paper.text(Paper::left + 6, y + 0.9, 174,
                        ReportText::tr("and %1 more").arg(data.regions.size() - shown),
                        {9, false, ink::secondary});
    return y + 4;
}

double drawDefaults(Paper& paper, const QString& title, const std::vector<ReportDefault>& defaults,
                    double y) {
    if (defaults.empty())
        return y;
    y += paper.text(Paper::left, y, 120, title, {10, true}) + 1.2;
    for (const ReportDefault& used : defaults) {
        paper.text(Paper::left, y + 0.9, 62, words(used.name), {9, false, ink::secondary});
        paper.text(Paper::left + 64, y + 0.9, 28, words(used.value), {9});
        y += 1.6 + std::max(4.6, paper.text(second, y + 0.9, column, words(used.source),
                                            {9, false, ink::secondary}));
        paper.line(Paper::left, y, Paper::right, y, 0.5, ink::hairline);
    }
    return y;
}

double drawOpenItems(Paper& paper, const ReportData& data, double y) {
    y += paper.text(Paper::left, y, 120, ReportText::tr("Open items"), {10, true}) + 1.2;
    if (data.openItems.empty())
        y += paper.text(Paper::left, y + 0.9, 180, ReportText::tr("None."), {9});
    for (const std::string& item : data.openItems)
        y += paper.text(Paper::left, y + 0.9, 180, words(item), {9, false, ink::amber}) + 1.2;
    return y;
}

/// Framed fields to sign in, at the foot of the page.
void drawSignOff(Paper& paper, double y) {
    const std::array<QString, 4> fields = {ReportText::tr("Drawn by"), ReportText::tr("Checked by"),
                                           ReportText::tr("Approved by"), ReportText::tr("Date")};
    constexpr double tall = 16;
    const double w = (Paper::right - Paper::left) / 4;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const double x = Paper::left + static_cast<double>(k) * w;
        paper.line(x, y, x, y + tall, 1, ink::text);
        paper.text(x + 2.2, y + 1.2, w, fields[k], {7.5, false, ink::secondary});
    }
    paper.line(Paper::right, y, Paper::right, y + tall, 1, ink::text);
    paper.line(Paper::left, y, Paper::right, y, 1, ink::text);
    paper.line(Paper::left, y + tall, Paper::right, y + tall, 1, ink::text);
}

void drawSecondPage(Paper& paper, const ReportData& data, const std::filesystem::path& pictures) {
    drawHeader(paper, data, ReportText::tr("Mold and proof"));
    double y = 28;
    for (const ReportSection& half : data.halves)
        y = drawSection(paper, Paper::left, y, column, half) + 4;
    if (!data.halves.empty()) {
        double end = drawPicture(paper, {second, 27, column, 36}, imageIn(pictures, openedPicture),
                                 ReportText::tr("Opened"),
                                 ReportText::tr("Each half along its own direction, the cast between"));
        end =
            drawPicture(paper, {second, end + 1, column, 24}, imageIn(pictures, steelPicture),
                        ReportText::tr("Steel"), ReportText::tr("Behind the walls, in mm; too thin is red"));
        end = drawSteelScale(paper, second, end, column, data.leastSteel);
        y = std::max(y, end) + 1;
    }
    if (!data.checks.empty())
        y = drawChecks(paper, ReportText::tr("Certificate, on the written halves"), data.checks, y) + 2;
    y += paper.text(
             Paper::left, y, 180,
             ReportText::tr("Proved in exact arithmetic on the coordinates as they stand in the files. The "
                            "proof speaks of rigid motion along the two directions; it is not a "
                            "simulation of filling, warpage, cooling or friction."),
             {7.5, false, ink::secondary}) +
         5;
    y = drawRegions(paper, data, y);
    y = drawDefaults(paper, ReportText::tr("Defaults used"), data.defaults, y) + 5;
    drawOpenItems(paper, data, y);
    drawSignOff(paper, 258);
    drawFooter(paper, data, 2, pageCount(data));
}

void drawNotes(Paper& paper, const ReportData& data, double y) {
    if (data.notes.empty())
        return;
    y += paper.text(Paper::left, y, 120, ReportText::tr("To be known"), {10, true}) + 1.2;
    for (const std::string& note : data.notes)
        y += paper.text(Paper::left, y + 0.9, 180, words(note), {9}) + 1.2;
}

void drawFeaturesPage(Paper& paper, const ReportData& data) {
    drawHeader(paper, data, ReportText::tr("Features of the mold"));
    double y = data.features ? drawTable(paper, 28, *data.features) + 3 : 28;
    if (!data.featureDefaults.empty())
        y = drawDefaults(paper, ReportText::tr("Defaults used for them"), data.featureDefaults, y) + 5;
    if (!data.materialValues.empty())
        y = drawDefaults(paper, ReportText::tr("Taken from the material"), data.materialValues, y) + 5;
    if (!notesStandApart(data))
        drawNotes(paper, data, y);
}

void drawNotesPage(Paper& paper, const ReportData& data) {
    drawHeader(paper, data, ReportText::tr("Features of the mold"));
    drawNotes(paper, data, 28);
}

} // namespace

Result<int> writeReportPdf(const ReportData& data, const std::filesystem::path& pictures,
                           const std::filesystem::path& file) {
    // Beside its final name, so that a failure leaves an older report whole.
    const std::filesystem::path unfinished = file.string() + ".part";
    const auto failed = [&] {
        std::error_code ignored;
        std::filesystem::remove(unfinished, ignored);
        return failure(ErrorCode::WriteFailed,
                       MW_TEXT("Report", "The report {0} could not be written. Choose another folder or free "
                                         "some space."),
                       {file.string()});
    };
    Paper paper(words(unfinished.string()), words(data.partName));
    if (!paper.open())
        return failed();
    drawFirstPage(paper, data, pictures);
    paper.newPage();
    drawSecondPage(paper, data, pictures);
    if (hasFeaturesPage(data)) {
        paper.newPage();
        drawFeaturesPage(paper, data);
        drawFooter(paper, data, 3, pageCount(data));
    }
    if (notesStandApart(data)) {
        paper.newPage();
        drawNotesPage(paper, data);
        drawFooter(paper, data, 4, pageCount(data));
    }
    if (data.variants) {
        paper.newPage();
        drawHeader(paper, data, ReportText::tr("Variants"));
        drawTable(paper, 28, *data.variants);
        drawFooter(paper, data, pageCount(data), pageCount(data));
    }
    std::error_code error;
    if (!paper.close())
        return failed();
    std::filesystem::rename(unfinished, file, error);
    if (error)
        return failed();
    return paper.pages();
}

} // namespace moldwright::render
