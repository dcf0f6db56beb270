// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/tray_pages.h"

#include "project/further_parts.h"
#include "project/variants.h"
#include "window/action_table.h"
#include "window/mold_placing.h"
#include "window/presentation.h"
#include "window/row_id.h"
#include "window/sentence.h"
#include "window/workbench.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(TrayPages)
};

const QString countPrefix = u"tray-count-"_s; ///< then the part's number

Tray trayIn(const Workbench& bench) {
    return trayOf(bench.project(), bench.project().name);
}

QString nameOf(const Tray& tray, int number) {
    const std::string& name = tray[static_cast<std::size_t>(number)].name;
    return name.empty() ? Words::tr("Part %1").arg(number + 1) : QString::fromStdString(name);
}

/// How many cavities a part has; asked of the layout for the first, which takes what the others leave.
int cavitiesOf(const SeatedLayout& seats, int number) {
    return static_cast<int>(std::ranges::count(seats.partAt, static_cast<std::size_t>(number)));
}

QString composition(const Tray& tray, const LayoutSettings& layout) {
    const Result<SeatedLayout> seats = seated(tray, layout);
    if (!seats)
        return sentence(seats.error().message);
    QStringList parts;
    for (int i = 0; i < static_cast<int>(tray.size()); ++i)
        parts << u"%1 × %2"_s.arg(cavitiesOf(*seats, i)).arg(nameOf(tray, i));
    return Words::tr("%1 cavities: %2").arg(seats->partAt.size()).arg(parts.join(u", "_s));
}

Property countRow(int number, const QString& label) {
    const QString id = countPrefix + QString::number(number);
    if (number == 0)
        return {id, label, Words::tr("All places of the layout that the other parts leave."),
                ReadingProperty{}};
    return {id, label, Words::tr("How many cavities the mold has of it."),
            NumberProperty{{}, 1, mostCavities, 1, 0, false}};
}

Property reading(const QString& id, const QString& label, const QString& help = {}) {
    return {id, label, help, ReadingProperty{}};
}

void fillCounts(PropertyPanel& panel, const Workbench& bench, const Tray& tray) {
    const Result<SeatedLayout> seats = seated(tray, bench.project().mold.layout);
    panel.setValue(countPrefix + u'0',
                   QStringList{seats ? QString::number(cavitiesOf(*seats, 0)) : u"–"_s, {}});
    for (int i = 1; i < static_cast<int>(tray.size()); ++i)
        panel.setValue(countPrefix + QString::number(i), tray[static_cast<std::size_t>(i)].count);
}

} // namespace

QString trayId(int number) {
    return u"tray-%1"_s.arg(number);
}

int trayNumber(const QString& id) {
    return numberAfter(u"tray-"_s, id);
}

std::size_t trayRowCount(const Workbench& bench) {
    const std::size_t further = bench.project().furtherParts.size();
    return further > 0 ? further + 1 : 0;
}

void addTrayRows(std::vector<ProjectRow>& rows, int parent, const Workbench& bench) {
    if (trayRowCount(bench) == 0)
        return;
    const Tray tray = trayIn(bench);
    const Result<SeatedLayout> seats = seated(tray, bench.project().mold.layout);
    for (int i = 0; i < static_cast<int>(tray.size()); ++i)
        rows.push_back({.id = trayId(i),
                        .parent = parent,
                        .iconName = u"part"_s,
                        .name = nameOf(tray, i),
                        .value = seats ? u"×%1"_s.arg(cavitiesOf(*seats, i)) : u"–"_s,
                        .renamable = i > 0});
}

QString trayWords(const Workbench& bench) {
    if (const QString refusal = bench.placing().refusal(); !refusal.isEmpty())
        return refusal;
    return trayRowCount(bench) == 0 ? Words::tr("Two halves around the cast.")
                                    : composition(trayIn(bench), bench.project().mold.layout);
}

void addTraySection(PropertyPage& page, const Workbench& bench, const Actions& actions) {
    PropertySection section{Words::tr("Parts in the mold"), {}, {actions[u"add-part"_s]}, false};
    const Tray tray = trayIn(bench);
    QStringList names;
    for (int i = 0; i < static_cast<int>(trayRowCount(bench)); ++i) {
        names << nameOf(tray, i);
        section.rows.push_back(countRow(i, names.back()));
    }
    page.layout += u';' + names.join(u',');
    const auto layout = std::ranges::find_if(page.sections, [](const PropertySection& other) {
        return std::ranges::find(other.rows, u"columns"_s, &Property::id) != other.rows.end();
    });
    page.sections.insert(layout == page.sections.end() ? layout : layout + 1, std::move(section));
}

namespace {

/// The cavities of the plan that have a part, and where they are in the project's own part's frame.
std::vector<std::pair<std::string, Eigen::Vector3d>> cavitiesInPlan(const Workbench& bench) {
    std::vector<std::pair<std::string, Eigen::Vector3d>> cavities;
    const MoldSketch* sketch = bench.placing().sketch();
    if (sketch == nullptr || trayRowCount(bench) == 0)
        return cavities;
    const Eigen::Isometry3d toPart = sketch->partToMold.inverse();
    for (const MoldFeature& feature : sketch->features)
        if (!feature.part.empty())
            cavities.emplace_back(feature.part,
                                  toPart * Eigen::Vector3d(feature.place.x(), feature.place.y(), 0));
    return cavities;
}

/// Whether a cavity of the plan is one of this part; a part that is gone has none.
bool isOf(const std::string& cavity, const Tray& tray, int number) {
    return number >= 0 && number < static_cast<int>(tray.size()) &&
           cavity == partName(tray, static_cast<std::size_t>(number));
}

} // namespace

Eigen::AlignedBox3d trayPlace(int number, const Workbench& bench) {
    Eigen::AlignedBox3d box;
    const Tray tray = trayIn(bench);
    for (const auto& [name, place] : cavitiesInPlan(bench))
        if (isOf(name, tray, number)) {
            const SharedMesh& mesh = tray[static_cast<std::size_t>(number)].cast->mesh;
            const Eigen::Vector3d reach =
                Eigen::Vector3d::Constant(bench.figures(mesh).box.diagonal().norm() / 2);
            box.extend(place - reach);
            box.extend(place + reach);
        }
    return box;
}

std::vector<scene::Chip> trayChips(const Workbench& bench, const QString& selected) {
    std::vector<scene::Chip> chips;
    const Tray tray = trayIn(bench);
    for (const auto& [name, place] : cavitiesInPlan(bench))
        chips.push_back(
            {place,
             {{}, {{std::nullopt, {{name, scene::Ink::Text, isOf(name, tray, trayNumber(selected))}}, {}}}}});
    return chips;
}

PropertyPage trayPage(int number, const Workbench& bench, const Actions& actions) {
    const Tray tray = trayIn(bench);
    const QString source = QString::fromStdString(tray[static_cast<std::size_t>(number)].source);
    const QString refusal = bench.placing().refusal();
    PropertyPage page{trayId(number),
                      u"part"_s,
                      nameOf(tray, number),
                      !refusal.isEmpty() ? refusal
                      : number == 0      ? Words::tr("The cast of this project, in its mold.")
                                         : Words::tr("A further part in the same mold."),
                      {}};
    page.layout = source;
    page.sections.push_back({Words::tr("In the mold"),
                             {countRow(number, Words::tr("Cavities"))},
                             number == 0 ? std::vector{actions[u"add-part"_s]}
                                         : std::vector{actions[u"add-part"_s], actions[u"read-part-again"_s],
                                                       actions[u"rename"_s], actions[u"remove-guide"_s]},
                             false});
    page.sections.push_back(
        {Words::tr("Its cast"),
         {reading(u"tray-source"_s, Words::tr("Read from"), QDir::toNativeSeparators(source)),
          Property{
              u"tray-draft"_s, Words::tr("Worst draft"),
              Words::tr("Along its own directions; in the mold it leaves along those of the first part."),
              ReadingProperty{true}},
          reading(u"tray-size"_s, Words::tr("Size, mm")), reading(u"tray-volume"_s, Words::tr("Volume"))},
         {},
         false});
    return page;
}

void fillTrayPage(PropertyPanel& panel, const Workbench& bench) {
    const int number = trayNumber(panel.pageId());
    if (trayRowCount(bench) == 0 || (number < 0 && panel.pageId() != u"mold"_s))
        return;
    const Tray tray = trayIn(bench);
    fillCounts(panel, bench, tray);
    if (number < 0 || number >= static_cast<int>(tray.size()))
        return;
    const auto set = [&](const QString& id, const QString& value, const QString& goal = {}) {
        panel.setValue(id, QStringList{value, goal});
    };
    const TrayPart& part = tray[static_cast<std::size_t>(number)];
    const QString source = QFileInfo(QString::fromStdString(part.source)).fileName();
    set(u"tray-source"_s, number == 0 ? Words::tr("this project") : source);
    if (!part.cast)
        return;
    const double draft = leastDraftDegrees(*part.cast);
    const bool asked = bench.project().cast != nullptr;
    const double required = asked ? bench.project().cast->draftDegrees : 0;
    set(u"tray-draft"_s, draftText(draft), asked ? u"≥ "_s + angleText(required) : QString());
    constexpr double rounding = 1e-9; // the proof is exact, this is not
    panel.setMissesGoal(u"tray-draft"_s, asked && draft < required - rounding);
    const MeshFigures figures = bench.figures(part.cast->mesh);
    const Eigen::Vector3d size = figures.box.sizes();
    set(u"tray-size"_s,
        u"%1 × %2 × %3"_s.arg(size.x(), 0, 'f', 1).arg(size.y(), 0, 'f', 1).arg(size.z(), 0, 'f', 1));
    set(u"tray-volume"_s, u"%1 cm³"_s.arg(figures.volume / 1000, 0, 'f', 1));
}

bool applyTrayValue(Workbench& bench, const QString& id, int value, bool preview) {
    const int number = numberAfter(countPrefix, id);
    if (number < 1 || number >= static_cast<int>(trayRowCount(bench)))
        return false;
    bench.countPartOfMold(number - 1, value, preview);
    return true;
}

} // namespace moldwright
