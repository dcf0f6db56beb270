// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/face_paint.h"

#include "mesh/measures.h"
#include "theme/theme.h"
#include "window/presentation.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(FacePaint)
};

void addLine(scene::PanelContent& legend, scene::Rgb colour, const QString& words, double areaMm2) {
    legend.lines.push_back(
        {colour, {{words.toStdString()}}, u"%1 cm²"_s.arg(areaMm2 / 100, 0, 'f', 1).toStdString()});
}

void addNote(scene::PanelContent& legend, const QString& words) {
    legend.lines.push_back({std::nullopt, {{words.toStdString(), scene::Ink::Secondary}}, {}});
}

std::vector<scene::Rgb> byDraft(std::size_t faces, const DraftAnalysis* analysis, double required,
                                DisplayMode mode) {
    const scene::SceneColours& colours = theme().scene;
    std::vector<scene::Rgb> painted(faces, colours.part);
    if (!analysis || mode == DisplayMode::Plain)
        return painted;
    for (std::size_t f = 0; f < faces && f < analysis->violating.size(); ++f)
        if (mode == DisplayMode::DraftMap)
            painted[f] = scene::draftClassColours()[scene::draftClass(analysis->faceDraft[f], required)];
        else if (analysis->violating[f])
            painted[f] = colours.undercut;
    return painted;
}

std::vector<scene::Rgb> byValue(const std::vector<double>& values, const FaceMap& map) {
    const bool zeroIsFree = map.request.mode == DisplayMode::UndercutDepth;
    std::vector<scene::Rgb> painted(values.size());
    std::ranges::transform(values, painted.begin(), [&](double value) {
        return zeroIsFree && value == 0 ? theme().scene.part : map.scale.colourOf(value);
    });
    return painted;
}

scene::PanelContent undercutLegend(const DraftAnalysis& analysis, double allMm2, double required) {
    scene::PanelContent legend;
    legend.title = Words::tr("Undercuts").toStdString();
    addLine(legend, theme().scene.undercut, Words::tr("Draft below %1").arg(angleText(required)),
            analysis.violatingArea);
    addLine(legend, theme().scene.part, Words::tr("Draft %1 or more").arg(angleText(required)),
            allMm2 - analysis.violatingArea);
    return legend;
}

scene::PanelContent draftLegend(const DraftAnalysis& analysis, const IndexedMesh& mesh, double required) {
    std::array<double, 7> areas{};
    for (int f = 0; f < mesh.faceCount(); ++f)
        areas[scene::draftClass(analysis.faceDraft[f], required)] += doubleAreaVector(mesh, f).norm() / 2;
    scene::PanelContent legend;
    legend.title = Words::tr("Draft").toStdString();
    const QString third = angleText(std::max(3.0, required), 0);
    const QString tenth = angleText(std::max(10.0, required), 0);
    const std::array<QString, 7> words = {Words::tr("below %1").arg(angleText(-15, 0)),
                                          Words::tr("%1 to %2").arg(angleText(-15, 0), angleText(-5, 0)),
                                          Words::tr("%1 to %2").arg(angleText(-5, 0), angleText(0, 0)),
                                          Words::tr("%1 to %2").arg(angleText(0, 0), angleText(required)),
                                          Words::tr("%1 to %2").arg(angleText(required), third),
                                          Words::tr("%1 to %2").arg(third, tenth),
                                          Words::tr("above %1").arg(tenth)};
    for (int c = 6; c >= 0; --c)
        addLine(legend, scene::draftClassColours()[c], words[c], areas[c]);
    return legend;
}

/// A value of a map without its unit; strain is shown in percent.
QString valueText(double value, const scene::ValueScale& scale, DisplayMode mode) {
    const double shown = mode == DisplayMode::Strain ? 100 : 1;
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(shown * scale.step) + 1e-9)));
    return QString::number(shown * value, 'f', decimals);
}

QString unitOf(DisplayMode mode) {
    return mode == DisplayMode::Strain ? u"%"_s : u"mm"_s;
}

QString noteOf(DisplayMode mode) {
    return mode == DisplayMode::Deviation    ? Words::tr("mm, after best fit")
           : mode == DisplayMode::Difference ? Words::tr("mm between both casts")
           : mode == DisplayMode::Strain     ? Words::tr("%, both stretches together")
                                             : Words::tr("mm along the removal direction");
}

QString titleOf(DisplayMode mode) {
    return displayModeNames().at(static_cast<qsizetype>(mode));
}

scene::PanelContent mapLegend(const FaceMap& map) {
    const DisplayMode mode = map.request.mode;
    scene::PanelContent legend;
    legend.title = titleOf(mode).toStdString();
    addNote(legend, noteOf(mode));
    const auto text = [&](int c) { return valueText(c * map.scale.step, map.scale, mode); };
    const auto withUnit = [&](int c) { return text(c) + u' ' + unitOf(mode); };
    constexpr int last = scene::ValueScale::classes - 1;
    addLine(legend, scene::valueColours()[last], Words::tr("%1 or more").arg(withUnit(last)),
            map.areas[last]);
    for (int c = last - 1; c >= 0; --c)
        addLine(legend, scene::valueColours()[c], Words::tr("%1 to %2").arg(text(c), withUnit(c + 1)),
                map.areas[c]);
    if (mode == DisplayMode::UndercutDepth)
        addLine(legend, theme().scene.part, Words::tr("No undercut"), map.freeArea);
    return legend;
}

/// Why a map is not shown.
scene::PanelContent missingMap(const Workbench& bench, const ShownSurface& surface, DisplayMode mode) {
    scene::PanelContent legend;
    legend.title = titleOf(mode).toStdString();
    const auto& cast = surface.variant->cast;
    const Variant* other = bench.variants().other();
    if (bench.running())
        addNote(legend, Words::tr("Shown once the run has ended."));
    else if (!needsCast(mode))
        addNote(legend, bench.shownState() ? Words::tr("Measuring") : Words::tr("Needs a parting plane."));
    else if (mode == DisplayMode::Difference && !other)
        addNote(legend, Words::tr("Needs another variant: Compare shows one."));
    else if (mode == DisplayMode::Difference && !(other->cast && bench.project().cast))
        addNote(legend, Words::tr("Needs a cast in both variants."));
    else if (!cast)
        addNote(legend, Words::tr("Needs a cast: Run makes one."));
    else if (mode != DisplayMode::Difference && cast->before.rows() == 0)
        addNote(legend, Words::tr("The file is of an older version: run again."));
    else if (mode == DisplayMode::Strain && surface.drawn->mesh != cast->mesh)
        addNote(legend, Words::tr("Shown on the cast only."));
    else
        addNote(legend, Words::tr("Measuring"));
    return legend;
}

} // namespace

FacePaint paintFor(const ShownSurface& surface, DisplayMode mode, const FaceMap* map) {
    FacePaint paint;
    if (map) {
        paint.faces = byValue(map->values, *map);
        paint.standIn = byValue(map->standInValues, *map);
        return paint;
    }
    const bool byOthers = isMap(mode) || mode == DisplayMode::Steel;
    const DisplayMode shown = byOthers ? DisplayMode::Plain : mode;
    const double required = surface.variant->design.draftDegrees;
    if (!surface.coarse)
        paint.faces = byDraft(surface.drawn->mesh->F.rows(), surface.analysis, required, shown);
    if (surface.drawn->standIn)
        paint.standIn = byDraft(surface.drawn->standIn->mesh->F.rows(),
                                surface.coarse ? surface.analysis : surface.standInAnalysis, required, shown);
    return paint;
}

namespace {

void accentuate(std::vector<scene::Rgb>& painted, const IndexedMesh& mesh, const Eigen::AlignedBox3d& place) {
    for (int f = 0; f < static_cast<int>(painted.size()) && f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (place.contains(mesh.corner(f, k)))
                painted[static_cast<std::size_t>(f)] = theme().scene.accent;
}

} // namespace

void pointAt(FacePaint& paint, const ShownSurface& surface, const Eigen::AlignedBox3d& place) {
    accentuate(paint.faces, *surface.drawn->mesh, place);
    if (surface.drawn->standIn)
        accentuate(paint.standIn, *surface.drawn->standIn->mesh, place);
}

scene::PanelContent legendFor(const Workbench& bench, const ShownSurface& surface, DisplayMode mode,
                              const FaceMap* map) {
    if (map)
        return mapLegend(*map);
    if (!surface.drawn || mode == DisplayMode::Plain)
        return {};
    if (isMap(mode))
        return missingMap(bench, surface, mode);
    if (!surface.analysis)
        return {};
    const double required = surface.variant->design.draftDegrees;
    return mode == DisplayMode::Undercuts
               ? undercutLegend(*surface.analysis, bench.figures(surface.drawn->mesh).area, required)
               : draftLegend(*surface.analysis, *surface.analysed(), required);
}

scene::PanelContent contactLegend(const std::array<ContactWays, 2>& contacts) {
    scene::PanelContent legend;
    if (!contacts[0].any() && !contacts[1].any())
        return legend;
    legend.title = Words::tr("Contact").toStdString();
    legend.lines.push_back(
        {theme().scene.undercut, {{Words::tr("A half meets the cast").toStdString()}}, {}});
    return legend;
}

QString mapValueText(const FaceMap& map, double value) {
    const DisplayMode mode = map.request.mode;
    const scene::ValueScale finer{map.scale.step / 10};
    return u"%1 %2 %3"_s.arg(titleOf(mode), valueText(value, finer, mode), unitOf(mode));
}

std::optional<scene::Chip> largestOf(const FaceMap& map) {
    if (!(map.largest > 0))
        return std::nullopt;
    const DisplayMode mode = map.request.mode;
    const scene::ValueScale finer{map.scale.step / 10};
    const QString value = valueText(map.largest, finer, mode) + u' ' + unitOf(mode);
    return scene::Chip{
        map.largestPlace,
        {{}, {{std::nullopt, {{Words::tr("Largest").toStdString()}, {value.toStdString(), {}, true}}, {}}}}};
}

} // namespace moldwright
