// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "design/design.h"
#include "mold/mold.h"
#include "report/mold_defaults.h"
#include "report/phrases.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// An important region as it came through.
struct ReportRegion {
    std::string name;
    double maxDistance = 0; ///< mm that its shape changed
    double within = 0;      ///< mm that it may; 0: no limit
};

/// Figures of several things side by side, as text: a row for each thing.
struct ReportTable {
    std::string title;
    std::vector<std::string> columns; ///< the first names the things
    std::vector<std::vector<std::string>> rows;
    std::size_t strongRow = 0; ///< the thing that the report speaks of; beyond the last row: none
    std::string note;
    std::vector<double> widths; ///< of the columns, in any unit; empty: all alike
};

/// What a report is about. Without a cast or a mold it says what is still missing.
struct ReportSubject {
    std::string partName;
    std::string partNumber; ///< may be empty
    std::string revision;   ///< may be empty
    std::string sourceFile;
    std::string fileHash; ///< SHA-256 of the project file
    std::string date;     ///< as it is to be printed
    SharedMesh part;
    std::optional<MoldState> state; ///< in the part's frame
    double draftDegrees = 1;
    std::optional<DraftAnalysis> partAnalysis;
    SharedMesh cast;
    std::optional<Change> change;
    std::vector<ReportRegion> regions;
    std::shared_ptr<const Mold> mold;
    std::optional<ReportTable> variants; ///< other designs of the part, where there are any
};

struct ReportRow {
    std::string label;
    std::string value;
    bool strong = false; ///< the row that answers the section's question
};

struct ReportSection {
    std::string title;
    std::vector<ReportRow> rows;
};

/// Draft of one half by area: bars of 5° from 0° to 90°.
struct DraftBars {
    std::array<double, 18> area{}; ///< mm²
    double worst = 90;             ///< degrees, rounded down
    double mean = 0;               ///< degrees, weighted by area
};

/// One promise of the certificate and whether it holds.
struct ReportCheck {
    std::string text;
    bool holds = false;
};

/// Everything a report prints, as text and numbers, in the order of its pages; HTML and PDF lay out the same.
struct ReportData {
    std::string partName;
    std::string fileHash;
    std::string date;
    bool proved = false;
    std::string verdict;   ///< "Castable. The mold opens."
    std::string statement; ///< on what, for what, at which angle
    std::vector<ReportRow> titleBlock;
    std::string partCaption;
    std::string castCaption;
    double requiredDraft = 1;
    double leastSteel = 0; ///< mm, that the mold's settings ask for
    ReportSection planeAndDirections;
    ReportSection numbers;
    ReportSection kept; ///< how the cast compares with the part
    std::optional<std::array<DraftBars, 2>> bars;
    std::vector<ReportSection> halves;
    std::vector<ReportCheck> checks;
    std::vector<ReportCheck>
        regions; ///< important ones, whether each kept to its limit; those that did not first
    std::vector<ReportDefault> defaults;
    std::optional<ReportTable> features; ///< of the mold, on a page of its own with the next two
    std::vector<ReportDefault> featureDefaults;
    std::vector<ReportDefault> materialValues; ///< on the same page, which is there for any of these
    std::vector<std::string> notes;
    std::vector<std::string> openItems;
    std::optional<ReportTable> variants; ///< on a page of its own
};

/// The report of a subject, in the language of the phrases.
[[nodiscard]] ReportData reportData(const ReportSubject& subject, const Phrases& say = {});

/// Areas of the faces of a placed cast (plane z = 0) per 5° of draft against their own half's direction.
[[nodiscard]] std::array<DraftBars, 2> draftBars(const IndexedMesh& placedCast, const Directions& directions);

} // namespace moldwright
