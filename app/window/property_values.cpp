// SPDX-License-Identifier: AGPL-3.0-or-later
// What the rows of the property pages show, and what typing into them does.
#include "castability/crease.h"
#include "mesh/measures.h"
#include "panels/progress_plots.h"
#include "project/edits.h"
#include "project/placing.h"
#include "project/title.h"
#include "scene/direction_handle.h"
#include "scene/plane_handle.h"
#include "window/importance_pages.h"
#include "window/mold_feature_pages.h"
#include "window/mold_pages.h"
#include "window/obstruction_words.h"
#include "window/pin_pages.h"
#include "window/presentation.h"
#include "window/property_pages.h"
#include "window/refusal_pages.h"
#include "window/tray_pages.h"
#include "window/undercut_pages.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <map>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PropertyPages)
};

QString componentText(double value) {
    // Adding zero makes a plain zero of one that would be told as minus zero.
    return QString::number(std::round(value * 1000) / 1000 + 0.0, 'f', 3).replace(u'-', QChar(0x2212));
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
        panel.setValue(u"energy"_s, measured(scientificText(analysis->energy), u"0"_s));
    }
    const MeshFigures part = bench.figures(project.part);
    const bool partPageShown = panel.pageId() == u"part"_s;
    panel.setValue(u"volume"_s,
                   measured(partPageShown ? u"%1 cm³"_s.arg(part.volume / 1000, 0, 'f', 1)
                                          : percentText(bench.figures(mesh).volume / part.volume)));
    const Eigen::Vector3d size = part.box.sizes();
    panel.setValue(
        u"extent"_s,
        measured(
            u"%1 × %2 × %3"_s.arg(size.x(), 0, 'f', 1).arg(size.y(), 0, 'f', 1).arg(size.z(), 0, 'f', 1)));
    panel.setValue(u"area"_s, measured(u"%1 cm²"_s.arg(part.area / 100, 0, 'f', 1)));
    panel.setValue(u"faces"_s, measured(QString::number(project.part->faceCount())));
    const bool cast = bench.castShown();
    panel.setValue(
        u"distance"_s,
        measured(cast ? u"%1 %"_s.arg(100 * project.cast->change.meanDistance, 0, 'f', 2) : u"–"_s));
    panel.setValue(u"filled"_s,
                   measured(cast ? percentText(project.cast->change.filledVolumeFraction) : u"–"_s));
    double shortest = 2;
    for (const LimbMeasure& limb : cast ? project.cast->limbs : std::vector<LimbMeasure>())
        shortest = std::min(shortest, limb.lengthRatio);
    panel.setValue(u"limb"_s, measured(shortest < 2 ? percentText(shortest) : Words::tr("no limbs"),
                                       shortest < 2 ? u"≥ 85 %"_s : QString()));
}

void fillState(PropertyPanel& panel, const Workbench& bench) {
    const auto state = bench.shownState();
    if (!state)
        return;
    panel.setValue(u"offset"_s, state->plane.offset);
    panel.setValue(u"crease"_s, measured(angleText(sharpestCreaseDegrees(*state))));
    panel.setValue(u"offered"_s, bench.offeredPlane());
    const QString limit = u"≤ "_s + angleText(bench.project().design.limits.maxTiltDegrees, 0);
    for (const int side : {1, 2}) {
        const scene::Lean lean = scene::leanOf(*state, side);
        const Eigen::Vector3d& d = state->directions.of(side);
        panel.setValue(u"tilt%1"_s.arg(side), measured(angleText(lean.tiltDegrees), limit));
        panel.setValue(u"lean%1"_s.arg(side), lean.tiltDegrees);
        panel.setValue(u"way%1"_s.arg(side), lean.wayDegrees);
        panel.setValue(
            u"components%1"_s.arg(side),
            measured(u"%1  %2  %3"_s.arg(componentText(d.x()), componentText(d.y()), componentText(d.z()))));
    }
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

void fillObstruction(PropertyPanel& panel, const Workbench& bench) {
    const int number = obstructionNumber(panel.pageId());
    if (number < 0 || number >= static_cast<int>(bench.obstructions().size()))
        return;
    const Obstruction& obstruction = bench.obstructions()[static_cast<std::size_t>(number)];
    const Eigen::Vector3d& p = obstruction.place;
    panel.setValue(u"obstruction-place"_s, measured(u"%1  %2  %3"_s.arg(p.x(), 0, 'f', 1)
                                                        .arg(p.y(), 0, 'f', 1)
                                                        .arg(p.z(), 0, 'f', 1)
                                                        .replace(u'-', QChar(0x2212))));
    panel.setValue(u"obstruction-size"_s, measured(sizeText(obstruction)));
    panel.setValue(u"obstruction-side"_s, measured(QString::number(obstruction.side)));
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

/// The choices of the axis: none, X, Y, Z, direction 1.
int axisIndex(const DirectionLimits& limits) {
    if (!limits.axis)
        return 0;
    for (int k = 0; k < 3; ++k)
        if (limits.axis->cwiseAbs() == Eigen::Vector3d::Unit(k))
            return k + 1;
    return 4;
}

std::optional<Eigen::Vector3d> axisAt(int index, const Project& project) {
    if (index == 0 || (index == 4 && !project.state))
        return std::nullopt;
    return index == 4 ? project.state->directions.d1 : Eigen::Vector3d(Eigen::Vector3d::Unit(index - 1));
}

struct Edit {
    QString words;
    Project after;
};

Edit directionEdit(const Project& project, const QString& id, double degrees) {
    const int side = id.back().digitValue();
    scene::Lean lean = scene::leanOf(*project.state, side);
    (id.startsWith(u"lean"_s) ? lean.tiltDegrees : lean.wayDegrees) = degrees;
    const MoldState turned =
        scene::withDirection(*project.state, side, scene::leaning(project.state->plane, side, lean));
    return {Words::tr("Turn direction %1").arg(side), withDirections(project, turned.directions)};
}

std::optional<Edit> titleEdit(const Project& project, const QString& id, const QVariant& value) {
    PartTitle title = titleOf(project);
    const std::map<QString, std::string*> places = {{u"part-name"_s, &title.name},
                                                    {u"part-number"_s, &title.number},
                                                    {u"part-revision"_s, &title.revision}};
    const auto place = places.find(id);
    if (place == places.end())
        return std::nullopt;
    *place->second = value.toString().toStdString();
    return Edit{Words::tr("Change the title"), withTitle(project, title)};
}

std::optional<Edit> placementEdit(const Project& project, const QString& id, double number) {
    if (id == u"size"_s)
        return Edit{Words::tr("Scale the part"), withPlacement(project, scaledTo(project, number))};
    for (int axis = 0; axis < 3; ++axis)
        if (id == QString(QChar(u'x' + axis)))
            return Edit{Words::tr("Move the part"), withPlacement(project, placedAt(project, axis, number))};
    return std::nullopt;
}

/// Whether a value is of the plane or the directions.
bool isOfState(const QString& id) {
    return id == u"offset"_s || id.startsWith(u"lean"_s) || id.startsWith(u"way"_s);
}

Edit stateEdit(const Project& project, const QString& id, double number) {
    if (id != u"offset"_s)
        return directionEdit(project, id, number);
    PartingPlane plane = project.state->plane;
    plane.offset = number;
    return {Words::tr("Move the plane"), withState(project, scene::withPlane(*project.state, plane), true)};
}

DesignSettings withDesignValue(DesignSettings design, const Project& project, const QString& id,
                               const QVariant& value) {
    const double number = value.toDouble();
    if (id == u"draft"_s)
        design.draftDegrees = number;
    else if (id == u"tilt"_s)
        design.limits.maxTiltDegrees = number;
    else if (id == u"axis"_s)
        design.limits.axis = axisAt(value.toInt(), project);
    else if (id == u"cone"_s)
        design.limits.coneDegrees = number;
    else if (id == u"choice"_s)
        design.directionsChoice = choiceAt(value.toInt());
    else if (id == u"follow"_s)
        design.followDirections = value.toInt() == 1;
    else if (id == u"smoothing"_s)
        design.smoothing = number;
    else if (id == u"method"_s)
        design.method = value.toInt() == 1 ? DeformationMethod::Paper : DeformationMethod::Default;
    else if (id == u"fill"_s)
        design.fill = value.toInt() == 1 ? FillChoice::Auto : FillChoice::None;
    return design;
}

std::optional<Edit> editFor(const Project& project, const QString& id, const QVariant& value) {
    if (auto titled = titleEdit(project, id, value))
        return titled;
    if (auto placed = placementEdit(project, id, value.toDouble()))
        return placed;
    if (project.state && isOfState(id))
        return stateEdit(project, id, value.toDouble());
    if (const DesignSettings design = withDesignValue(project.design, project, id, value);
        design != project.design)
        return Edit{Words::tr("Change the deformation's settings"), withDesignSettings(project, design)};
    if (auto molded = withMoldValue(project, id, value))
        return Edit{Words::tr("Change the mold"), std::move(*molded)};
    return std::nullopt;
}

} // namespace

void fillPage(PropertyPanel& panel, const Workbench& bench) {
    if (bench.refused())
        return fillRefusedPage(panel, *bench.refused());
    const Project& project = bench.project();
    if (!project.part)
        return;
    const Eigen::AlignedBox3d box = bench.figures(project.part).box;
    panel.setValue(u"part-name"_s, QString::fromStdString(project.name));
    panel.setValue(u"part-number"_s, QString::fromStdString(project.number));
    panel.setValue(u"part-revision"_s, QString::fromStdString(project.revision));
    panel.setValue(u"size"_s, box.sizes().maxCoeff());
    panel.setValue(u"x"_s, box.center().x());
    panel.setValue(u"y"_s, box.center().y());
    panel.setValue(u"z"_s, box.center().z());
    panel.setValue(u"draft"_s, project.design.draftDegrees);
    panel.setValue(u"tilt"_s, project.design.limits.maxTiltDegrees);
    panel.setValue(u"axis"_s, axisIndex(project.design.limits));
    panel.setValue(u"cone"_s, project.design.limits.coneDegrees);
    panel.setValue(u"follow"_s, project.design.followDirections ? 1 : 0);
    panel.setValue(u"smoothing"_s, project.design.smoothing);
    panel.setValue(u"method"_s, project.design.method == DeformationMethod::Paper ? 1 : 0);
    panel.setValue(u"fill"_s, project.design.fill == FillChoice::Auto ? 1 : 0);
    panel.setValue(u"choice"_s, project.design.directionsChoice == DirectionsChoice::Normal  ? 1
                                : project.design.directionsChoice == DirectionsChoice::Given ? 2
                                                                                             : 0);
    fillState(panel, bench);
    fillMeasures(panel, bench);
    fillProof(panel, bench);
    fillMoldPage(panel, bench);
    fillTrayPage(panel, bench);
    fillFeaturePage(panel, bench);
    fillObstruction(panel, bench);
    fillUndercutPage(panel, bench);
    fillPinPage(panel, bench);
    fillRegionPage(panel, bench);
}

void applyProperty(Workbench& bench, const QString& page, const QString& id, const QVariant& value,
                   bool preview) {
    if (applyTreatment(bench, id, value.toInt()) ||
        applyFeatureValue(bench, id, page, value.toDouble(), preview) ||
        applyTrayValue(bench, id, value.toInt(), preview) ||
        applyPinValue(bench, id, page, value.toDouble(), preview) ||
        applyRegionValue(bench, id, page, value.toDouble(), preview))
        return;
    if (id == u"offered"_s) {
        if (!bench.background().busy())
            bench.takeOffered(value.toInt());
        return;
    }
    // Plane and directions are edited from where the run has them.
    const Project from = isOfState(id) ? bench.projectInView() : bench.document().committed();
    const auto edit = editFor(from, id, value);
    if (!edit)
        bench.document().endPreview();
    else if (preview)
        bench.document().preview(edit->after);
    else
        bench.document().edit(edit->words, edit->after, u"property-"_s + id);
}

} // namespace moldwright
