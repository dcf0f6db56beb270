// SPDX-License-Identifier: AGPL-3.0-or-later
#include "report/report_data.h"

#include "mesh/measures.h"
#include "mold/pour_tilt.h"
#include "mold/shrink.h"
#include "report/figures.h"
#include "report/mold_defaults.h"
#include "report/mold_features.h"

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

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

void addVerdict(ReportData& data, const ReportSubject& subject, const Phrases& say) {
    const std::string required = angle(subject.draftDegrees);
    data.verdict = say(MW_TEXT("Report", "Not castable yet"));
    if (!subject.cast) {
        data.statement =
            say(MW_TEXT("Report", "No cast has been made of this part. Required draft {0}."), {required});
    } else if (!subject.mold) {
        data.verdict = say(MW_TEXT("Report", "No mold yet"));
        data.statement =
            say(MW_TEXT("Report", "The cast is there, its mold could not be built. Required draft {0}."),
                {required});
    } else if (subject.mold->verified()) {
        data.proved = true;
        data.verdict = say(MW_TEXT("Report", "Castable. The mold opens."));
        data.statement = say(MW_TEXT("Report", "Proved on the written halves for every face: draft {0} or "
                                               "more, where {1} is required."),
                             {provedAngle(*subject.mold), required});
    } else {
        data.statement = say(MW_TEXT("Report", "The mold is not proved to open. Open items are on page 2."));
    }
}

/// "1.5 %, 1 + S: factor 1.015"; by axes of the part where they differ.
std::string shrinkText(const ShrinkSettings& shrink, const Phrases& say) {
    const Vector3d& percent = shrink.percent;
    if (percent.isZero(0))
        return say(MW_TEXT("Report", "none, factor 1"));
    const auto factor = [&](int axis) { return readable(shrinkFactor(percent[axis], shrink.formula), 5); };
    const std::string formula = shrink.formula == ShrinkFormula::Plus ? "1 + S" : "1/(1 − S)";
    if (percent.x() == percent.y() && percent.y() == percent.z())
        return say(MW_TEXT("Report", "{0} %, {1}: factor {2}"), {readable(percent.x()), formula, factor(0)});
    return say(MW_TEXT("Report", "x {0}, y {1}, z {2} %, {3}: factors {4}, {5}, {6}"),
               {readable(percent.x()), readable(percent.y()), readable(percent.z()), formula, factor(0),
                factor(1), factor(2)});
}

/// The thinnest steel's row, with what it stands between.
ReportRow steelRow(const Mold& mold, const Phrases& say) {
    std::string name = say(MW_TEXT("Report", "Smallest steel"));
    if (!mold.steel.empty())
        name = say(MW_TEXT("Report", "Smallest steel, {0} to {1}"),
                   {say(lowerCase(mold.steel.front().first)), say(lowerCase(mold.steel.front().second))});
    return {name, figure(mold.minWall, 2) + " mm", true};
}

/// What is cast, by the material that was chosen.
std::string materialText(const Mold* mold, const Phrases& say) {
    return mold != nullptr && mold->settings.material ? say(mold->settings.material->name)
                                                      : say(MW_TEXT("Report", "not chosen"));
}

/// How many there are; of what, where they differ.
std::string cavitiesText(const Mold* mold, const Phrases& say) {
    if (mold == nullptr)
        return say(MW_TEXT("Report", "no mold yet"));
    std::string text = std::to_string(mold->cavities);
    if (mold->parts.size() > 1)
        for (const PartOfMold& part : mold->parts)
            text += (&part == &mold->parts.front() ? ": " : ", ") + std::to_string(part.cavities) + " × " +
                    part.name;
    return text;
}

/// What a shot takes, and its mass where the density is known.
std::string mixText(const Mold& mold) {
    const double volume = 1.1 * (mold.cavityVolume + mold.channelVolume);
    const double grams = volume / 1000 * mold.settings.density;
    return volumeInCm3(volume) + (grams > 0 ? ", " + readable(grams, 3) + " g" : "");
}

std::vector<ReportRow> titleBlock(const ReportSubject& subject, const Phrases& say) {
    const SharedMesh& shown = subject.cast ? subject.cast : subject.part;
    const auto given = [](const std::string& text) { return text.empty() ? "–" : text; };
    return {{say(MW_TEXT("Report", "Part")), subject.partName},
            {say(MW_TEXT("Report", "Number")), given(subject.partNumber)},
            {say(MW_TEXT("Report", "Revision")), given(subject.revision)},
            {say(MW_TEXT("Report", "Read from")), subject.sourceFile},
            {say(MW_TEXT("Report", "Size")),
             shown ? sizeInMillimetres(boundingBox(*shown).sizes()) : say(MW_TEXT("Report", "none"))},
            {say(MW_TEXT("Report", "Date")), subject.date},
            {say(MW_TEXT("Report", "Units")), say(MW_TEXT("Report", "millimetres, degrees"))},
            {say(MW_TEXT("Report", "Cavities")), cavitiesText(subject.mold.get(), say)},
            {say(MW_TEXT("Report", "Material")), materialText(subject.mold.get(), say)},
            {say(MW_TEXT("Report", "Shrink")), subject.mold ? shrinkText(subject.mold->settings.shrink, say)
                                                            : say(MW_TEXT("Report", "no mold yet"))}};
}

ReportSection planeAndDirections(const ReportSubject& subject, const Phrases& say) {
    ReportSection section{say(MW_TEXT("Report", "Parting plane and directions")), {}};
    if (!subject.state) {
        section.rows.push_back({say(MW_TEXT("Report", "Plane")), say(MW_TEXT("Report", "none chosen"))});
        return section;
    }
    const auto& [plane, directions] = *subject.state;
    const auto direction = [&](const Vector3d& d, const Vector3d& outward, const char* against) {
        return figures(d, 4) + "\n" +
               say(MW_TEXT("Report", "{0} to {1}"), {angle(angleBetween(d, outward)), against});
    };
    section.rows = {{say(MW_TEXT("Report", "Plane, n · x = o")),
                     "n = " + figures(plane.normal, 4) + "\no = " + figure(plane.offset, 2) + " mm"},
                    {say(MW_TEXT("Report", "Direction 1")), direction(directions.d1, plane.normal, "n")},
                    {say(MW_TEXT("Report", "Direction 2")), direction(directions.d2, -plane.normal, "−n")}};
    return section;
}

/// How the mold leans while it is filled, or had better.
void addLeaning(ReportSection& section, const Mold& mold, const Phrases& say) {
    if (!mold.leaning)
        return;
    const LeaningMold& lean = *mold.leaning;
    section.rows.push_back(
        {say(lean.applied ? MW_TEXT("Report", "Tilted while it is filled")
                          : MW_TEXT("Report", "Better tilted while it is filled")),
         say(MW_TEXT("Report", "{0}° towards {1}\nair: {2} mm³, upright {3} mm³"),
             {readable(lean.degrees, 3), say(leaningWords(mold.settings.spout.resting, lean.towards)),
              figure(lean.air, 0), figure(lean.airUpright, 0)})});
}

ReportSection numbers(const ReportSubject& subject, const Phrases& say) {
    ReportSection section{say(MW_TEXT("Report", "Numbers")), {}};
    if (!subject.mold) {
        if (subject.part)
            section.rows.push_back(
                {say(MW_TEXT("Report", "Volume of the part")), volumeInCm3(volume(*subject.part))});
        return section;
    }
    const Mold& mold = *subject.mold;
    section.rows = {{say(MW_TEXT("Report", "Cavity, as cut")), volumeInCm3(mold.cavityVolume), true},
                    {say(MW_TEXT("Report", "Mix, with 10 % allowance")), mixText(mold)},
                    {say(MW_TEXT("Report", "Projected area in the plane")), areaInCm2(mold.partingArea)},
                    {say(MW_TEXT("Report", "Clamp force, {0} bar × 1.1"), {readable(mold.settings.pressure)}),
                     figure(mold.clampForce, mold.clampForce < 10 ? 2 : 1) + " kN"},
                    {say(MW_TEXT("Report", "Mold, closed")), sizeInMillimetres(mold.blockSize)},
                    steelRow(mold, say)};
    addLeaning(section, mold, say);
    return section;
}

ReportSection kept(const ReportSubject& subject, const Phrases& say) {
    ReportSection section{say(MW_TEXT("Report", "Kept from the part")), {}};
    if (!subject.change || !subject.part)
        return section;
    const double size = diagonal(*subject.part);
    const Change& change = *subject.change;
    section.rows = {
        {say(MW_TEXT("Report", "Mean deviation, after best fit")),
         figure(change.meanDistance * size, 2) + " mm"},
        {say(MW_TEXT("Report", "Largest deviation")), figure(change.maxDistance * size, 2) + " mm"},
        {say(MW_TEXT("Report", "Volume, cast over part")), figure(100 * change.volumeRatio, 1) + " %"},
        {say(MW_TEXT("Report", "Filled in")), figure(100 * change.filledVolumeFraction, 1) + " %"}};
    return section;
}

std::vector<ReportSection> halves(const Mold& mold, const Phrases& say) {
    const auto section = [&](const std::string& name, const MoldHalf& half, const Vector3d& d) {
        return ReportSection{name,
                             {{say(MW_TEXT("Report", "Size")), sizeInMillimetres(half.size)},
                              {say(MW_TEXT("Report", "Volume")), volumeInCm3(half.volume)},
                              {say(MW_TEXT("Report", "Opens along, mold’s frame")), figures(d, 4)}}};
    };
    return {section(say(MW_TEXT("Report", "Mold half 1")), mold.half1, mold.directions.d1),
            section(say(MW_TEXT("Report", "Mold half 2")), mold.half2, mold.directions.d2)};
}

std::vector<ReportCheck> checks(const Mold& mold, const Phrases& say) {
    const Certificate& c = mold.castCertificate;
    return {
        {say(MW_TEXT("Report", "The cast is closed, manifold and outward")), c.closedAndOutward},
        {say(MW_TEXT("Report", "Each direction leaves the parting plane on its side")), c.directionsLeave},
        {say(MW_TEXT("Report", "Every face has a draft of {0} or more, in exact arithmetic"),
             {angle(mold.draftDegrees)}),
         c.draftHolds},
        {say(MW_TEXT("Report", "No face lies across the parting plane")), c.curvesOnPlane},
        {say(MW_TEXT("Report", "The parting line is simple and nested, seen along both directions")),
         c.curvesSimpleAndNested},
        {say(MW_TEXT("Report", "The cast does not cross itself")), c.selfIntersectionFree},
        {say(MW_TEXT("Report", "Both halves are closed, in one piece, and free to move at any distance")),
         mold.problems.empty()}};
}

/// Those that missed their limit are open items too.
void addRegions(ReportData& data, const std::vector<ReportRegion>& regions, const Phrases& say) {
    for (const ReportRegion& region : regions) {
        const std::string moved = figure(region.maxDistance, 2) + " mm";
        const std::string limit = figure(region.within, 2) + " mm";
        if (region.within <= 0) {
            data.regions.push_back(
                {say(MW_TEXT("Report", "{0}: shape changed by {1}, no limit"), {region.name, moved}), true});
            continue;
        }
        const bool holds = region.maxDistance <= region.within;
        data.regions.push_back(
            {say(MW_TEXT("Report", "{0}: shape changed by {1}, {2} allowed"), {region.name, moved, limit}),
             holds});
        if (!holds)
            data.openItems.push_back(
                say(MW_TEXT("Report", "{0}: shape changed by {1}, more than the {2} allowed."),
                    {region.name, moved, limit}));
    }
    std::stable_partition(data.regions.begin(), data.regions.end(),
                          [](const ReportCheck& check) { return !check.holds; });
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

ReportData reportData(const ReportSubject& subject, const Phrases& say) {
    ReportData data;
    data.partName = subject.partName;
    data.fileHash = subject.fileHash;
    data.date = subject.date;
    data.requiredDraft = subject.draftDegrees;
    addVerdict(data, subject, say);
    data.titleBlock = titleBlock(subject, say);
    data.partCaption =
        subject.partAnalysis
            ? say(MW_TEXT("Report", "Red below {0}: {1}"),
                  {angle(subject.draftDegrees), areaInCm2(subject.partAnalysis->violatingArea)})
            : say(MW_TEXT("Report", "As read"));
    data.castCaption = subject.change && subject.part
                           ? say(MW_TEXT("Report", "Mean deviation {0} mm"),
                                 {figure(subject.change->meanDistance * diagonal(*subject.part), 2)})
                           : say(MW_TEXT("Report", "None yet"));
    data.planeAndDirections = planeAndDirections(subject, say);
    data.numbers = numbers(subject, say);
    data.kept = kept(subject, say);
    if (subject.mold) {
        data.bars = draftBars(*subject.mold->cast, subject.mold->directions);
        data.leastSteel = subject.mold->settings.leastSteel;
        data.halves = halves(*subject.mold, say);
        data.checks = checks(*subject.mold, say);
        data.defaults = blockDefaults(subject.mold->settings, say);
        data.features = featureTable(*subject.mold, say);
        data.featureDefaults = featureDefaults(subject.mold->settings, say);
        data.materialValues = materialValues(subject.mold->settings, say);
        data.notes = notesOf(*subject.mold, say);
        data.openItems = subject.mold->problems;
    } else {
        data.openItems.push_back(
            subject.cast ? say(MW_TEXT("Report", "Build the mold."))
                         : say(MW_TEXT("Report", "Make the part castable, then build the mold.")));
    }
    addRegions(data, subject.regions, say);
    data.variants = subject.variants;
    return data;
}

} // namespace moldwright
