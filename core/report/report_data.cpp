// SPDX-License-Identifier: AGPL-3.0-or-later
#include "report/report_data.h"

#include "mesh/measures.h"
#include "mold/pour_tilt.h"
#include "mold/shrink.h"
#include "report/figures.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector3d;

double angleBetween(const Vector3d& a, const Vector3d& b) {
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

std::string angle(double value) {
    return figure(value, 1) + "°";
}

std::string provedAngle(const Mold& mold) {
    return figureRoundedDown(mold.castCertificate.worstDraftDegrees, 2) + "°";
}

void addVerdict(ReportData& data, const ReportSubject& subject) {
    const std::string required = angle(subject.draftDegrees);
    if (!subject.cast) {
        data.verdict = "Not castable yet";
        data.statement = "No cast has been made of this part. Required draft " + required + ".";
    } else if (!subject.mold) {
        data.verdict = "No mold yet";
        data.statement = "The cast is there, its mold could not be built. Required draft " + required + ".";
    } else if (subject.mold->verified()) {
        data.proved = true;
        data.verdict = "Castable. The mold opens.";
        data.statement = "Proved on the written halves for every face: draft " + provedAngle(*subject.mold) +
                         " or more, where " + required + " is required.";
    } else {
        data.verdict = "Not castable yet";
        data.statement = "The mold is not proved to open. Open items are on page 2.";
    }
}

/// "1.5 %, 1 + S: factor 1.015"; by axes of the part where they differ.
std::string shrinkText(const ShrinkSettings& shrink) {
    const Vector3d& percent = shrink.percent;
    if (percent.isZero(0))
        return "none, factor 1";
    const auto factor = [&](int axis) { return readable(shrinkFactor(percent[axis], shrink.formula), 5); };
    const std::string formula = shrink.formula == ShrinkFormula::Plus ? "1 + S" : "1/(1 − S)";
    if (percent.x() == percent.y() && percent.y() == percent.z())
        return readable(percent.x()) + " %, " + formula + ": factor " + factor(0);
    return "x " + readable(percent.x()) + ", y " + readable(percent.y()) + ", z " + readable(percent.z()) +
           " %, " + formula + ": factors " + factor(0) + ", " + factor(1) + ", " + factor(2);
}

/// The thinnest steel's row, with what it stands between.
ReportRow steelRow(const Mold& mold) {
    std::string name = "Smallest steel";
    if (!mold.steel.empty()) {
        std::string between = mold.steel.front().first + " to " + mold.steel.front().second;
        std::ranges::transform(between, between.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        name += ", " + between;
    }
    return {name, figure(mold.minWall, 2) + " mm", true};
}

std::vector<ReportRow> titleBlock(const ReportSubject& subject) {
    const SharedMesh& shown = subject.cast ? subject.cast : subject.part;
    return {{"Part", subject.partName},
            {"Read from", subject.sourceFile},
            {"Size", shown ? sizeInMillimetres(boundingBox(*shown).sizes()) : "none"},
            {"Date", subject.date},
            {"Units", "millimetres, degrees"},
            {"Shrink", subject.mold ? shrinkText(subject.mold->settings.shrink) : "no mold yet"}};
}

ReportSection planeAndDirections(const ReportSubject& subject) {
    ReportSection section{"Parting plane and directions", {}};
    if (!subject.state) {
        section.rows.push_back({"Plane", "none chosen"});
        return section;
    }
    const auto& [plane, directions] = *subject.state;
    section.rows = {
        {"Plane, n · x = o", "n = " + figures(plane.normal, 4) + "\no = " + figure(plane.offset, 2) + " mm"},
        {"Direction 1",
         figures(directions.d1, 4) + "\n" + angle(angleBetween(directions.d1, plane.normal)) + " to n"},
        {"Direction 2",
         figures(directions.d2, 4) + "\n" + angle(angleBetween(directions.d2, -plane.normal)) + " to −n"}};
    return section;
}

/// What there is of wells, and how the mold leans or had better.
void addPouring(ReportSection& section, const Mold& mold) {
    const auto wells = std::count_if(mold.features.begin(), mold.features.end(),
                                     [](const MoldFeature& feature) { return feature.kind == "overflow"; });
    if (wells > 0)
        section.rows.push_back({"Overflows", std::to_string(wells) + " of " +
                                                 readable(mold.settings.overflows.diameter) + " mm"});
    if (!mold.leaning)
        return;
    const LeaningMold& lean = *mold.leaning;
    section.rows.push_back(
        {lean.applied ? "Tilted while it is filled" : "Better tilted while it is filled",
         readable(lean.degrees, 3) + "° towards " + leaningWords(mold.settings.spout.resting, lean.towards) +
             "\nair: " + figure(lean.air, 0) + " mm³, upright " + figure(lean.airUpright, 0) + " mm³"});
}

ReportSection numbers(const ReportSubject& subject) {
    ReportSection section{"Numbers", {}};
    if (!subject.mold) {
        if (subject.part)
            section.rows.push_back({"Volume of the part", volumeInCm3(volume(*subject.part))});
        return section;
    }
    const Mold& mold = *subject.mold;
    section.rows = {{"Cavity, as cut", volumeInCm3(mold.cavityVolume), true},
                    {"Mix, with 10 % allowance", volumeInCm3(1.1 * (mold.cavityVolume + mold.channelVolume))},
                    {"Projected area in the plane", areaInCm2(mold.partingArea)},
                    {"Clamp force, " + readable(mold.settings.pressure) + " bar × 1.1",
                     figure(mold.clampForce, mold.clampForce < 10 ? 2 : 1) + " kN"},
                    {"Mold, closed", sizeInMillimetres(mold.blockSize)},
                    steelRow(mold)};
    addPouring(section, mold);
    return section;
}

ReportSection kept(const ReportSubject& subject) {
    ReportSection section{"Kept from the part", {}};
    if (!subject.change || !subject.part)
        return section;
    const double size = diagonal(*subject.part);
    const Change& change = *subject.change;
    section.rows = {{"Mean deviation, after best fit", figure(change.meanDistance * size, 2) + " mm"},
                    {"Largest deviation", figure(change.maxDistance * size, 2) + " mm"},
                    {"Volume, cast over part", figure(100 * change.volumeRatio, 1) + " %"},
                    {"Filled in", figure(100 * change.filledVolumeFraction, 1) + " %"}};
    return section;
}

std::vector<ReportSection> halves(const Mold& mold) {
    const auto section = [](const char* name, const MoldHalf& half, const Vector3d& d) {
        return ReportSection{name,
                             {{"Size", sizeInMillimetres(half.size)},
                              {"Volume", volumeInCm3(half.volume)},
                              {"Opens along, mold’s frame", figures(d, 4)}}};
    };
    return {section("Mold half 1", mold.half1, mold.directions.d1),
            section("Mold half 2", mold.half2, mold.directions.d2)};
}

std::vector<ReportCheck> checks(const Mold& mold) {
    const Certificate& c = mold.castCertificate;
    const std::string draft = figure(mold.draftDegrees, 1) + "°";
    return {
        {"The cast is closed, manifold and outward", c.closedAndOutward},
        {"Each direction leaves the parting plane on its side", c.directionsLeave},
        {"Every face has a draft of " + draft + " or more, in exact arithmetic", c.draftHolds},
        {"No face lies across the parting plane", c.curvesOnPlane},
        {"The parting line is simple and nested, seen along both directions", c.curvesSimpleAndNested},
        {"The cast does not cross itself", c.selfIntersectionFree},
        {"Both halves are closed, in one piece, and free to move at any distance", mold.problems.empty()}};
}

/// Those that missed their limit are open items too.
void addRegions(ReportData& data, const std::vector<ReportRegion>& regions) {
    for (const ReportRegion& region : regions) {
        const std::string moved = region.name + ": shape changed by " + figure(region.maxDistance, 2) + " mm";
        if (region.within <= 0) {
            data.regions.push_back({moved + ", no limit", true});
            continue;
        }
        const bool holds = region.maxDistance <= region.within;
        const std::string limit = figure(region.within, 2) + " mm";
        data.regions.push_back({moved + ", " + limit + " allowed", holds});
        if (!holds)
            data.openItems.push_back(moved + ", more than the " + limit + " allowed.");
    }
    std::stable_partition(data.regions.begin(), data.regions.end(),
                          [](const ReportCheck& check) { return !check.holds; });
}

std::vector<ReportDefault> defaults(const Mold& mold) {
    const MoldSettings usual;
    std::vector<ReportDefault> used;
    const auto add = [&](const std::string& name, double value, double normal, const std::string& unit,
                         const std::string& source) {
        if (value == normal)
            used.push_back({name, readable(value) + " " + unit, source});
    };
    add("Wall", mold.settings.wall, usual.wall, "mm", "open mold generators, 1.5 to 25 mm");
    add("Floor", mold.settings.floor, usual.floor, "mm", "as the wall");
    add("Ceiling", mold.settings.ceiling, usual.ceiling, "mm", "as the wall");
    add("Sizes round up to", mold.settings.step, usual.step, "mm", "own choice");
    add("Cavity pressure", mold.settings.pressure, usual.pressure, "bar",
        "no source: set it to your process");
    used.push_back({"Clamp allowance", "× 1.1", "1.1 to 1.2 in shop practice"});
    used.push_back({"Mix allowance", "10 %", "shop practice"});
    return used;
}

} // namespace

std::array<DraftBars, 2> draftBars(const IndexedMesh& placedCast, const Directions& directions) {
    std::array<DraftBars, 2> bars;
    std::array<double, 2> whole{};
    const SideLabels labels = labelSides(placedCast, PartingPlane{});
    for (int f = 0; f < placedCast.faceCount(); ++f) {
        const int side = labels[static_cast<std::size_t>(f)];
        if (side == 0)
            continue;
        const Vector3d c = doubleAreaVector(placedCast, f);
        const Vector3d& d = directions.of(side);
        const double draft = degrees(std::atan2(c.dot(d), c.cross(d).norm()));
        const double area = c.norm() / 2;
        const auto half = static_cast<std::size_t>(side - 1);
        const auto bar = static_cast<std::size_t>(std::clamp(draft / 5, 0.0, 17.0));
        bars[half].area[bar] += area;
        bars[half].worst = std::min(bars[half].worst, draft);
        bars[half].mean += area * draft;
        whole[half] += area;
    }
    for (std::size_t half = 0; half < 2; ++half)
        bars[half].mean = whole[half] > 0 ? bars[half].mean / whole[half] : 0;
    return bars;
}

ReportData reportData(const ReportSubject& subject) {
    ReportData data;
    data.partName = subject.partName;
    data.fileHash = subject.fileHash;
    data.date = subject.date;
    data.requiredDraft = subject.draftDegrees;
    addVerdict(data, subject);
    data.titleBlock = titleBlock(subject);
    data.partCaption = subject.partAnalysis ? "Red below " + angle(subject.draftDegrees) + ": " +
                                                  areaInCm2(subject.partAnalysis->violatingArea)
                                            : "As read";
    data.castCaption =
        subject.change && subject.part
            ? "Mean deviation " + figure(subject.change->meanDistance * diagonal(*subject.part), 2) + " mm"
            : "None yet";
    data.planeAndDirections = planeAndDirections(subject);
    data.numbers = numbers(subject);
    data.kept = kept(subject);
    if (subject.mold) {
        data.bars = draftBars(*subject.mold->cast, subject.mold->directions);
        data.halves = halves(*subject.mold);
        data.checks = checks(*subject.mold);
        data.defaults = defaults(*subject.mold);
        data.openItems = subject.mold->problems;
    } else {
        data.openItems.emplace_back(subject.cast ? "Build the mold."
                                                 : "Make the part castable, then build the mold.");
    }
    addRegions(data, subject.regions);
    data.variants = subject.variants;
    return data;
}

} // namespace moldwright
