// SPDX-License-Identifier: AGPL-3.0-or-later
// Tools: what a click on the part does. One is in hand at a time; Esc puts it away.
#include "window/main_window.h"

#include "castability/plane_snaps.h"
#include "mesh/measures.h"
#include "project/edits.h"
#include "scene/plane_handle.h"
#include "view/part_view.h"
#include "window/importance_pages.h"
#include "window/measure_tool.h"
#include "window/paint_tool.h"
#include "window/pin_offers.h"
#include "window/pin_pages.h"
#include "window/variant_pages.h"
#include "window/view_area.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <array>
#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr double onSurface = 1e-6; ///< of the part's diagonal

struct ToolSpec {
    Tool tool;
    QString command;
    PartView::Picking picking;
    bool onPart = false; ///< works on the part as opened: its cast goes, as after any edit of the part
};

const std::vector<ToolSpec>& toolTable() {
    static const std::vector<ToolSpec> table = {
        {Tool::Measure, u"measure"_s, PartView::Picking::Place},
        {Tool::LayFlat, u"lay-flat"_s, PartView::Picking::Face, true},
        {Tool::Pin, u"pin"_s, PartView::Picking::Pin, true},
        {Tool::PinInside, u"pin-inside"_s, PartView::Picking::PinInside, true},
        {Tool::AcceptLasso, u"accept-lasso"_s, PartView::Picking::Lasso, true},
        {Tool::PlaneOnFace, u"plane-on-face"_s, PartView::Picking::Face},
        {Tool::PlaneByPoints, u"plane-by-points"_s, PartView::Picking::Place},
        {Tool::Paint, u"paint"_s, PartView::Picking::Stroke},
        {Tool::PaintCrease, u"paint-crease"_s, PartView::Picking::Stroke},
        {Tool::PaintPiece, u"paint-piece"_s, PartView::Picking::Stroke},
        {Tool::PaintLasso, u"paint-lasso"_s, PartView::Picking::Lasso},
    };
    return table;
}

} // namespace

void MainWindow::connectToolActions() {
    for (const ToolSpec& spec : toolTable())
        m_actions.on(spec.command, [this, tool = spec.tool, command = spec.command] {
            useTool(m_actions[command]->isChecked() ? tool : Tool::None);
        });
    const std::array axes = {u"plane-x"_s, u"plane-y"_s, u"plane-z"_s};
    for (int axis = 0; axis < 3; ++axis)
        m_actions.on(axes[static_cast<std::size_t>(axis)], [this, axis] {
            const PartingPlane plane = m_bench.projectInView().state->plane;
            const Eigen::Vector3d middle = m_bench.figures(m_bench.project().part).box.center();
            snapPlane(
                squareTo(Eigen::Vector3d::Unit(axis), middle - plane.distance(middle) * plane.normal, plane));
        });
}

void MainWindow::useTool(Tool tool) {
    m_tool = tool;
    m_planePoints.clear();
    m_measure->setActive(tool == Tool::Measure);
    m_bench.setPicking(tool != Tool::None);
    auto picking = PartView::Picking::Nothing;
    for (const ToolSpec& spec : toolTable()) {
        m_actions[spec.command]->setChecked(spec.tool == tool);
        if (spec.tool != tool)
            continue;
        picking = spec.picking;
        if (spec.onPart && m_bench.castShown())
            m_bench.restoreShape();
    }
    for (const ViewPane* pane : m_views->made())
        pane->view().setPicking(picking);
    if (tool == Tool::Pin || tool == Tool::PinInside || tool == Tool::AcceptLasso)
        select(u"pins"_s);
    usePaintTool();
    if (tool != Tool::None)
        m_view->setFocus();
    refreshSoon();
}

QString MainWindow::toolHint() const {
    switch (m_tool) {
    case Tool::None:
        break;
    case Tool::Measure:
        return tr("<b>Click</b> a place, a second for the distance, a third for the angle. "
                  "<b>Ctrl+C</b> copies, <b>Esc</b> leaves.");
    case Tool::LayFlat:
        return tr("<b>Click</b> the face that shall lie on the ground. <b>Esc</b> leaves.");
    case Tool::Pin:
        return tr("<b>Click</b> a point of the surface to pin it, with <b>Shift</b> the point inside below "
                  "it. <b>Esc</b> leaves.");
    case Tool::PinInside:
        return tr("<b>Click</b> to pin the point inside below the pointer, with <b>Shift</b> the one on the "
                  "surface. <b>Esc</b> leaves.");
    case Tool::AcceptLasso:
        return tr("<b>Draw</b> around the suggested points that shall be pinned. <b>Esc</b> leaves.");
    case Tool::PlaneOnFace:
        return tr("<b>Click</b> the face that the parting plane shall lie in. <b>Esc</b> leaves.");
    case Tool::PlaneByPoints:
        return tr("<b>Click</b> point %1 of 3 that the parting plane shall run through. <b>Esc</b> leaves.")
            .arg(m_planePoints.size() + 1);
    case Tool::Paint:
    case Tool::PaintCrease:
    case Tool::PaintPiece:
    case Tool::PaintLasso:
        return paintHint();
    }
    return {};
}

void MainWindow::serveTools(ViewPane& pane) {
    m_paint->serve(pane);
    const PartView* view = &pane.view();
    connect(view, &PartView::brushScaled, this,
            [this](double factor) { m_bench.setBrushRadius(m_bench.brushRadius() * factor); });
    connect(view, &PartView::faceClicked, this, [this, &pane](int face) {
        if (!m_bench.editable())
            return;
        if (m_tool == Tool::LayFlat)
            m_bench.layFlatOn(face);
        else if (const scene::SharedDrawnMesh& drawn = m_bench.surface(pane.settings().content).drawn)
            if (const auto plane = planeOfFace(*drawn->mesh, face, m_bench.projectInView().state->plane))
                snapPlane(*plane);
        useTool(Tool::None);
    });
    connect(view, &PartView::pointClicked, this, [this](const scene::SurfacePicker::Hit& hit) {
        if (m_tool == Tool::PlaneByPoints && m_bench.editable())
            takePlanePoint(hit.point);
    });
    servePins(pane);
}

void MainWindow::servePins(ViewPane& pane) {
    const PartView* view = &pane.view();
    connect(view, &PartView::pinDragged, this,
            [this, &pane](int pin, const scene::Ray& ray, const scene::SurfacePicker::Hit& hit) {
                const auto picker = m_bench.surface(pane.settings().content).picker;
                const Project& project = m_bench.document().committed();
                if (m_bench.background().busy() || !picker || picker->mesh() != project.part)
                    return;
                // What lies inside stays inside, what lies on the surface on it.
                const Eigen::Vector3d& was = project.pins.at(static_cast<std::size_t>(pin)).point;
                if (!m_pinInside)
                    m_pinInside = picker->distance(was) >
                                  onSurface * m_bench.figures(project.part).box.diagonal().norm();
                const auto inside = *m_pinInside ? picker->middleBelow(hit, ray) : std::nullopt;
                select(pinId(pin));
                m_bench.movePin(pin, inside.value_or(hit.point), {}, true);
            });
    connect(view, &PartView::pinDropped, this, [this](int pin) {
        if (std::exchange(m_pinInside, std::nullopt))
            m_bench.movePin(pin, m_bench.project().pins.at(static_cast<std::size_t>(pin)).point, {});
    });
    connect(view, &PartView::pinDragCancelled, this, [this] {
        m_pinInside.reset();
        m_bench.document().endPreview();
    });
    connect(view, &PartView::lassoDrawn, this, [this](const scene::Lasso& lasso) {
        if (m_tool == Tool::AcceptLasso && m_bench.editable() && !m_bench.pinOffers().acceptIn(lasso))
            m_bench.say(Standing::Info, tr("No suggested point is seen inside the lasso."));
    });
    connect(view, &PartView::pinPlaced, this, [this](const Eigen::Vector3d& place) {
        if (!m_bench.editable())
            return;
        m_bench.addPin(place);
        select(pinId(static_cast<int>(m_bench.project().pins.size()) - 1));
    });
    connect(view, &PartView::pinClicked, this, [this](const scene::PinAt& pin, Qt::KeyboardModifiers keys) {
        if (!pin.suggested)
            choose({pinId(pin.number)}, keys);
        else if (m_bench.editable())
            m_bench.pinOffers().accept(pin.number);
    });
}

void MainWindow::takePlanePoint(const Eigen::Vector3d& point) {
    m_planePoints.push_back(point);
    if (m_planePoints.size() < 3) {
        refreshSoon();
        return;
    }
    const auto plane = planeThrough({m_planePoints[0], m_planePoints[1], m_planePoints[2]},
                                    m_bench.projectInView().state->plane);
    if (plane) {
        snapPlane(*plane);
        useTool(Tool::None);
        return;
    }
    m_planePoints.clear();
    m_bench.say(Standing::Warning,
                tr("These points lie on a line, so they give no plane. Click three others."));
    refreshSoon();
}

void MainWindow::snapPlane(const PartingPlane& plane) {
    m_bench.setState(scene::withPlane(*m_bench.projectInView().state, plane), tr("Snap the plane"));
    select(u"plane"_s);
}

void MainWindow::connectPinActions() {
    m_actions.on(u"suggest-pins"_s, [this] { m_bench.pinOffers().search(); });
    m_actions.on(u"accept-tips"_s, [this] { m_bench.pinOffers().acceptTips(); });
    m_actions.on(u"remove-guide"_s, [this] { removeChosen(); });
    m_actions.on(u"clear-pins"_s, [this] { m_bench.clearPins(); });
    m_actions.on(u"import-pins"_s, [this] { choosePinsToImport(); });
    m_actions.on(u"export-pins"_s, [this] { choosePinsToExport(); });
}

} // namespace moldwright
