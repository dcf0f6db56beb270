// SPDX-License-Identifier: AGPL-3.0-or-later
// A mesh that cannot be designed with: it is shown with its faults, before the document, until it is left.
#include "window/main_window.h"

#include "panels/banner.h"
#include "view/part_view.h"
#include "window/advice.h"
#include "window/refusal_pages.h"
#include "window/refused_mesh.h"
#include "window/sentence.h"
#include "window/view_area.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <QApplication>
#include <QClipboard>
#include <QStackedWidget>

#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

void MainWindow::connectRefusal() {
    connect(&m_bench, &Workbench::refusalChanged, this,
            [this] { m_bench.refused() ? enterRefusal() : leaveRefusal(); });
    connect(m_banner, &Banner::closed, this, [this] {
        if (m_bench.refused())
            m_bench.leaveRefused();
    });
    m_actions.on(u"read-again"_s, [this] { openPath(m_bench.refused()->file); });
    m_actions.on(u"repair-mesh"_s, [this] { leaving([this] { m_bench.repairRefused(); }); });
    m_actions.on(u"leave-refused"_s, [this] { m_bench.leaveRefused(); });
    m_actions.on(u"next-fault"_s, [this] { showNextFault(); });
    m_actions.on(u"copy-diagnosis"_s,
                 [this] { QApplication::clipboard()->setText(diagnosisText(*m_bench.refused())); });
}

void MainWindow::enterRefusal() {
    useTool(Tool::None);
    if (!m_beforeRefusal) {
        m_beforeRefusal = {m_selected, {}};
        for (ViewPane* pane : m_views->made())
            m_beforeRefusal->cameras[pane] = pane->view().camera();
    }
    for (const ViewPane* pane : m_views->made())
        pane->view().scene().setSurface(nullptr, {});
    m_fitWhenDrawn = Fit::FromHome;
    select(refusedId());
    const RefusedMesh& refused = *m_bench.refused();
    const auto [headline, rest] = headAndRest(sentence(refused.part.faults.front().message));
    const bool somewhere = listedFaults(refused) > 0;
    advise(
        {Standing::Failing, headline, rest, u"repair-mesh"_s, somewhere ? u"next-fault"_s : u"read-again"_s});
    refresh();
    m_view->setFocus();
}

void MainWindow::leaveRefusal() {
    m_banner->hide();
    m_fitWhenDrawn = Fit::Not;
    const BeforeRefusal before = *std::exchange(m_beforeRefusal, std::nullopt);
    for (const auto& [pane, camera] : before.cameras)
        pane->view().standAt(camera);
    select(before.selected);
    refresh();
    m_centre->currentWidget()->setFocus();
}

void MainWindow::showNextFault() {
    const int places = listedFaults(*m_bench.refused());
    const int next = (faultNumber(m_selected) + 1) % places;
    const QString id = faultId(next);
    if (id == m_selected)
        fitSelection(); // the only one there is
    select(id);
}

void MainWindow::showRefused(ViewPane& pane) {
    const RefusedMesh& refused = *m_bench.refused();
    PartView& view = pane.view();
    scene::Scene& scene = view.scene();
    view.setEditable(false);
    view.setCoarse(false);
    view.setLive(false);
    view.setBrushRadius(0);
    scene.setState(std::nullopt);
    if (scene.surface() != refused.drawn)
        scene.setSurface(refused.drawn, {});
    view.setPicker(refused.picker);
    const FacePaint paint = refusedPaint(refused);
    scene.setFaceColours(paint.faces);
    scene.setStandInColours(paint.standIn);
    scene.setTwoSided(true);
    scene.setFaults(refused.edges);
    showMold(scene, false, nullptr);
    scene.setEdges(pane.settings().edges);
    scene.setSeeThrough(pane.settings().seeThrough || refused.faultHidden());
    scene.setSurfaceVisible(true);
    scene.setCut(std::nullopt);
    scene.setLegend(refusedLegend(refused));
    scene.setStateChip(stateChipFor(m_bench, pane.settings().content));
    scene.setChips(faultMarks(refused, m_selected));
    scene.setPath({});
    scene.setPins({});
    scene.setFilling(nullptr);
    scene.setPlan({});
    view.redraw();
}

} // namespace moldwright
