// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/property_pages.h"

#include "window/action_table.h"
#include "window/chosen_features.h"
#include "window/importance_pages.h"
#include "window/mold_feature_pages.h"
#include "window/mold_pages.h"
#include "window/obstruction_words.h"
#include "window/pin_pages.h"
#include "window/presentation.h"
#include "window/refusal_pages.h"
#include "window/selection.h"
#include "window/sentence.h"
#include "window/tray_pages.h"
#include "window/undercut_pages.h"
#include "window/variant_pages.h"
#include "window/workbench.h"

#include <QCoreApplication>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PropertyPages)
};

Property number(const QString& id, const QString& label, const QString& help, NumberProperty kind) {
    return {id, label, help, kind};
}

Property reading(const QString& id, const QString& label, const QString& help = {}) {
    return {id, label, help, ReadingProperty{}};
}

/// A reading in a section where goals stand beside the values.
Property goalReading(const QString& id, const QString& label, const QString& help = {}) {
    return {id, label, help, ReadingProperty{true}};
}

PropertySection draftGoal() {
    return {Words::tr("Goal"),
            {number(u"draft"_s, Words::tr("Draft required"),
                    Words::tr("The least angle between the surface and the direction its half leaves in."),
                    {u"°"_s, 0, 10, 0.1, 1, true})},
            {},
            false};
}

ChoiceProperty directionChoices() {
    return {{Words::tr("Best for the plane"), Words::tr("Along the normal"), Words::tr("As they are")}};
}

/// How a run is to choose the removal directions, and what limits them.
auto directionRows() -> decltype(PropertySection::rows) {
    return {Property{u"choice"_s, Words::tr("Directions"),
                     Words::tr("How the removal directions are chosen."), directionChoices()},
            Property{u"follow"_s, Words::tr("While it bends"),
                     Words::tr("Whether directions that are best for the plane are sought anew as the shape "
                               "bends. The paper's method always does that."),
                     ChoiceProperty{{Words::tr("They stay"), Words::tr("They follow the shape")}}},
            number(u"tilt"_s, Words::tr("Tilt limit"),
                   Words::tr("How far a direction may lean from the plane's normal."),
                   {u"°"_s, 0, 60, 1, 0, true}),
            Property{u"axis"_s, Words::tr("Axis"),
                     Words::tr("The axis that the press pulls along: both directions keep to it."),
                     ChoiceProperty{{Words::tr("Any"), Words::tr("X"), Words::tr("Y"), Words::tr("Z"),
                                     Words::tr("That of direction 1")}}},
            number(u"cone"_s, Words::tr("Off the axis"),
                   Words::tr("How far a direction may lean from the axis; 0 holds it there."),
                   {u"°"_s, 0, 60, 1, 0, true})};
}

PropertyPage partPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{
        u"part"_s, u"part"_s, QString::fromStdString(bench.project().name), Words::tr("Part"), {}};
    page.layout = page.title;
    page.sections.push_back(
        {Words::tr("Title"),
         {Property{u"part-name"_s, Words::tr("Name"), Words::tr("Of the part."), TextProperty{}},
          Property{u"part-number"_s, Words::tr("Number"), Words::tr("As its drawing has it."),
                   TextProperty{}},
          Property{u"part-revision"_s, Words::tr("Revision"), Words::tr("As its drawing has it."),
                   TextProperty{}}},
         {},
         false});
    page.sections.push_back({Words::tr("Size"),
                             {number(u"size"_s, Words::tr("Longest side"),
                                     Words::tr("Scales the whole part."), {u"mm"_s, 0.1, 5000, 1, 1, false})},
                             {},
                             false});
    const NumberProperty place{u"mm"_s, -10000, 10000, 1, 1, false};
    page.sections.push_back(
        {Words::tr("Place of its middle"),
         {number(u"x"_s, Words::tr("X"), {}, place), number(u"y"_s, Words::tr("Y"), {}, place),
          number(u"z"_s, Words::tr("Z"), {}, place)},
         {actions[u"turn-x"_s], actions[u"turn-y"_s], actions[u"turn-z"_s], actions[u"turn-by"_s],
          actions[u"lay-flat"_s], actions[u"centre"_s]},
         false});
    page.sections.push_back(
        {Words::tr("Measured"),
         {reading(u"extent"_s, Words::tr("Size, mm")), reading(u"volume"_s, Words::tr("Volume")),
          reading(u"area"_s, Words::tr("Surface")), reading(u"faces"_s, Words::tr("Faces"))},
         {},
         false});
    return page;
}

/// The planes of the last search, to be tried by a click or the arrow keys.
PropertySection offeredSection(const Workbench& bench) {
    PicturesProperty pictures;
    const QString required = angleText(bench.project().design.draftDegrees);
    for (const OfferedPlane& offered : bench.offeredPlanes()) {
        const PlaneCandidate& plane = offered.plane;
        const scene::SmallPicture& drawn = offered.picture;
        const QImage picture(drawn.rgba.data(), drawn.width, drawn.height, QImage::Format_RGBA8888);
        const QString below =
            Words::tr("%1 below %2").arg(percentText(plane.violatingAreaFraction), required);
        const QString worst = Words::tr("Worst %1").arg(draftText(plane.worstDraftDegrees));
        const QString tilt =
            Words::tr("Directions tilted by %1 and %2, %3 of the volume on the smaller side")
                .arg(angleText(tiltDegrees(plane.state, 1)), angleText(tiltDegrees(plane.state, 2)),
                     percentText(plane.smallerVolumeFraction));
        pictures.pictures.push_back({picture.copy(), below, worst, below + u'\n' + worst + u'\n' + tilt});
    }
    return {Words::tr("Planes found, best first"),
            {Property{u"offered"_s, Words::tr("Planes found, best first"), {}, std::move(pictures)}},
            {},
            false};
}

PropertyPage planePage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{u"plane"_s,
                      u"plane"_s,
                      Words::tr("Parting plane"),
                      Words::tr("Drag its grips in the view, or type here."),
                      {}};
    page.sections.push_back(draftGoal());
    page.sections.push_back({Words::tr("Plane"),
                             {number(u"offset"_s, Words::tr("Offset"),
                                     Words::tr("Distance of the plane from the origin along its normal."),
                                     {u"mm"_s, -10000, 10000, 1, 2, false})},
                             {actions[u"best-plane"_s], actions[u"next-plane"_s], actions[u"along-normal"_s]},
                             true});
    if (!bench.offeredPlanes().empty()) {
        page.sections.push_back(offeredSection(bench));
        page.layout = u"search-%1"_s.arg(bench.searchNumber());
    }
    page.sections.push_back({Words::tr("Directions"),
                             directionRows(),
                             {actions[u"best-directions"_s], actions[u"normal-directions"_s]},
                             false});
    page.sections.push_back(
        {Words::tr("Measured"),
         {goalReading(u"worst"_s, Words::tr("Worst draft")), goalReading(u"below"_s, Words::tr("Area below")),
          goalReading(u"tilt1"_s, Words::tr("Direction 1"), Words::tr("Angle to the plane's normal.")),
          goalReading(u"tilt2"_s, Words::tr("Direction 2"), Words::tr("Angle to the plane's normal.")),
          goalReading(u"crease"_s, Words::tr("Sharpest crease"),
                      Words::tr("At the parting line, where the directions are not parallel."))},
         {},
         false});
    return page;
}

PropertyPage directionPage(int side, const Workbench& bench, const Actions& actions) {
    PropertyPage page{u"direction-%1"_s.arg(side),
                      u"direction"_s,
                      Words::tr("Direction %1").arg(side),
                      Words::tr("Drag the arrow's tip in the view, or type here."),
                      {}};
    const double limit = bench.project().design.limits.maxTiltDegrees;
    page.sections.push_back(
        {Words::tr("Direction"),
         {number(u"lean%1"_s.arg(side), Words::tr("Tilt"), Words::tr("Angle to the plane's normal."),
                 {u"°"_s, 0, limit, 1, 1, true}),
          number(u"way%1"_s.arg(side), Words::tr("Leans towards"),
                 Words::tr("The way it leans, counted in the plane. Without tilt it says nothing."),
                 {u"°"_s, 0, 360, 15, 1, false}),
          reading(u"components%1"_s.arg(side), Words::tr("X, Y, Z"))},
         {actions[u"best-directions"_s], actions[u"normal-directions"_s]},
         false});
    page.sections.push_back({Words::tr("While it runs"), directionRows(), {}, false});
    page.sections.push_back({Words::tr("Measured"),
                             {goalReading(u"worst"_s, Words::tr("Worst draft")),
                              goalReading(u"below"_s, Words::tr("Area below"))},
                             {},
                             false});
    return page;
}

PropertyPage deformPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{u"deform"_s,
                      u"deform"_s,
                      Words::tr("Deform"),
                      Words::tr("Bends the part until both halves come off."),
                      {}};
    page.layout = bench.running() ? u"running"_s : QString();
    PropertySection goal = draftGoal();
    goal.rows.push_back({u"method"_s, Words::tr("Method"), Words::tr("How the shape is bent."),
                         ChoiceProperty{{Words::tr("Elastic, then finish"), Words::tr("As in the paper")}}});
    goal.rows.push_back(number(u"smoothing"_s, Words::tr("Smoothing γ"),
                               Words::tr("How much neighbours turn alike in the paper's method."),
                               {{}, 0, 1, 0.05, 2, true}));
    goal.rows.push_back(
        {u"fill"_s, Words::tr("Where bending fails"),
         Words::tr("What becomes of places that no bending frees: told as an obstruction, or filled."),
         ChoiceProperty{{Words::tr("Leave as it is"), Words::tr("Fill")}}});
    page.sections.push_back(goal);
    page.sections.push_back(
        {Words::tr("While it runs"), directionRows(),
         bench.running()
             ? std::vector<QAction*>{actions[u"finish"_s], actions[u"pause"_s], actions[u"step-once"_s],
                                     actions[u"branch"_s], actions[u"stop"_s]}
             : std::vector<QAction*>{actions[u"run"_s], actions[u"restore"_s], actions[u"find-undercuts"_s]},
         true});
    page.sections.push_back(
        {Words::tr("Measured"),
         {goalReading(u"worst"_s, Words::tr("Worst draft")), goalReading(u"below"_s, Words::tr("Area below")),
          goalReading(u"energy"_s, Words::tr("Energy")), goalReading(u"volume"_s, Words::tr("Volume")),
          goalReading(u"distance"_s, Words::tr("Mean distance"),
                      Words::tr("To the part, over its diagonal, after the best rigid fit."))},
         {},
         false});
    return page;
}

PropertyPage obstructionPage(int number, const Workbench& bench, const Actions& actions) {
    const Obstruction& obstruction = bench.obstructions()[static_cast<std::size_t>(number)];
    PropertyPage page{
        obstructionId(number), u"error"_s, kindName(obstruction.kind), sentence(obstruction.message), {}};
    page.sections.push_back({Words::tr("Where"),
                             {reading(u"obstruction-place"_s, Words::tr("X, Y, Z, mm")),
                              reading(u"obstruction-size"_s, Words::tr("Size")),
                              reading(u"obstruction-side"_s, Words::tr("Side"))},
                             {},
                             false});
    std::vector<QAction*> remedies = {actions[remedyFor(obstruction)]};
    QStringList known;
    for (const Remedy& remedy : obstruction.remedies) {
        known << sentence(remedy.message);
        if (remedy.state)
            remedies.push_back(actions[u"suggested-plane"_s]);
    }
    if (!bench.placesToFill(number).empty())
        remedies.push_back(actions[u"fill-here"_s]);
    for (const QString& id : {u"best-plane"_s, u"next-plane"_s, u"fill-and-run"_s})
        if (actions[id] != remedies.front())
            remedies.push_back(actions[id]);
    page.sections.push_back({Words::tr("What helps"), {}, remedies, true, known});
    return page;
}

PropertyPage castPage(const Workbench&, const Actions& actions) {
    PropertyPage page{
        u"cast"_s, u"result"_s, Words::tr("Cast"), Words::tr("What will come out of the mold."), {}};
    page.sections.push_back(
        {Words::tr("Castability"),
         {goalReading(u"worst"_s, Words::tr("Worst draft")), goalReading(u"below"_s, Words::tr("Area below")),
          goalReading(u"crossing"_s, Words::tr("Self-intersections")),
          goalReading(u"curve"_s, Words::tr("Parting curve")), goalReading(u"proof"_s, Words::tr("Proved"))},
         {actions[u"build-mold"_s], actions[u"export-cast"_s], actions[u"restore"_s]},
         true});
    page.sections.push_back(
        {Words::tr("Kept from the part"),
         {goalReading(u"distance"_s, Words::tr("Mean distance"),
                      Words::tr("Over the part's diagonal, after the best rigid fit.")),
          goalReading(u"volume"_s, Words::tr("Volume")),
          goalReading(u"filled"_s, Words::tr("Filled"),
                      Words::tr("What was filled in where no bending helps, over the part's volume.")),
          goalReading(u"limb"_s, Words::tr("Shortest limb"), Words::tr("Length, cast over part."))},
         {},
         false});
    return page;
}

} // namespace

PropertyPage propertyPage(const QString& selected, const Workbench& bench, const Actions& actions) {
    if (bench.refused())
        return refusedPage(selected, *bench.refused(), actions);
    if (selected == u"plane"_s)
        return planePage(bench, actions);
    if (selected.startsWith(u"direction"_s) && bench.project().state)
        return directionPage(selected.back().digitValue(), bench, actions);
    if (const int number = obstructionNumber(selected);
        number >= 0 && number < static_cast<int>(bench.obstructions().size()))
        return obstructionPage(number, bench, actions);
    if (selected.startsWith(u"undercut"_s))
        return undercutPage(undercutNumber(selected), bench, actions);
    if (pinsChosen(selected))
        return pinPage(selected, bench, actions);
    if (variantsChosen(selected))
        return variantPage(bench, actions);
    if (regionsChosen(selected))
        return regionPage(selected, bench, actions);
    if (selected == u"deform"_s)
        return deformPage(bench, actions);
    if (selected == u"cast"_s)
        return castPage(bench, actions);
    if (severalChosen(selected))
        return featuresPage(selected, actions);
    if (featureOf(selected))
        return featurePage(selected, bench, actions);
    if (trayNumber(selected) >= 0)
        return trayPage(trayNumber(selected), bench, actions);
    if (selected == u"mold"_s || selected.startsWith(u"half"_s))
        return moldPage(bench, actions);
    return partPage(bench, actions);
}

} // namespace moldwright
