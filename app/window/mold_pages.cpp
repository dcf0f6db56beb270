// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/mold_pages.h"

#include "project/edits.h"
#include "window/action_table.h"
#include "window/material_pages.h"
#include "window/mold_fields.h"
#include "window/preset_choice.h"
#include "window/tray_pages.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MoldPages)
};

Property reading(const QString& id, const QString& label) {
    return {id, label, {}, ReadingProperty{}};
}

QStringList measured(const QString& value) {
    return {value, {}};
}

void fillMeasured(PropertyPanel& panel, const Workbench& bench, const Mold& mold) {
    const auto size = [](const Eigen::Vector3d& s) {
        return u"%1 × %2 × %3"_s.arg(s.x(), 0, 'f', 1).arg(s.y(), 0, 'f', 1).arg(s.z(), 0, 'f', 1);
    };
    const auto volume = [](double cubicMillimetres, int decimals) {
        return measured(u"%1 cm³"_s.arg(cubicMillimetres / 1000, 0, 'f', decimals));
    };
    panel.setValue(u"half1"_s, measured(size(mold.half1.size)));
    panel.setValue(u"half2"_s, measured(size(mold.half2.size)));
    panel.setValue(u"cavity"_s, volume(mold.cavityVolume, 1));
    panel.setValue(u"channels"_s, volume(mold.channelVolume, 1));
    panel.setValue(u"trapped"_s, volume(mold.trappedAir, 2));
    panel.setValue(u"halves"_s, volume(mold.half1.volume + mold.half2.volume, 0));
    panel.setValue(u"clamp"_s, measured(u"%1 kN"_s.arg(mold.clampForce, 0, 'f', 2)));
    panel.setValue(u"steel"_s, measured(u"%1 mm"_s.arg(mold.minWall, 0, 'f', 2)));
    panel.setValue(u"proof"_s, measured(!bench.moldIsCurrent() ? Words::tr("out of date")
                                        : mold.verified()      ? Words::tr("proved")
                                                               : Words::tr("no")));
    panel.setMissesGoal(u"proof"_s, !mold.verified());
}

} // namespace

PropertyPage moldPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{u"mold"_s, u"mold"_s, Words::tr("Mold"), trayWords(bench), {}};
    page.layout = (bench.moldIsCurrent() ? u"built,"_s : QString()) + presetNamesShown().join(u',') +
                  materialLayout(bench.project());
    for (const MoldFieldSection& section : moldFieldSections())
        page.sections.push_back(sectionOf(section));
    page.sections.insert(page.sections.begin() + 1, materialSection(bench.project(), actions));
    page.sections.front().primary = true;
    page.sections.front().buttons =
        bench.moldIsCurrent()
            ? std::vector{actions[u"export-mold"_s], actions[u"build-mold"_s], actions[u"open-mold"_s]}
            : std::vector{actions[u"build-mold"_s]};
    addTraySection(page, bench, actions);
    page.sections.push_back(presetSection(actions));
    page.sections.push_back(
        {Words::tr("Measured"),
         {reading(u"half1"_s, Words::tr("Half 1, mm")), reading(u"half2"_s, Words::tr("Half 2, mm")),
          reading(u"cavity"_s, Words::tr("Cavities")), reading(u"channels"_s, Words::tr("Channels")),
          reading(u"trapped"_s, Words::tr("Air that stays")), reading(u"halves"_s, Words::tr("Both halves")),
          reading(u"clamp"_s, Words::tr("Clamp force")), reading(u"steel"_s, Words::tr("Smallest steel")),
          reading(u"proof"_s, Words::tr("Comes off"))},
         {},
         false});
    return page;
}

void fillMoldPage(PropertyPanel& panel, const Workbench& bench) {
    if (panel.pageId() != u"mold"_s)
        return;
    for (const MoldFieldSection& section : moldFieldSections())
        fillFields(panel, section, bench.project().mold);
    fillMaterialSection(panel, bench.project());
    panel.setValue(presetRow(), presetShown(bench.project().mold));
    if (bench.mold())
        fillMeasured(panel, bench, *bench.mold());
}

std::optional<Project> withMoldValue(const Project& project, const QString& id, const QVariant& value) {
    const auto changed = [&](MoldSettings mold) {
        return mold == project.mold ? std::nullopt : std::optional(withMoldSettings(project, mold));
    };
    if (id == presetRow())
        return changed(withPresetShown(project.mold, value.toInt()));
    if (id == materialRow())
        return changed(withMaterialShown(project.mold, value.toInt()));
    for (const MoldFieldSection& section : moldFieldSections())
        for (const MoldField& field : section.fields)
            if (field.row.id == id) {
                MoldSettings mold = project.mold;
                field.write(mold, value);
                return changed(mold);
            }
    return std::nullopt;
}

} // namespace moldwright
