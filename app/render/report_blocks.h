// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "render/paper.h"
#include "report/report_data.h"

namespace moldwright::render {

/// Building blocks of a report's pages. Each draws from the top edge y down and returns where it ends, mm.

/// Thick rule below the program's sign and name on the left and the part's name on the right.
void drawHeader(Paper& paper, const ReportData& data, const QString& what);

/// What the pages speak of, and "Page 1 of 2".
void drawFooter(Paper& paper, const ReportData& data, int page, int pages);

/// A heading and rows of label and value with hairlines between; a value may have several lines.
double drawSection(Paper& paper, double x, double y, double w, const ReportSection& section);

/// A heading, a row of column names and the rows, across the page; the note below.
double drawTable(Paper& paper, double y, const ReportTable& table);

/// A picture above a hairline and its caption: a bold name, then words.
double drawPicture(Paper& paper, const QRectF& area, const QImage& image, const QString& name,
                   const QString& words);

/// The seven classes of the draft map with their limits.
double drawDraftScale(Paper& paper, double y, double requiredDraft);

/// The seven classes of the map of steel, mm.
double drawSteelScale(Paper& paper, double x, double y, double w, double leastSteel);

/// Area per 5° of draft of one half; `highest` is the top of the scale, mm².
double drawBars(Paper& paper, double x, double y, double w, const DraftBars& bars, int side, double highest,
                double requiredDraft);

} // namespace moldwright::render
