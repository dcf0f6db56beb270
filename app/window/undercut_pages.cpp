// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/undercut_pages.h"

#include "theme/theme.h"
#include "window/action_table.h"
#include "window/presentation.h"
#include "window/row_id.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(UndercutPages)
};

using Treatment = UndercutChoice::Treatment;

const QString allId = u"undercuts"_s;
constexpr int marksAtOnce = 12; ///< more would hide the part

QString volumeText(double cubicMillimetres) {
    return u"%1 cm³"_s.arg(cubicMillimetres / 1000, 0, 'f', cubicMillimetres < 1000 ? 3 : 1);
}

QString nameOf(int number) {
    return Words::tr("Undercut %1").arg(number + 1);
}

QString valueOf(const Workbench& bench, int number) {
    const auto treatment = bench.treatmentOf(number);
    const FillableUndercut& undercut = bench.undercuts()[static_cast<std::size_t>(number)];
    const QString volume = volumeText(undercut.volume);
    if (!treatment)
        return volume;
    return (*treatment == Treatment::Fill ? Words::tr("fill, %1") : Words::tr("bend, %1")).arg(volume);
}

PropertyPage allPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{allId,
                      u"cavity"_s,
                      Words::tr("Undercuts"),
                      Words::tr("What a half cannot leave at this plane, region by region."),
                      {}};
    page.sections.push_back({Words::tr("Measured"),
                             {Property{u"undercut-count"_s, Words::tr("Regions"), {}, ReadingProperty{}},
                              Property{u"undercut-needed"_s, Words::tr("Not to be bent"),
                                       Words::tr("Regions that no bending frees."), ReadingProperty{}},
                              Property{u"undercut-sum"_s, Words::tr("To fill all"), {}, ReadingProperty{}}},
                             {actions[u"find-undercuts"_s], actions[u"run"_s]},
                             !bench.undercutsKnown()});
    return page;
}

QStringList notesOn(const FillableUndercut& undercut) {
    QStringList notes{undercut.needed
                          ? Words::tr("No bending frees it: have it filled, or move the plane.")
                          : Words::tr("Bending frees it. Filled, what lies about it stays as it is.")};
    if (undercut.joins)
        notes << Words::tr("Filling it joins pieces of the part that are apart.");
    return notes;
}

} // namespace

QString undercutId(int number) {
    return u"undercut-%1"_s.arg(number);
}

int undercutNumber(const QString& id) {
    return numberAfter(u"undercut-"_s, id);
}

void addUndercutRows(std::vector<ProjectRow>& rows, int parent, const Workbench& bench) {
    if (!bench.undercutsKnown())
        return;
    const auto count = static_cast<int>(bench.undercuts().size());
    rows.push_back({.id = allId,
                    .parent = parent,
                    .iconName = u"cavity"_s,
                    .name = Words::tr("Undercuts"),
                    .value = QString::number(count)});
    const int group = static_cast<int>(rows.size()) - 1;
    for (int i = 0; i < count; ++i) {
        const bool needed = bench.undercuts()[static_cast<std::size_t>(i)].needed;
        rows.push_back({.id = undercutId(i),
                        .parent = group,
                        .iconName = needed ? u"error"_s : u"cavity"_s,
                        .tint = needed ? std::optional(theme().error) : std::nullopt,
                        .name = nameOf(i),
                        .value = valueOf(bench, i)});
    }
}

PropertyPage undercutPage(int number, const Workbench& bench, const Actions& actions) {
    if (number < 0 || number >= static_cast<int>(bench.undercuts().size()))
        return allPage(bench, actions);
    const FillableUndercut& undercut = bench.undercuts()[static_cast<std::size_t>(number)];
    PropertyPage page{undercutId(number), u"cavity"_s, nameOf(number), Words::tr("Undercuts"), {}};
    page.sections.push_back(
        {Words::tr("What becomes of it"),
         {Property{u"treatment-%1"_s.arg(number), Words::tr("Treatment"),
                   Words::tr("By the rule: as the page of Deform says for all."),
                   ChoiceProperty{{Words::tr("By the rule"), Words::tr("Bend"), Words::tr("Fill")}}}},
         {actions[u"run"_s]},
         false,
         notesOn(undercut)});
    page.sections.push_back(
        {Words::tr("Where"),
         {Property{u"undercut-place"_s, Words::tr("X, Y, Z, mm"), {}, ReadingProperty{}},
          Property{u"undercut-size"_s, Words::tr("Size"), {}, ReadingProperty{}},
          Property{u"undercut-side"_s, Words::tr("Side"), {}, ReadingProperty{}},
          Property{u"undercut-volume"_s, Words::tr("To fill"),
                   Words::tr("What filling it takes, over the part's volume."), ReadingProperty{}}},
         {},
         false});
    return page;
}

void fillUndercutPage(PropertyPanel& panel, const Workbench& bench) {
    const std::vector<FillableUndercut>& undercuts = bench.undercuts();
    const auto reading = [&](const QString& id, const QString& value) {
        panel.setValue(id, QStringList{value, QString()});
    };
    if (panel.pageId() == allId) {
        double sum = 0;
        for (const FillableUndercut& undercut : undercuts)
            sum += undercut.volume;
        const auto needed = std::ranges::count_if(undercuts, [](const auto& u) { return u.needed; });
        const bool known = bench.undercutsKnown();
        reading(u"undercut-count"_s, known ? QString::number(undercuts.size()) : u"–"_s);
        reading(u"undercut-needed"_s, known ? QString::number(needed) : u"–"_s);
        reading(u"undercut-sum"_s, known ? volumeText(sum) : u"–"_s);
        return;
    }
    const int number = undercutNumber(panel.pageId());
    if (number < 0 || number >= static_cast<int>(undercuts.size()))
        return;
    const FillableUndercut& undercut = undercuts[static_cast<std::size_t>(number)];
    const auto treatment = bench.treatmentOf(number);
    panel.setValue(u"treatment-%1"_s.arg(number), !treatment ? 0 : *treatment == Treatment::Bend ? 1 : 2);
    const Eigen::Vector3d& p = undercut.place;
    reading(u"undercut-place"_s, u"%1  %2  %3"_s.arg(p.x(), 0, 'f', 1)
                                     .arg(p.y(), 0, 'f', 1)
                                     .arg(p.z(), 0, 'f', 1)
                                     .replace(u'-', QChar(0x2212)));
    reading(u"undercut-size"_s, u"%1 mm"_s.arg(undercut.size, 0, 'f', 1));
    reading(u"undercut-side"_s, undercut.side == 0 ? Words::tr("both") : QString::number(undercut.side));
    const double whole = bench.figures(bench.project().part).volume;
    reading(u"undercut-volume"_s,
            u"%1, %2"_s.arg(volumeText(undercut.volume), percentText(undercut.volume / whole)));
}

bool applyTreatment(Workbench& bench, const QString& id, int choice) {
    const int number = numberAfter(u"treatment-"_s, id);
    if (number < 0)
        return false;
    bench.treat(number, choice == 0   ? std::nullopt
                        : choice == 1 ? std::optional(Treatment::Bend)
                                      : std::optional(Treatment::Fill));
    return true;
}

std::vector<int> markedUndercuts(const Workbench& bench, const QString& selected) {
    std::vector<int> marked;
    const int chosen = undercutNumber(selected);
    if (chosen < 0 && selected != allId)
        return marked;
    const auto count = static_cast<int>(bench.undercuts().size());
    for (int i = 0; i < count; ++i)
        if (i < marksAtOnce || i == chosen)
            marked.push_back(i);
    return marked;
}

std::vector<scene::Chip> undercutMarks(const Workbench& bench, const QString& selected) {
    std::vector<scene::Chip> marks;
    for (const int i : markedUndercuts(bench, selected)) {
        const auto& place = bench.undercuts()[static_cast<std::size_t>(i)].place;
        const std::string words = u"%1, %2"_s.arg(nameOf(i), valueOf(bench, i)).toStdString();
        const bool bold = i == undercutNumber(selected);
        marks.push_back(
            {place, {{}, {{std::nullopt, {{words, scene::Ink::Text, bold}}, {}}}}, theme().scene.undercut});
    }
    return marks;
}

SharedMesh shownFilling(const Workbench& bench, const QString& selected) {
    const int number = undercutNumber(selected);
    if (number < 0 || number >= static_cast<int>(bench.undercuts().size()))
        return nullptr;
    // Shared with the list: views see by the pointer that it is the same.
    return bench.wallsOf(number);
}

} // namespace moldwright
