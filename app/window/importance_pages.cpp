// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/importance_pages.h"

#include "mesh/measures.h"
#include "theme/theme.h"
#include "window/action_table.h"
#include "window/common_value.h"
#include "window/presentation.h"
#include "window/row_id.h"
#include "window/workbench.h"

#include <QCoreApplication>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ImportancePages)
};

bool isRegion(const Workbench& bench, int number) {
    return number >= 0 && number < static_cast<int>(bench.project().importance.size());
}

const ImportantRegion& regionAt(const Workbench& bench, int number) {
    return bench.project().importance[static_cast<std::size_t>(number)];
}

QString nameOf(const ImportantRegion& region) {
    return QString::fromStdString(region.name);
}

QString millimetreText(double mm) {
    return u"%1 mm"_s.arg(mm, 0, 'f', 2);
}

/// What a run made of a region; null while none has, or where there is nothing to be measured.
const RegionMeasure* shownMeasure(const Workbench& bench, int number) {
    return regionAt(bench, number).faces.empty() ? nullptr : bench.measureOf(number);
}

bool missesLimit(const Workbench& bench, int number) {
    const RegionMeasure* measure = shownMeasure(bench, number);
    return measure && !keepsWithin(regionAt(bench, number), *measure);
}

QString valueOf(const Workbench& bench, int number) {
    const ImportantRegion& region = regionAt(bench, number);
    if (region.faces.empty())
        return Words::tr("empty");
    const QString weight = weightText(heaviest(region));
    if (region.keepWithin <= 0)
        return weight;
    if (const RegionMeasure* measure = shownMeasure(bench, number))
        return u"%1 %2 %3"_s.arg(measure->maxDistance, 0, 'f', 2)
            .arg(keepsWithin(region, *measure) ? u"≤"_s : u">"_s, millimetreText(region.keepWithin));
    return weight + u", ± "_s + millimetreText(region.keepWithin);
}

Property reading(const QString& id, const QString& label, const QString& help = {}, bool withGoal = false) {
    return {id, label, help, ReadingProperty{withGoal}};
}

PropertySection paintSection(const Workbench& bench, const Actions& actions) {
    const NumberProperty radius{u"mm"_s, 0.01, bench.largestBrush(), 0.1, 2, true};
    PropertySection section{
        Words::tr("Paint"),
        {Property{u"brush-radius"_s, Words::tr("Brush radius"),
                  Words::tr("Measured over the surface, so the brush does not jump to a near wall."), radius},
         Property{u"crease"_s, Words::tr("Stop at creases"),
                  Words::tr("How sharp an edge must be for the face tool to end there."),
                  NumberProperty{u"°"_s, 1, 90, 1, 0, true}}},
        {actions[u"paint"_s], actions[u"paint-erase"_s], actions[u"paint-crease"_s],
         actions[u"paint-piece"_s], actions[u"paint-lasso"_s]},
        true};
    section.notes = {Words::tr("Each stroke doubles the weight of what it covers; with Ctrl it halves it.")};
    return section;
}

PropertyPage allPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{allRegionsId(),
                      u"brush"_s,
                      Words::tr("Importance"),
                      Words::tr("What is painted keeps its shape; the rest gives way."),
                      {}};
    const bool none = bench.project().importance.empty();
    page.layout = u"%1 %2"_s.arg(none).arg(bench.largestBrush());
    PropertySection all{
        Words::tr("All regions"),
        {},
        {actions[u"clear-importance"_s], actions[u"import-weights"_s], actions[u"export-weights"_s]},
        false};
    if (none)
        all.notes = {Words::tr("No region yet. A stroke makes one; F2 gives it a name.")};
    else
        all.rows = {reading(u"region-count"_s, Words::tr("Regions")),
                    reading(u"region-kept"_s, Words::tr("Within their limits"))};
    page.sections = {paintSection(bench, actions), std::move(all)};
    return page;
}

double areaOf(const ImportantRegion& region, const IndexedMesh& part) {
    double area = 0;
    for (const int f : region.faces)
        area += doubleAreaVector(part, f).norm() / 2;
    return area;
}

void fillAll(PropertyPanel& panel, const Workbench& bench) {
    const auto count = static_cast<int>(bench.project().importance.size());
    int asked = 0;
    int kept = 0;
    for (int i = 0; i < count; ++i)
        if (regionAt(bench, i).keepWithin > 0 && shownMeasure(bench, i)) {
            ++asked;
            kept += missesLimit(bench, i) ? 0 : 1;
        }
    panel.setValue(u"region-count"_s, QStringList{QString::number(count), {}});
    panel.setValue(u"region-kept"_s,
                   QStringList{asked == 0 ? u"–"_s : Words::tr("%1 of %2").arg(kept).arg(asked), {}});
    panel.setMissesGoal(u"region-kept"_s, kept < asked);
}

/// What holds of one region, and of several together.
void fillTogether(PropertyPanel& panel, const Workbench& bench, const std::vector<int>& numbers) {
    std::size_t faces = 0;
    double area = 0;
    for (const int number : numbers) {
        faces += regionAt(bench, number).faces.size();
        area += areaOf(regionAt(bench, number), *bench.project().part);
    }
    panel.setValue(u"region-weight"_s,
                   common(numbers, [&](int number) { return heaviest(regionAt(bench, number)); }));
    panel.setValue(u"region-limit"_s,
                   common(numbers, [&](int number) { return regionAt(bench, number).keepWithin; }));
    panel.setValue(u"region-faces"_s, QStringList{QString::number(faces), {}});
    panel.setValue(u"region-area"_s, QStringList{u"%1 cm²"_s.arg(area / 100, 0, 'f', 2), {}});
}

void fillOne(PropertyPanel& panel, const Workbench& bench, int number) {
    const ImportantRegion& region = regionAt(bench, number);
    const RegionMeasure* measure = shownMeasure(bench, number);
    panel.setValue(u"region-moved"_s,
                   QStringList{measure ? millimetreText(measure->maxDistance) : u"–"_s,
                               region.keepWithin > 0 ? u"≤ "_s + millimetreText(region.keepWithin)
                                                     : Words::tr("no limit")});
    panel.setMissesGoal(u"region-moved"_s, missesLimit(bench, number));
    panel.setValue(u"region-rms"_s, QStringList{measure ? millimetreText(measure->rmsDistance) : u"–"_s, {}});
    panel.setValue(u"region-strain"_s, QStringList{measure ? percentText(measure->strain) : u"–"_s, {}});
}

} // namespace

QString regionId(int number) {
    return u"region-%1"_s.arg(number);
}

int regionNumber(const QString& id) {
    return numberAfter(u"region-"_s, id);
}

QString allRegionsId() {
    return u"importance"_s;
}

std::vector<int> regionNumbers(const QString& selected) {
    return numbersAfter(u"region-"_s, selected);
}

bool regionsChosen(const QString& selected) {
    return selected == allRegionsId() || !regionNumbers(selected).empty();
}

void addRegionRows(std::vector<ProjectRow>& rows, const Workbench& bench, const Visibility& visible) {
    const auto count = static_cast<int>(bench.project().importance.size());
    rows.push_back({.id = allRegionsId(),
                    .iconName = u"brush"_s,
                    .name = Words::tr("Importance"),
                    .value = count == 0 ? Words::tr("none") : QString::number(count),
                    .visible = visible.importance,
                    .strong = true});
    const int parent = static_cast<int>(rows.size()) - 1;
    for (int i = 0; i < count; ++i)
        rows.push_back({.id = regionId(i),
                        .parent = parent,
                        .iconName = missesLimit(bench, i) ? u"error"_s : u"region"_s,
                        .tint = missesLimit(bench, i) ? std::optional(theme().error) : std::nullopt,
                        .name = nameOf(regionAt(bench, i)),
                        .value = valueOf(bench, i),
                        .visible = visible.shows(regionId(i)),
                        .renamable = true});
}

PropertyPage regionPage(const QString& selected, const Workbench& bench, const Actions& actions) {
    const std::vector<int> numbers = regionNumbers(selected);
    if (numbers.empty() || !isRegion(bench, numbers.back()))
        return allPage(bench, actions);
    const bool several = numbers.size() > 1;
    const QString title =
        several ? Words::tr("%1 regions").arg(numbers.size()) : nameOf(regionAt(bench, numbers.front()));
    PropertyPage page{selected, u"region"_s, title, Words::tr("Importance"), {}};
    page.layout = page.title + u' ' + QString::number(bench.largestBrush());
    PropertySection weight{
        Words::tr("Region"),
        {Property{
             u"region-weight"_s, Words::tr("Weight"),
             Words::tr("The heaviest of its faces. Typed, it is given to all of them; 1 is only measured."),
             NumberProperty{{}, 1, mostWeight, 1, 0, false}},
         Property{u"region-limit"_s, Words::tr("Keep within ±"),
                  Words::tr("How far its points may move against each other; 0 is no limit."),
                  NumberProperty{u"mm"_s, 0, 100, 0.05, 2, false}},
         reading(u"region-faces"_s, Words::tr("Faces")), reading(u"region-area"_s, Words::tr("Area"))},
        {actions[u"remove-guide"_s]},
        false};
    if (several) {
        page.sections = {std::move(weight)};
        return page;
    }
    PropertySection measured{
        Words::tr("Measured in the cast"),
        {reading(u"region-moved"_s, Words::tr("Largest change"),
                 Words::tr("Of its shape, wherever it went as a whole: after its own best fit."), true),
         reading(u"region-rms"_s, Words::tr("Mean change"), Words::tr("Root of the mean square.")),
         reading(u"region-strain"_s, Words::tr("Strain"), Words::tr("How much its surface was stretched."))},
        {},
        false};
    page.sections = {std::move(weight), std::move(measured), paintSection(bench, actions)};
    return page;
}

void fillRegionPage(PropertyPanel& panel, const Workbench& bench) {
    if (!regionsChosen(panel.pageId()))
        return;
    panel.setValue(u"brush-radius"_s, bench.brushRadius());
    panel.setValue(u"crease"_s, bench.creaseDegrees());
    const std::vector<int> numbers = regionNumbers(panel.pageId());
    if (numbers.empty())
        return fillAll(panel, bench);
    if (!isRegion(bench, numbers.back()))
        return;
    fillTogether(panel, bench, numbers);
    if (numbers.size() == 1)
        fillOne(panel, bench, numbers.front());
}

bool applyRegionValue(Workbench& bench, const QString& id, const QString& page, double value, bool preview) {
    if (!regionsChosen(page))
        return false;
    const std::vector<int> numbers = regionNumbers(page);
    const bool known = !numbers.empty() && isRegion(bench, numbers.back());
    if (id == u"brush-radius"_s)
        bench.setBrushRadius(value);
    else if (id == u"crease"_s)
        bench.setCreaseDegrees(value);
    else if (id == u"region-weight"_s && known)
        bench.weighRegions(numbers, value, preview);
    else if (id == u"region-limit"_s && known)
        bench.limitRegions(numbers, value, preview);
    else
        return false;
    return true;
}

} // namespace moldwright
