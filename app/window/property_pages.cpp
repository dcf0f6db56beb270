// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/property_pages.h"

#include "mesh/measures.h"
#include "project/edits.h"
#include "project/placing.h"
#include "scene/plane_handle.h"
#include "window/action_table.h"
#include "window/presentation.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <cmath>

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

PropertyPage partPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{
        u"part"_s, u"part"_s, QString::fromStdString(bench.project().name), Words::tr("Part"), {}};
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
         {actions[u"turn-x"_s], actions[u"turn-y"_s], actions[u"turn-z"_s], actions[u"lay-flat"_s],
          actions[u"centre"_s]},
         false});
    page.sections.push_back(
        {Words::tr("Measured"),
         {reading(u"extent"_s, Words::tr("Size, mm")), reading(u"volume"_s, Words::tr("Volume")),
          reading(u"area"_s, Words::tr("Surface")), reading(u"faces"_s, Words::tr("Faces"))},
         {},
         false});
    return page;
}

PropertyPage planePage(const Workbench&, const Actions& actions) {
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
    page.sections.push_back(
        {Words::tr("Directions"),
         {Property{u"choice"_s, Words::tr("While it runs"),
                   Words::tr("How the removal directions are chosen when the part is deformed."),
                   ChoiceProperty{{Words::tr("Best for the plane"), Words::tr("Along the normal"),
                                   Words::tr("As they are")}}},
          number(u"tilt"_s, Words::tr("Tilt limit"),
                 Words::tr("How far a direction may lean from the plane's normal."),
                 {u"°"_s, 0, 60, 1, 0, true})},
         {actions[u"best-directions"_s], actions[u"normal-directions"_s]},
         false});
    page.sections.push_back(
        {Words::tr("Measured"),
         {goalReading(u"worst"_s, Words::tr("Worst draft")), goalReading(u"below"_s, Words::tr("Area below")),
          goalReading(u"tilt1"_s, Words::tr("Direction 1"), Words::tr("Angle to the plane's normal.")),
          goalReading(u"tilt2"_s, Words::tr("Direction 2"), Words::tr("Angle to the plane's normal."))},
         {},
         false});
    return page;
}

PropertyPage deformPage(const Workbench&, const Actions& actions) {
    PropertyPage page{u"deform"_s,
                      u"deform"_s,
                      Words::tr("Deform"),
                      Words::tr("Bends the part until both halves come off."),
                      {}};
    PropertySection goal = draftGoal();
    goal.rows.push_back({u"method"_s, Words::tr("Method"), Words::tr("How the shape is bent."),
                         ChoiceProperty{{Words::tr("Elastic, then finish"), Words::tr("As in the paper")}}});
    page.sections.push_back(goal);
    page.sections.push_back(
        {Words::tr("While it runs"),
         {Property{u"choice"_s, Words::tr("Directions"), Words::tr("How the removal directions are chosen."),
                   ChoiceProperty{{Words::tr("Best for the plane"), Words::tr("Along the normal"),
                                   Words::tr("As they are")}}},
          number(u"tilt"_s, Words::tr("Tilt limit"),
                 Words::tr("How far a direction may lean from the plane's normal."),
                 {u"°"_s, 0, 60, 1, 0, true})},
         {actions[u"run"_s], actions[u"stop"_s], actions[u"restore"_s]},
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

PropertyPage moldPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{u"mold"_s, u"mold"_s, Words::tr("Mold"), Words::tr("Two halves around the cast."), {}};
    const NumberProperty wall{u"mm"_s, 1, 100, 0.5, 1, true};
    NumberProperty steel = wall;
    steel.maximum = 25;
    page.sections.push_back({Words::tr("Block"),
                             {number(u"wall"_s, Words::tr("Wall"),
                                     Words::tr("Steel between the cavity and each side face."), steel),
                              number(u"ceiling"_s, Words::tr("Over half 1"),
                                     Words::tr("Steel over the cavity of half 1."), steel),
                              number(u"floor"_s, Words::tr("Under half 2"),
                                     Words::tr("Steel under the cavity of half 2."), steel)},
                             bench.moldIsCurrent()
                                 ? std::vector<QAction*>{actions[u"export-mold"_s], actions[u"build-mold"_s],
                                                         actions[u"open-mold"_s]}
                                 : std::vector<QAction*>{actions[u"build-mold"_s]},
                             true});
    page.sections.push_back(
        {Words::tr("Measured"),
         {reading(u"half1"_s, Words::tr("Half 1, mm")), reading(u"half2"_s, Words::tr("Half 2, mm")),
          reading(u"cavity"_s, Words::tr("Cavity")), reading(u"halves"_s, Words::tr("Both halves")),
          reading(u"steel"_s, Words::tr("Smallest steel")), reading(u"proof"_s, Words::tr("Comes off"))},
         {},
         false});
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
          goalReading(u"limb"_s, Words::tr("Shortest limb"), Words::tr("Length, cast over part."))},
         {},
         false});
    return page;
}

QStringList measured(const QString& value, const QString& goal = {}) {
    return {value, goal};
}

void fillMeasures(PropertyPanel& panel, const Workbench& bench) {
    const Project& project = bench.project();
    const SharedMesh mesh = bench.shownMesh();
    const DraftAnalysis* analysis = bench.shownAnalysis();
    const double required = project.design.draftDegrees;
    if (analysis) {
        panel.setValue(u"worst"_s,
                       measured(draftText(analysis->worstDraftDegrees), u"≥ "_s + angleText(required)));
        panel.setMissesGoal(u"worst"_s, analysis->violatingArea > 0);
        panel.setValue(u"below"_s,
                       measured(u"%1 cm²"_s.arg(analysis->violatingArea / 100, 0, 'f', 1), u"0"_s));
        panel.setMissesGoal(u"below"_s, analysis->violatingArea > 0);
        panel.setValue(u"energy"_s, measured(QString::number(analysis->energy, 'g', 3), u"0"_s));
    }
    const double partVolume = volume(*project.part);
    const bool partPageShown = panel.pageId() == u"part"_s;
    panel.setValue(u"volume"_s, measured(partPageShown ? u"%1 cm³"_s.arg(partVolume / 1000, 0, 'f', 1)
                                                       : percentText(volume(*mesh) / partVolume)));
    const Eigen::Vector3d size = boundingBox(*project.part).sizes();
    panel.setValue(
        u"extent"_s,
        measured(
            u"%1 × %2 × %3"_s.arg(size.x(), 0, 'f', 1).arg(size.y(), 0, 'f', 1).arg(size.z(), 0, 'f', 1)));
    panel.setValue(u"area"_s, measured(u"%1 cm²"_s.arg(surfaceArea(*project.part) / 100, 0, 'f', 1)));
    panel.setValue(u"faces"_s, measured(QString::number(project.part->faceCount())));
    const bool cast = bench.castShown();
    panel.setValue(
        u"distance"_s,
        measured(cast ? u"%1 %"_s.arg(100 * project.cast->change.meanDistance, 0, 'f', 2) : u"–"_s));
    double shortest = 2;
    for (const LimbMeasure& limb : cast ? project.cast->limbs : std::vector<LimbMeasure>())
        shortest = std::min(shortest, limb.lengthRatio);
    panel.setValue(u"limb"_s, measured(shortest < 2 ? percentText(shortest) : Words::tr("no limbs"),
                                       shortest < 2 ? u"≥ 85 %"_s : QString()));
}

void fillProof(PropertyPanel& panel, const Workbench& bench) {
    if (panel.pageId() != u"cast"_s)
        return;
    const bool known = bench.castShown() && bench.analysisIsCurrent() && bench.analysis()->certificate;
    const QString unknown = u"–"_s;
    if (!known) {
        for (const QString& id : {u"crossing"_s, u"curve"_s, u"proof"_s})
            panel.setValue(id, measured(unknown));
        return;
    }
    const Certificate& proof = *bench.analysis()->certificate;
    panel.setValue(u"worst"_s, measured(draftText(proof.worstDraftDegrees),
                                        u"≥ "_s + angleText(bench.project().design.draftDegrees)));
    panel.setValue(
        u"crossing"_s,
        measured(proof.selfIntersectionFree ? Words::tr("none") : Words::tr("found"), Words::tr("none")));
    panel.setMissesGoal(u"crossing"_s, !proof.selfIntersectionFree);
    panel.setValue(u"curve"_s,
                   measured(proof.curvesSimpleAndNested && proof.curvesOnPlane ? Words::tr("simple")
                                                                               : Words::tr("crosses itself"),
                            Words::tr("simple")));
    panel.setMissesGoal(u"curve"_s, !(proof.curvesSimpleAndNested && proof.curvesOnPlane));
    panel.setValue(u"proof"_s, measured(proof.holds() ? Words::tr("yes") : Words::tr("no")));
    panel.setMissesGoal(u"proof"_s, !proof.holds());
}

void fillMold(PropertyPanel& panel, const Workbench& bench) {
    if (panel.pageId() != u"mold"_s)
        return;
    const MoldSettings& settings = bench.project().mold;
    panel.setValue(u"wall"_s, settings.wall);
    panel.setValue(u"ceiling"_s, settings.ceiling);
    panel.setValue(u"floor"_s, settings.floor);
    if (!bench.mold())
        return;
    const Mold& mold = *bench.mold();
    const auto size = [](const Eigen::Vector3d& s) {
        return u"%1 × %2 × %3"_s.arg(s.x(), 0, 'f', 1).arg(s.y(), 0, 'f', 1).arg(s.z(), 0, 'f', 1);
    };
    panel.setValue(u"half1"_s, measured(size(mold.half1.size)));
    panel.setValue(u"half2"_s, measured(size(mold.half2.size)));
    panel.setValue(u"cavity"_s, measured(u"%1 cm³"_s.arg(mold.cavityVolume / 1000, 0, 'f', 1)));
    panel.setValue(u"halves"_s,
                   measured(u"%1 cm³"_s.arg((mold.half1.volume + mold.half2.volume) / 1000, 0, 'f', 0)));
    panel.setValue(u"steel"_s, measured(u"%1 mm"_s.arg(mold.minWall, 0, 'f', 2)));
    panel.setValue(u"proof"_s, measured(!bench.moldIsCurrent() ? Words::tr("out of date")
                                        : mold.verified()      ? Words::tr("proved")
                                                               : Words::tr("no")));
    panel.setMissesGoal(u"proof"_s, !mold.verified());
}

Placement scaledTo(const Project& project, double longest) {
    const double now = boundingBox(*project.part).sizes().maxCoeff();
    Placement placement = project.placement;
    placement.scale *= longest / now;
    return placement;
}

Placement placedAt(const Project& project, int axis, double middle) {
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    way[axis] = middle - boundingBox(*project.part).center()[axis];
    return moved(project.placement, Eigen::Isometry3d(Eigen::Translation3d(way)));
}

DirectionsChoice choiceAt(int index) {
    return index == 1   ? DirectionsChoice::Normal
           : index == 2 ? DirectionsChoice::Given
                        : DirectionsChoice::Automatic;
}

struct Edit {
    QString words;
    Project after;
};

std::optional<Edit> editFor(const Project& project, const QString& id, const QVariant& value) {
    const double number = value.toDouble();
    DesignSettings design = project.design;
    MoldSettings mold = project.mold;
    if (id == u"size"_s)
        return Edit{Words::tr("Scale the part"), withPlacement(project, scaledTo(project, number))};
    for (int axis = 0; axis < 3; ++axis)
        if (id == QString(QChar(u'x' + axis)))
            return Edit{Words::tr("Move the part"), withPlacement(project, placedAt(project, axis, number))};
    if (id == u"offset"_s && project.state) {
        PartingPlane plane = project.state->plane;
        plane.offset = number;
        return Edit{Words::tr("Move the plane"),
                    withState(project, scene::withPlane(*project.state, plane), true)};
    }
    if (id == u"draft"_s)
        design.draftDegrees = number;
    else if (id == u"tilt"_s)
        design.maxTiltDegrees = number;
    else if (id == u"choice"_s)
        design.directionsChoice = choiceAt(value.toInt());
    else if (id == u"method"_s)
        design.method = value.toInt() == 1 ? DeformationMethod::Paper : DeformationMethod::Default;
    else if (id == u"wall"_s)
        mold.wall = number;
    else if (id == u"ceiling"_s)
        mold.ceiling = number;
    else if (id == u"floor"_s)
        mold.floor = number;
    if (!(design == project.design))
        return Edit{Words::tr("Change the deformation's settings"), withDesignSettings(project, design)};
    if (!(mold == project.mold))
        return Edit{Words::tr("Change the block"), withMoldSettings(project, mold)};
    return std::nullopt;
}

} // namespace

PropertyPage propertyPage(const QString& selected, const Workbench& bench, const Actions& actions) {
    if (selected == u"plane"_s || selected.startsWith(u"direction"_s))
        return planePage(bench, actions);
    if (selected == u"deform"_s)
        return deformPage(bench, actions);
    if (selected == u"cast"_s)
        return castPage(bench, actions);
    if (selected == u"mold"_s || selected.startsWith(u"half"_s))
        return moldPage(bench, actions);
    return partPage(bench, actions);
}

void fillPage(PropertyPanel& panel, const Workbench& bench) {
    const Project& project = bench.project();
    if (!project.part)
        return;
    const Eigen::AlignedBox3d box = boundingBox(*project.part);
    panel.setValue(u"size"_s, box.sizes().maxCoeff());
    panel.setValue(u"x"_s, box.center().x());
    panel.setValue(u"y"_s, box.center().y());
    panel.setValue(u"z"_s, box.center().z());
    panel.setValue(u"draft"_s, project.design.draftDegrees);
    panel.setValue(u"tilt"_s, project.design.maxTiltDegrees);
    panel.setValue(u"method"_s, project.design.method == DeformationMethod::Paper ? 1 : 0);
    panel.setValue(u"choice"_s, project.design.directionsChoice == DirectionsChoice::Normal  ? 1
                                : project.design.directionsChoice == DirectionsChoice::Given ? 2
                                                                                             : 0);
    if (const auto state = bench.shownState()) {
        panel.setValue(u"offset"_s, state->plane.offset);
        panel.setValue(u"tilt1"_s, measured(angleText(tiltDegrees(*state, 1)),
                                            u"≤ "_s + angleText(project.design.maxTiltDegrees, 0)));
        panel.setValue(u"tilt2"_s, measured(angleText(tiltDegrees(*state, 2)),
                                            u"≤ "_s + angleText(project.design.maxTiltDegrees, 0)));
    }
    fillMeasures(panel, bench);
    fillProof(panel, bench);
    fillMold(panel, bench);
}

void applyProperty(Workbench& bench, const QString& id, const QVariant& value, bool preview) {
    const auto edit = editFor(bench.document().committed(), id, value);
    if (!edit)
        bench.document().endPreview();
    else if (preview)
        bench.document().preview(edit->after);
    else
        bench.document().edit(edit->words, edit->after, u"property-"_s + id);
}

} // namespace moldwright
