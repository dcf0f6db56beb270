// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/report_blocks.h"

#include "mold/steel_map.h"
#include "render/report_text.h"
#include "report/figures.h"
#include "scene/colours.h"
#include "scene/value_scale.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moldwright::render {

namespace {

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

const Type caption{7.5, false, ink::secondary};

QColor colourOf(scene::Rgb rgb) {
    return {rgb.r, rgb.g, rgb.b};
}

/// The program's sign: two halves that part from a round cavity.
void drawSign(Paper& paper, double x, double y) {
    const double w = 6.4;
    for (const double top : {y, y + 3.4}) {
        paper.line(x, top, x + w, top, 1, ink::text);
        paper.line(x, top + 2.4, x + w, top + 2.4, 1, ink::text);
        paper.line(x, top, x, top + 2.4, 1, ink::text);
        paper.line(x + w, top, x + w, top + 2.4, 1, ink::text);
    }
    paper.fill({x + 1.8, y + 0.9, w - 3.6, 1.5}, ink::side1);
    paper.fill({x + 1.8, y + 3.4, w - 3.6, 1.5}, ink::side2);
}

/// A step of 1, 2 or 5 times a power of ten that cuts `range` into about four.
double roundStep(double range) {
    const double rough = range / 4;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0})
        if (rough <= step * power)
            return step * power;
    return 10 * power;
}

} // namespace

void drawHeader(Paper& paper, const ReportData& data, const QString& what) {
    drawSign(paper, Paper::left, 13.4);
    paper.text(Paper::left + 9.2, 11.6, 90, QStringLiteral("Moldwright"), {10, true});
    paper.text(Paper::left + 9.2, 16.6, 90, ReportText::tr("Mold design report"),
               {7.5, false, ink::secondary});
    paper.text(105, 11.6, 90, words(data.partName), {9, true}, Qt::AlignRight);
    paper.text(105, 16.6, 90, what, caption, Qt::AlignRight);
    paper.line(Paper::left, 22.6, Paper::right, 22.6, 1, ink::text);
}

void drawFooter(Paper& paper, const ReportData& data, int page, int pages) {
    constexpr double y = 281.5;
    paper.line(Paper::left, y - 1.8, Paper::right, y - 1.8, 0.5, QColor(0x8b, 0x94, 0x9f));
    const std::string& hash = data.fileHash;
    QString left = words(data.partName) + QStringLiteral("   ·   ") + words(data.date);
    if (hash.size() >= 12)
        left += QStringLiteral("   ·   ") +
                ReportText::tr("file %1").arg(words(hash.substr(0, 4) + " " + hash.substr(4, 4) + " … " +
                                                    hash.substr(hash.size() - 4)));
    paper.text(Paper::left, y, 130, left, caption);
    paper.text(145, y, 50, ReportText::tr("Page %1 of %2").arg(page).arg(pages), caption, Qt::AlignRight);
}

double drawSection(Paper& paper, double x, double y, double w, const ReportSection& section) {
    y += paper.text(x, y, w, words(section.title), {10, true}) + 1.2;
    for (const ReportRow& row : section.rows) {
        const double label = paper.text(x, y + 0.9, 0.62 * w, words(row.label), {9, false, ink::secondary});
        const double value = paper.text(x + 0.26 * w, y + 0.9, 0.74 * w, words(row.value),
                                        {9, row.strong, ink::text}, Qt::AlignRight);
        y += std::max(label, value) + 1.7;
        paper.line(x, y, x + w, y, 0.5, ink::hairline);
    }
    return y;
}

double drawTable(Paper& paper, double y, const ReportTable& table) {
    const std::vector<double> shares =
        table.widths.empty() ? std::vector<double>(table.columns.size(), 1) : table.widths;
    const double unit = (Paper::right - Paper::left) / std::accumulate(shares.begin(), shares.end(), 0.0);
    const auto row = [&](const std::vector<std::string>& cells, const Type& type) {
        double tall = 0;
        double x = Paper::left;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const double w = shares[c] * unit;
            tall = std::max(tall, paper.text(x, y + 0.9, w - 1.5, words(cells[c]), type,
                                             c == 0 ? Qt::AlignLeft : Qt::AlignRight));
            x += w;
        }
        y += tall + 1.7;
        paper.line(Paper::left, y, Paper::right, y, 0.5, ink::hairline);
    };
    y += paper.text(Paper::left, y, 120, words(table.title), {10, true}) + 1.2;
    row(table.columns, {7.5, false, ink::secondary});
    for (std::size_t r = 0; r < table.rows.size(); ++r)
        row(table.rows[r], {8, r == table.strongRow});
    return y + 2 + paper.text(Paper::left, y + 2, 180, words(table.note), caption);
}

double drawPicture(Paper& paper, const QRectF& area, const QImage& image, const QString& name,
                   const QString& about) {
    if (image.isNull())
        paper.text(area.x(), area.center().y(), area.width(), ReportText::tr("No picture"), caption,
                   Qt::AlignHCenter);
    else
        paper.picture(area, image);
    const double y = area.bottom() + 1;
    paper.line(area.left(), y, area.right(), y, 0.5, ink::hairline);
    const QString title = name + QLatin1Char('.');
    paper.text(area.left(), y + 0.9, area.width(), title, {7.5, true});
    const double indent = paper.widthOf(title, {7.5, true}) + 1.2;
    paper.text(area.left() + indent, y + 0.9, area.width() - indent, about, {7.5});
    return y + 5;
}

double drawDraftScale(Paper& paper, double y, double requiredDraft) {
    const QString required = words(readable(requiredDraft));
    const std::array<QString, 7> names = {ReportText::tr("below −15°"),
                                          ReportText::tr("−15 to −5°"),
                                          ReportText::tr("−5 to 0°"),
                                          ReportText::tr("0 to %1°").arg(required),
                                          ReportText::tr("%1 to 3°").arg(required),
                                          ReportText::tr("3 to 10°"),
                                          ReportText::tr("10° and more")};
    const double w = (Paper::right - Paper::left) / 7;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const double x = Paper::left + static_cast<double>(k) * w;
        paper.fill({x, y, w, 3}, colourOf(scene::draftClassColours()[k]));
        paper.text(x, y + 3.4, w, names[k], {7.5});
    }
    return y + 8;
}

double drawSteelScale(Paper& paper, double x, double y, double w, double leastSteel) {
    const SteelScale scale{leastSteel};
    const auto colours = scene::steelColours(scene::lightColours().undercut);
    const double each = w / SteelScale::classes;
    for (int c = 0; c < SteelScale::classes; ++c) {
        const double left = x + c * each;
        const QString from = words(readable(scale.from(c), 3));
        paper.fill({left, y, each, 3}, colourOf(colours.at(static_cast<std::size_t>(c))));
        paper.text(left, y + 3.4, each,
                   c == 0                         ? QStringLiteral("< %1").arg(words(readable(leastSteel, 3)))
                   : c == SteelScale::classes - 1 ? QStringLiteral("≥ %1 mm").arg(from)
                                                  : QStringLiteral("≥ %1").arg(from),
                   {7.5});
    }
    return y + 8;
}

double drawBars(Paper& paper, double x, double y, double w, const DraftBars& bars, int side, double highest,
                double requiredDraft) {
    const QColor colour = side == 1 ? ink::side1 : ink::side2;
    paper.text(x + 1.5, y, w, ReportText::tr("Half %1").arg(side), {9, true});
    paper.text(x, y + 0.4, w - 1.5,
               ReportText::tr("worst %1°, mean %2°")
                   .arg(words(figureRoundedDown(bars.worst, 2)), words(figure(bars.mean, 1))),
               caption, Qt::AlignRight);
    const double top = y + 6;
    const double tall = 21;
    const double foot = top + tall;
    const double step = roundStep(highest);
    for (double value = step; value <= highest; value += step) {
        const double at = foot - tall * value / highest;
        paper.line(x + 1.5, at, x + w - 1.5, at, 0.3, ink::hairline);
        paper.text(x, at - 3.4, w - 1.5, words(readable(value / 100)), caption, Qt::AlignRight);
    }
    const double bar = (w - 3) / 18;
    for (std::size_t k = 0; k < bars.area.size(); ++k) {
        const double high = tall * bars.area[k] / highest;
        paper.fill({x + 1.5 + static_cast<double>(k) * bar + 0.15, foot - high, bar - 0.3, high}, colour);
    }
    paper.line(x + 1.5, foot, x + w - 1.5, foot, 0.7, ink::text);
    const double goal = x + 1.5 + (w - 3) * requiredDraft / 90;
    paper.dashedLine(goal, top - 1, goal, foot, 0.7, ink::red);
    // Beside the title: bars may be as tall as the frame.
    paper.text(x + 16, y + 0.4, 30, ReportText::tr("%1° required").arg(words(readable(requiredDraft))),
               {7.5, false, ink::red});
    for (int angle = 0; angle <= 90; angle += 15)
        paper.text(x + 1.5 + (w - 3) * angle / 90 - 6, foot + 0.8, 12, QStringLiteral("%1°").arg(angle),
                   caption, Qt::AlignHCenter);
    return foot + 6;
}

} // namespace moldwright::render
