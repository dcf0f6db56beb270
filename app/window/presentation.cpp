// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/presentation.h"

#include "mesh/measures.h"
#include "project/edits.h"
#include "project/variants.h"
#include "theme/theme.h"
#include "window/importance_pages.h"
#include "window/mold_feature_pages.h"
#include "window/obstruction_words.h"
#include "window/pin_pages.h"
#include "window/refusal_pages.h"
#include "window/row_id.h"
#include "window/tray_pages.h"
#include "window/undercut_pages.h"
#include "window/variant_pages.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Presentation)
};

QString lengthText(double mm) {
    return u"%1 mm"_s.arg(mm, 0, 'f', 1);
}

QString sizeText(const Eigen::Vector3d& size) {
    return u"%1 × %2 × %3"_s.arg(size.x(), 0, 'f', 0).arg(size.y(), 0, 'f', 0).arg(size.z(), 0, 'f', 0);
}

StepState guidesState(const Workbench& bench) {
    const auto pins = bench.project().pins.size();
    const auto regions = bench.project().importance.size();
    QStringList words;
    if (pins > 0)
        words << (pins == 1 ? Words::tr("1 pin") : Words::tr("%1 pins").arg(pins));
    if (regions > 0)
        words << (regions == 1 ? Words::tr("1 region") : Words::tr("%1 regions").arg(regions));
    if (words.isEmpty())
        return {Standing::Todo, Words::tr("None")};
    return {Standing::Done, words.join(u", "_s)};
}

StepState planeState(const Workbench& bench) {
    const Project& project = bench.project();
    if (!project.planeChosenByHand)
        return project.cast ? StepState{Standing::Done, Words::tr("Found by the run")}
                            : StepState{Standing::Todo, Words::tr("Not chosen yet")};
    if (const int taken = bench.offeredPlane(); taken >= 0)
        return {Standing::Done,
                Words::tr("Number %1 of %2").arg(taken + 1).arg(bench.offeredPlanes().size())};
    return {Standing::Done, Words::tr("Chosen")};
}

StepState deformState(const Workbench& bench) {
    if (bench.running()) {
        const auto& frame = bench.frame();
        if (bench.resting())
            return {Standing::Running, Words::tr("Paused")};
        return {Standing::Running,
                frame ? Words::tr("Running, step %1").arg(frame->frame.step) : Words::tr("Running")};
    }
    if (bench.frame())
        return {Standing::Info, Words::tr("Step %1 in view").arg(bench.frame()->frame.step)};
    if (!bench.obstructions().empty())
        return bench.obstructionsLeft() > 0 ? StepState{Standing::Failing, Words::tr("Obstructed")}
                                            : StepState{Standing::Todo, Words::tr("Ready to run")};
    if (!bench.project().cast)
        return {Standing::Todo, Words::tr("Not started")};
    if (bench.analysisIsCurrent() && !bench.castIsProved())
        return {Standing::Warning, Words::tr("Not castable yet")};
    return bench.castShown() ? StepState{Standing::Done, Words::tr("Done")}
                             : StepState{Standing::Stale, Words::tr("Out of date")};
}

StepState checkState(const Workbench& bench) {
    if (!bench.project().cast)
        return {Standing::Todo, Words::tr("Waits for Deform")};
    if (!bench.analysisIsCurrent() || !bench.analysis()->certificate)
        return {Standing::Running, Words::tr("Checking")};
    if (bench.castIsProved())
        return {Standing::Done,
                Words::tr("Proved at %1").arg(draftText(bench.analysis()->certificate->worstDraftDegrees))};
    return {Standing::Failing, Words::tr("Not proved")};
}

StepState moldState(const Workbench& bench) {
    if (!bench.mold())
        return {Standing::Todo, Words::tr("Not started")};
    if (!bench.moldIsCurrent())
        return {Standing::Stale, Words::tr("Out of date")};
    return bench.mold()->verified() ? StepState{Standing::Done, Words::tr("Proved")}
                                    : StepState{Standing::Failing, Words::tr("Not proved")};
}

QString planeTilt(const MoldState& state) {
    const double angle = degrees(std::acos(std::clamp(std::abs(state.plane.normal.z()), 0.0, 1.0)));
    return Words::tr("%1 to level").arg(angleText(angle));
}

void addPartRows(std::vector<ProjectRow>& rows, const Workbench& bench, const Visibility& visible) {
    const Project& project = bench.project();
    const double longest = bench.figures(project.part).box.sizes().maxCoeff();
    rows.push_back({.id = u"part"_s,
                    .iconName = u"part"_s,
                    .name = QString::fromStdString(project.name),
                    .value = lengthText(longest),
                    .visible = visible.shape,
                    .strong = true,
                    .renamable = true});
    rows.push_back({.id = u"surface"_s,
                    .parent = 0,
                    .iconName = u"edges"_s,
                    .name = Words::tr("Surface"),
                    .value = Words::tr("%1 faces").arg(project.part->faceCount())});
}

QColor sideColour(int side) {
    return toColor(side == 1 ? theme().scene.side1 : theme().scene.side2);
}

void addPlaneRows(std::vector<ProjectRow>& rows, const Workbench& bench, const Visibility& visible) {
    const MoldState& state = *bench.project().state;
    rows.push_back({.id = u"plane"_s,
                    .iconName = u"plane"_s,
                    .name = Words::tr("Parting plane"),
                    .value = planeTilt(state),
                    .visible = visible.plane,
                    .strong = true});
    const int plane = static_cast<int>(rows.size()) - 1;
    for (const int side : {1, 2})
        rows.push_back({.id = u"direction-%1"_s.arg(side),
                        .parent = plane,
                        .iconName = u"direction"_s,
                        .tint = sideColour(side),
                        .name = Words::tr("Direction %1").arg(side),
                        .value = angleText(tiltDegrees(state, side)),
                        .visible = visible.directions});
}

void addDeformRows(std::vector<ProjectRow>& rows, const Workbench& bench) {
    const StepState deform = deformState(bench);
    rows.push_back({.id = u"deform"_s,
                    .iconName = u"deform"_s,
                    .name = Words::tr("Deform"),
                    .value = deform.words,
                    .strong = true,
                    .stale = deform.standing == Standing::Stale});
    const int parent = static_cast<int>(rows.size()) - 1;
    for (int i = 0; i < static_cast<int>(bench.obstructions().size()); ++i) {
        const bool filled = bench.willBeFilled(i);
        const Obstruction& obstruction = bench.obstructions()[static_cast<std::size_t>(i)];
        rows.push_back({.id = obstructionId(i),
                        .parent = parent,
                        .iconName = filled ? u"cavity"_s : u"error"_s,
                        .tint = filled ? std::nullopt : std::optional(theme().error),
                        .name = kindName(obstruction.kind),
                        .value = filled ? Words::tr("will be filled") : sizeText(obstruction)});
    }
    addUndercutRows(rows, parent, bench);
    if (bench.project().cast)
        rows.push_back({
            .id = u"cast"_s,
            .parent = parent,
            .iconName = u"result"_s,
            .name = Words::tr("Cast"),
            .value = bench.castIsProved() ? draftText(bench.analysis()->certificate->worstDraftDegrees)
                                          : checkState(bench).words,
        });
}

void addMoldRows(std::vector<ProjectRow>& rows, const Workbench& bench, const Visibility& visible) {
    const StepState mold = moldState(bench);
    ProjectRow moldRow{.id = u"mold"_s,
                       .iconName = u"mold"_s,
                       .name = Words::tr("Mold"),
                       .value = mold.words,
                       .strong = true,
                       .stale = mold.standing == Standing::Stale};
    if (bench.moldIsCurrent())
        moldRow.visible = visible.mold;
    rows.push_back(moldRow);
    const int parent = static_cast<int>(rows.size()) - 1;
    addTrayRows(rows, parent, bench);
    addFeatureRows(rows, parent, bench);
    if (!bench.mold())
        return;
    for (const int side : {1, 2})
        rows.push_back({.id = u"half-%1"_s.arg(side),
                        .parent = parent,
                        .iconName = u"block"_s,
                        .tint = sideColour(side),
                        .name = Words::tr("Half %1").arg(side),
                        .value = sizeText((side == 1 ? bench.mold()->half1 : bench.mold()->half2).size),
                        .stale = !bench.moldIsCurrent()});
}

} // namespace

QString angleText(double degrees, int decimals) {
    return QString::number(degrees, 'f', decimals).replace(u'-', QChar(0x2212)) + u'°';
}

QString draftText(double degrees) {
    return angleText(std::floor(degrees * 10 + 1e-9) / 10);
}

QString percentText(double fraction) {
    return u"%1 %"_s.arg(100 * fraction, 0, 'f', 1);
}

QString weightText(double weight) {
    return u"×%1"_s.arg(weight, 0, 'g', 5);
}

double tiltDegrees(const MoldState& state, int side) {
    const double cosine = std::abs(state.directions.of(side).dot(state.plane.normal));
    return degrees(std::acos(std::min(1.0, cosine)));
}

std::array<StepState, stepCount> stepStates(const Workbench& bench) {
    if (bench.refused())
        return refusedStates(*bench.refused());
    std::array<StepState, stepCount> states;
    const Project& project = bench.project();
    if (!project.part)
        return states;
    const double longest = bench.figures(project.part).box.sizes().maxCoeff();
    states[int(Step::Part)] = {Standing::Done, Words::tr("%1, closed").arg(lengthText(longest))};
    states[int(Step::Plane)] = planeState(bench);
    states[int(Step::Guides)] = guidesState(bench);
    states[int(Step::Deform)] = deformState(bench);
    states[int(Step::Check)] = checkState(bench);
    states[int(Step::Mold)] = moldState(bench);
    states[int(Step::Report)] = {Standing::Todo,
                                 project.cast ? Words::tr("Ready to print") : Words::tr("Waits for Deform")};
    return states;
}

std::vector<ProjectRow> projectRows(const Workbench& bench, const Visibility& visible) {
    if (bench.refused())
        return refusedRows(*bench.refused());
    std::vector<ProjectRow> rows;
    if (!bench.project().part)
        return rows;
    addPartRows(rows, bench, visible);
    addVariantRows(rows, bench);
    if (bench.project().state)
        addPlaneRows(rows, bench, visible);
    addPinRows(rows, bench, visible);
    addRegionRows(rows, bench, visible);
    addDeformRows(rows, bench);
    addMoldRows(rows, bench, visible);
    return rows;
}

namespace {

/// The switch of a row that stands for all of its kind; null for any other.
bool* switchOf(Visibility& visible, const QString& id) {
    return id == u"part"_s                 ? &visible.shape
           : id == u"plane"_s              ? &visible.plane
           : id == u"mold"_s               ? &visible.mold
           : id == u"pins"_s               ? &visible.pins
           : id == u"suggested-pins"_s     ? &visible.suggestedPins
           : id == allRegionsId()          ? &visible.importance
           : id.startsWith(u"direction"_s) ? &visible.directions
                                           : nullptr;
}

} // namespace

void toggle(Visibility& visible, const QStringList& ids) {
    const auto isShown = [&](const QString& id) {
        const bool* shown = switchOf(visible, id);
        return shown ? *shown : visible.shows(id);
    };
    const bool hide = std::ranges::any_of(ids, isShown);
    for (const QString& id : ids)
        if (bool* shown = switchOf(visible, id))
            *shown = !hide;
        else if (hide)
            visible.hidden.insert(id);
        else
            visible.hidden.erase(id);
}

void forgetRow(Visibility& visible, const QString& id) {
    const QString kind = id.left(id.lastIndexOf(u'-') + 1);
    const int removed = numberAfter(kind, id);
    std::set<QString> hidden;
    for (const QString& row : visible.hidden) {
        const int number = numberAfter(kind, row);
        if (row != id)
            hidden.insert(number > removed ? kind + QString::number(number - 1) : row);
    }
    visible.hidden = std::move(hidden);
}

Verdict verdictOf(const Workbench& bench) {
    if (bench.refused())
        return refusedVerdict(*bench.refused());
    const Project& project = bench.project();
    if (!project.part)
        return {Standing::Info, Words::tr("No part open"), Words::tr("Open a mesh or a sample")};
    const QString required = angleText(project.design.draftDegrees);
    if (bench.castIsProved()) {
        const QString proved = draftText(bench.analysis()->certificate->worstDraftDegrees);
        if (bench.moldIsCurrent() && bench.mold()->verified())
            return {Standing::Done, Words::tr("Castable and opens"),
                    Words::tr("Cast and halves proved at %1 draft").arg(proved)};
        return {Standing::Done, Words::tr("Castable"),
                Words::tr("Proved at %1 draft, %2 required").arg(proved, required)};
    }
    if (const int count = bench.obstructionsLeft())
        return {Standing::Failing, Words::tr("Cannot be cast yet"),
                count == 1 ? Words::tr("One obstruction at this plane")
                           : Words::tr("%1 obstructions at this plane").arg(count)};
    const DraftAnalysis* analysis = bench.shownAnalysis();
    if (!analysis)
        return {Standing::Info, Words::tr("Not castable yet"), Words::tr("Measuring the draft")};
    if (analysis->violatingArea > 0)
        return {Standing::Failing, Words::tr("Not castable yet"),
                Words::tr("%1 of the surface below %2")
                    .arg(percentText(analysis->violatingAreaFraction), required)};
    return {Standing::Warning, Words::tr("Not castable yet"), Words::tr("No undercut seen; Run proves it")};
}

scene::PanelContent stateChipFor(const Workbench& bench, ViewContent content) {
    const Project& project = bench.project();
    const bool compared = content == ViewContent::Compared && !bench.refused();
    const Variant* other = compared ? bench.variants().other() : nullptr;
    QString words;
    if (bench.refused())
        words = Words::tr("As read");
    else if (other)
        words = other->cast ? Words::tr("Cast") : Words::tr("Part as opened");
    else if (content == ViewContent::Part)
        words = Words::tr("Part as opened");
    else if (bench.running())
        words = !bench.frame()    ? Words::tr("Starting")
                : bench.resting() ? Words::tr("Step %1, paused").arg(bench.frame()->frame.step)
                                  : Words::tr("Step %1, live").arg(bench.frame()->frame.step);
    else if (bench.frame())
        words = Words::tr("Step %1 of the last run").arg(bench.frame()->frame.step);
    else if (bench.castShown())
        words = Words::tr("Cast");
    else
        words = Words::tr("Part as opened");
    const bool oneOfSome = !bench.refused() && !project.others.empty();
    const std::string name = other ? other->variantName : oneOfSome ? project.variantName : "";
    std::vector<scene::PanelContent::Run> runs = {{words.toStdString()}};
    if (!name.empty())
        runs.insert(runs.begin(), {name, {}, true});
    return {{}, {{std::nullopt, std::move(runs), {}}}};
}

scene::PanelContent moldChip(const Workbench& bench) {
    const bool proved = bench.mold()->verified();
    return {{},
            {{std::nullopt, {{(proved ? Words::tr("Mold, proved") : Words::tr("Mold")).toStdString()}}, {}}}};
}

} // namespace moldwright
