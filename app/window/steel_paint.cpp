// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/steel_paint.h"

#include "scene/value_scale.h"
#include "theme/theme.h"
#include "window/live_steel.h"

#include <QCoreApplication>

#include <algorithm>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SteelPaint)
};

QString millimetres(double value) {
    return u"%1 mm"_s.arg(value, 0, 'g', 3);
}

QString wordsOf(const SteelScale& scale, int c) {
    if (c == 0)
        return Words::tr("below %1, the least asked for").arg(millimetres(scale.limit));
    const QString from = millimetres(scale.from(c));
    if (c == SteelScale::classes - 1)
        return Words::tr("%1 or more").arg(from);
    return Words::tr("%1 to %2").arg(scale.from(c), 0, 'g', 3).arg(millimetres(scale.from(c + 1)));
}

} // namespace

std::vector<scene::Rgb> steelPaint(const SteelMap& map, const std::vector<double>& thickness, int side) {
    const scene::SceneColours& colours = theme().scene;
    const auto classes = scene::steelColours(colours.undercut);
    std::vector<scene::Rgb> painted;
    painted.reserve(thickness.size());
    for (const double steel : thickness)
        painted.push_back(steel < 0 ? (side == 1 ? colours.half1 : colours.half2)
                                    : classes.at(static_cast<std::size_t>(map.scale.classOf(steel))));
    return painted;
}

scene::PanelContent steelLegend(const ShownSteel* steel, bool shown) {
    scene::PanelContent legend;
    legend.title = Words::tr("Steel").toStdString();
    const auto note = [&](const QString& words) {
        legend.lines.push_back({std::nullopt, {{words.toStdString(), scene::Ink::Secondary}}, {}});
    };
    if (!steel) {
        note(shown ? Words::tr("Measuring")
                   : Words::tr("Shown on the halves: build the mold, or choose it."));
        return legend;
    }
    const SteelScale& scale = steel->maps[0].scale;
    const double least = std::min(steel->maps[0].least, steel->maps[1].least);
    note(Words::tr("behind the walls, thinnest %1").arg(millimetres(least)));
    const auto classes = scene::steelColours(theme().scene.undercut);
    for (int c = SteelScale::classes - 1; c >= (scale.limit > 0 ? 0 : 1); --c) {
        const auto at = static_cast<std::size_t>(c);
        const double area = steel->maps[0].areas.at(at) + steel->maps[1].areas.at(at);
        legend.lines.push_back({classes.at(at),
                                {{wordsOf(scale, c).toStdString()}},
                                u"%1 cm²"_s.arg(area / 100, 0, 'f', 1).toStdString()});
    }
    return legend;
}

} // namespace moldwright
