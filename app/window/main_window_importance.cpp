// SPDX-License-Identifier: AGPL-3.0-or-later
// The tools that paint importance, and what is done with its regions.
#include "window/main_window.h"

#include "view/part_view.h"
#include "window/importance_pages.h"
#include "window/paint_tool.h"
#include "window/view_area.h"
#include "window/view_pane.h"
#include "window/workbench.h"

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr double largerPerPress = 1.2; ///< of the brush's radius

std::optional<PaintBy> paintBy(Tool tool) {
    switch (tool) {
    case Tool::Paint:
        return PaintBy::Brush;
    case Tool::PaintCrease:
        return PaintBy::Crease;
    case Tool::PaintPiece:
        return PaintBy::Piece;
    case Tool::PaintLasso:
        return PaintBy::Lasso;
    default:
        return std::nullopt;
    }
}

} // namespace

void MainWindow::connectImportanceActions() {
    m_actions.on(u"paint-erase"_s, [this] {
        m_paint->setErasing(m_actions[u"paint-erase"_s]->isChecked());
        refreshSoon();
    });
    m_actions.on(u"brush-smaller"_s,
                 [this] { m_bench.setBrushRadius(m_bench.brushRadius() / largerPerPress); });
    m_actions.on(u"brush-larger"_s,
                 [this] { m_bench.setBrushRadius(m_bench.brushRadius() * largerPerPress); });
    m_actions.on(u"new-region"_s, [this] {
        select(allRegionsId());
        if (!paintBy(m_tool))
            useTool(Tool::Paint);
    });
    m_actions.on(u"clear-importance"_s, [this] { m_bench.clearImportance(); });
    m_actions.on(u"import-weights"_s, [this] { chooseWeightsToImport(); });
    m_actions.on(u"export-weights"_s, [this] { chooseWeightsToExport(); });
}

void MainWindow::usePaintTool() {
    const std::optional<PaintBy> by = paintBy(m_tool);
    m_paint->setActive(by);
    if (by && !regionsChosen(m_selected))
        select(allRegionsId());
    // What is painted is to be seen while a brush is in hand; then the view shows again what it did.
    if (by && !m_modeBefore) {
        m_modeBefore = m_views->active().settings().mode;
        setMode(DisplayMode::Importance);
    } else if (!by && m_modeBefore) {
        if (m_views->active().settings().mode == DisplayMode::Importance)
            setMode(*m_modeBefore);
        m_modeBefore.reset();
    }
}

QString MainWindow::paintHint() const {
    const int region = m_paint->region();
    const bool known = region >= 0 && region < static_cast<int>(m_bench.project().importance.size());
    const QString name =
        known ? QString::fromStdString(m_bench.project().importance[static_cast<std::size_t>(region)].name)
                    .toHtmlEscaped()
              : tr("a new region");
    const QString where = m_paint->erasing() ? tr("Strokes halve the weight.")
                                             : tr("Strokes double the weight in %1.").arg(name);
    if (m_tool == Tool::PaintLasso)
        return tr("<b>Draw</b> around the faces. %1 With <b>Ctrl</b> the opposite, <b>Esc</b> leaves.")
            .arg(where);
    if (m_tool != Tool::Paint)
        return tr("<b>Click</b> a face. %1 With <b>Ctrl</b> the opposite, <b>Esc</b> leaves.").arg(where);
    return tr("<b>Draw</b> over the part. %1 With <b>Ctrl</b> the opposite, <b>F</b> or <b>Alt+wheel</b> "
              "resizes, "
              "<b>Esc</b> leaves.")
        .arg(where);
}

} // namespace moldwright
