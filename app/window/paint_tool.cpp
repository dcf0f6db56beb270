// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/paint_tool.h"

#include "mesh/geodesic_disc.h"
#include "view/part_view.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <QPointer>

#include <algorithm>
#include <iterator>
#include <utility>

namespace moldwright {

PaintTool::PaintTool(Workbench& bench, QObject* parent) : QObject(parent), m_bench(bench) {}

void PaintTool::serve(ViewPane& pane) {
    const PartView* view = &pane.view();
    connect(
        view, &PartView::strokeBegan, this,
        [this, &pane](const scene::SurfacePicker::Hit& hit, bool inverted) { begin(pane, hit, inverted); });
    connect(view, &PartView::strokeWentOn, this, &PaintTool::goOn);
    connect(view, &PartView::strokeEnded, this, &PaintTool::end);
    connect(view, &PartView::strokeCancelled, this, [this] {
        m_mesh.reset();
        m_bench.document().endPreview();
    });
    connect(view, &PartView::lassoDrawn, this,
            [this, &pane](const scene::Lasso& lasso, bool inverted) { takeLasso(pane, lasso, inverted); });
}

bool PaintTool::mayPaint(const ViewPane& pane) {
    if (!m_by || m_bench.background().busy())
        return false;
    const ShownSurface surface = m_bench.surface(pane.settings().content);
    // While a run shows other shapes, the faces are those of a surface that is gone.
    return surface.picker && surface.drawn->mesh == m_bench.project().part &&
           surface.picker->mesh() == m_bench.project().part;
}

void PaintTool::begin(const ViewPane& pane, const scene::SurfacePicker::Hit& hit, bool inverted) {
    if (!mayPaint(pane))
        return;
    m_mesh = m_bench.project().part;
    if (!m_neighbours || &m_neighbours->mesh() != m_mesh.get())
        m_neighbours = std::make_unique<FaceNeighbours>(m_mesh);
    m_strokeErases = inverted != m_erasing;
    m_faces.clear();
    add(hit);
    m_bench.previewStroke(m_region, m_faces, m_strokeErases);
}

void PaintTool::goOn(const std::vector<scene::SurfacePicker::Hit>& hits) {
    if (!m_mesh || m_by != PaintBy::Brush)
        return;
    const std::size_t before = m_faces.size();
    for (const scene::SurfacePicker::Hit& hit : hits)
        add(hit);
    if (m_faces.size() != before)
        m_bench.previewStroke(m_region, m_faces, m_strokeErases);
}

void PaintTool::end() {
    if (!std::exchange(m_mesh, nullptr))
        return;
    Q_EMIT painted(m_bench.stroke(m_region, m_faces, m_strokeErases));
}

void PaintTool::add(const scene::SurfacePicker::Hit& hit) {
    const std::vector<int> faces =
        m_by == PaintBy::Brush
            ? geodesicDisc(*m_neighbours, {hit.face, hit.point}, m_bench.brushRadius())
            : smoothPatch(*m_neighbours, hit.face, m_by == PaintBy::Piece ? 180 : m_bench.creaseDegrees());
    std::vector<int> all;
    all.reserve(m_faces.size() + faces.size());
    std::ranges::set_union(m_faces, faces, std::back_inserter(all));
    m_faces = std::move(all);
}

void PaintTool::takeLasso(const ViewPane& pane, const scene::Lasso& lasso, bool inverted) {
    if (!mayPaint(pane))
        return;
    m_bench.strokeIn(lasso, m_region, inverted != m_erasing, [tool = QPointer(this)](int painted) {
        if (tool) // the window may have made way for another
            Q_EMIT tool->painted(painted);
    });
}

} // namespace moldwright
