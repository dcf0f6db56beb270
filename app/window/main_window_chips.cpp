// SPDX-License-Identifier: AGPL-3.0-or-later
// The words that stand in a view beside what they are about.
#include "window/main_window.h"

#include "view/part_view.h"
#include "window/chosen_features.h"
#include "window/face_paint.h"
#include "window/importance_pages.h"
#include "window/importance_paint.h"
#include "window/measure_tool.h"
#include "window/obstruction_words.h"
#include "window/pin_pages.h"
#include "window/tray_pages.h"
#include "window/undercut_pages.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <algorithm>
#include <iterator>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

/// Whether a chip tells of the crease: where one decides on it.
bool creaseTold(const QString& selected, const scene::SharpestCrease& crease) {
    return crease.degrees >= 1 &&
           (selected == u"plane"_s || selected.startsWith(u"direction"_s) || selected == u"cast"_s);
}

} // namespace

std::vector<scene::Chip> MainWindow::directionChips(const ViewPane& pane) const {
    const scene::Scene& scene = pane.view().scene();
    std::vector<scene::Chip> chips;
    if (const auto state = m_bench.stateIn(pane.settings().content);
        state && m_visible.directions && !m_modeBefore && !planShown()) // there they would cover the cast
        for (const int side : {1, 2})
            chips.push_back(
                {scene.arrowTip(side),
                 {{},
                  {{std::nullopt,
                    {{std::to_string(side), side == 1 ? scene::Ink::Side1 : scene::Ink::Side2, true},
                     {tr("%1 to plane normal").arg(angleText(tiltDegrees(*state, side))).toStdString()}},
                    {}}}}});
    return chips;
}

std::vector<scene::Chip> MainWindow::guideChips(const ViewPane& pane) const {
    const scene::Scene& scene = pane.view().scene();
    std::vector<scene::Chip> chips;
    if (const scene::SharpestCrease& crease = scene.sharpestCrease(); creaseTold(m_selected, crease))
        chips.push_back(
            {crease.place,
             {{},
              {{std::nullopt, {{tr("Crease up to %1").arg(angleText(crease.degrees)).toStdString()}}, {}}}}});
    if (scene.surface() && scene.surface()->mesh == m_bench.project().part && m_visible.pins)
        std::ranges::copy(pinChips(m_bench, m_selected), std::back_inserter(chips));
    if (scene.surface() && regionsChosen(m_selected) && !m_modeBefore)
        std::ranges::copy(
            regionChips(m_bench, m_bench.surface(pane.settings().content), m_visible, m_selected),
            std::back_inserter(chips));
    if (planShown()) {
        std::ranges::copy(trayChips(m_bench, m_selected), std::back_inserter(chips));
        std::ranges::copy(chipsOfChosen(m_bench, m_selected), std::back_inserter(chips));
    }
    for (const Eigen::Vector3d& point : m_planePoints)
        chips.push_back({point, {}, scene.colours().accent});
    return chips;
}

std::vector<scene::Chip> MainWindow::chipsIn(const ViewPane& pane, const FaceMap* map) const {
    const scene::Scene& scene = pane.view().scene();
    // Marks first: their numbers are those of the obstructions. They are the current variant's.
    std::vector<scene::Chip> chips;
    if (!showsOther(pane)) {
        chips = marksOf(m_bench.obstructions(), obstructionNumber(m_selected));
        std::ranges::copy(undercutMarks(m_bench, m_selected), std::back_inserter(chips));
    }
    std::ranges::copy(directionChips(pane), std::back_inserter(chips));
    if (!showsOther(pane))
        std::ranges::copy(guideChips(pane), std::back_inserter(chips));
    if (map)
        if (const auto largest = largestOf(*map))
            chips.push_back(*largest);
    if (scene.surface() && m_measure->measurement().isOf(scene.surface()->mesh))
        std::ranges::copy(m_measure->measurement().chips(scene.colours().accent), std::back_inserter(chips));
    return chips;
}

} // namespace moldwright
