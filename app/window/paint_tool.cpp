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
    connect(view, &PartView::strokeWentOn, this,
            [this, &pane](const std::vector<scene::SurfacePicker::Hit>& hits) { goOn(pane, hits); });
    connect(view, &PartView::strokeEnded, this, &PaintTool::end);
    connect(view, &PartView::strokeCancelled, this, [this] {
        m_mesh.reset();
        m_bench.document().endPreview();
    });
    connect(view, &PartView::lassoDrawn, this,
            [this, &pane](const scene::Lasso& lasso, bool inverted) { takeLasso(pane, lasso, inverted); });
}

std::optional<SurfacePlace> PaintTool::placeOf(const ViewPane& pane,
                                               const scene::SurfacePicker::Hit& hit) const {
    if (!m_by || !m_bench.editable() || hit.face < 0)
        return std::nullopt;
    const ShownSurface surface = m_bench.surface(pane.settings().content);
    const SharedMesh& part = m_bench.project().part;
    if (!surface.picker || surface.picker->mesh() != surface.drawn->mesh)
        return std::nullopt;
    if (surface.drawn->mesh == part)
        return SurfacePlace{hit.face, hit.point};
    const auto origins =
        surface.before ? m_bench.origins().of({part, surface.drawn->mesh, surface.before}) : nullptr;
    return origins ? origins->onPart(*surface.drawn->mesh, {hit.face, hit.point}) : std::nullopt;
}

void PaintTool::begin(const ViewPane& pane, const scene::SurfacePicker::Hit& hit, bool inverted) {
    const std::optional<SurfacePlace> place = placeOf(pane, hit);
    if (!place)
        return;
    m_mesh = m_bench.project().part;
    if (!m_neighbours || &m_neighbours->mesh() != m_mesh.get())
        m_neighbours = std::make_unique<FaceNeighbours>(m_mesh);
    m_strokeErases = inverted != m_erasing;
    m_faces.clear();
    add(*place);
    m_bench.previewStroke(m_region, m_faces, m_strokeErases);
}

void PaintTool::goOn(const ViewPane& pane, const std::vector<scene::SurfacePicker::Hit>& hits) {
    if (!m_mesh || m_by != PaintBy::Brush)
        return;
    const std::size_t before = m_faces.size();
    for (const scene::SurfacePicker::Hit& hit : hits)
        if (const std::optional<SurfacePlace> place = placeOf(pane, hit))
            add(*place);
    if (m_faces.size() != before)
        m_bench.previewStroke(m_region, m_faces, m_strokeErases);
}

void PaintTool::end() {
    if (!std::exchange(m_mesh, nullptr))
        return;
    Q_EMIT painted(m_bench.stroke(m_region, m_faces, m_strokeErases));
}

void PaintTool::add(const SurfacePlace& place) {
    const std::vector<int> faces =
        m_by == PaintBy::Brush
            ? geodesicDisc(*m_neighbours, place, m_bench.brushRadius())
            : smoothPatch(*m_neighbours, place.face, m_by == PaintBy::Piece ? 180 : m_bench.creaseDegrees());
    std::vector<int> all;
    all.reserve(m_faces.size() + faces.size());
    std::ranges::set_union(m_faces, faces, std::back_inserter(all));
    m_faces = std::move(all);
}

void PaintTool::takeLasso(const ViewPane& pane, const scene::Lasso& lasso, bool inverted) {
    const ShownSurface surface = m_bench.surface(pane.settings().content);
    if (!m_by || !m_bench.editable() || !surface.drawn ||
        (surface.drawn->mesh != m_bench.project().part && !surface.before))
        return;
    if (m_bench.running()) {
        m_bench.say(Standing::Info, tr("A lasso looks for its faces once the run has ended. The other "
                                       "brushes paint while it goes on."));
        return;
    }
    m_bench.strokeIn(lasso, surface, m_region, inverted != m_erasing, [tool = QPointer(this)](int painted) {
        if (tool) // the window may have made way for another
            Q_EMIT tool->painted(painted);
    });
}

} // namespace moldwright
