// SPDX-License-Identifier: AGPL-3.0-or-later
// Several designs of one part: which one is worked on, and which one is shown beside it.
#include "window/main_window.h"

#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "project/variants.h"
#include "view/part_view.h"
#include "window/variant_pages.h"
#include "window/view_area.h"
#include "window/workbench.h"

namespace moldwright {

using namespace Qt::StringLiterals;

void MainWindow::connectVariantActions() {
    const auto selectCurrent = [this] {
        select(variantId(static_cast<int>(m_bench.document().committed().place)));
    };
    m_actions.on(u"new-variant"_s, [this, selectCurrent] {
        m_bench.addVariant();
        selectCurrent();
    });
    m_actions.on(u"duplicate-variant"_s, [this, selectCurrent] {
        m_bench.duplicateVariant(variantMeant(m_selected, m_bench));
        selectCurrent();
    });
    m_actions.on(u"choose-variant"_s, [this] { chooseVariantNow(variantMeant(m_selected, m_bench)); });
    for (const int way : {1, -1})
        m_actions.on(way > 0 ? u"next-variant"_s : u"previous-variant"_s, [this, way, selectCurrent] {
            m_bench.walkVariants(way);
            if (variantsChosen(m_selected))
                selectCurrent();
        });
    m_actions.on(u"compare-variants"_s, [this] { compareVariants(); });
    connect(m_tree, &ProjectTree::taken, this, [this](const QString& id) {
        if (variantNumber(id) >= 0)
            chooseVariantNow(variantNumber(id));
    });
    connect(m_properties, &PropertyPanel::taken, this,
            [this](const QString&, int variant) { chooseVariantNow(variant); });
}

void MainWindow::chooseVariantNow(int variant) {
    if (!m_bench.background().busy())
        m_bench.chooseVariant(variant);
}

void MainWindow::compareVariants() {
    const Project& project = m_bench.document().committed();
    const auto compared = m_bench.variants().compared();
    auto wanted = static_cast<std::size_t>(variantMeant(m_selected, m_bench));
    if (compared && (wanted == project.place || wanted == *compared))
        return endComparison();
    if (wanted == project.place)
        wanted = (wanted + 1) % variantCount(project);
    if (m_views->viewLayout() != ViewLayout::Compared) {
        m_layoutBefore = m_views->viewLayout();
        m_views->setViewLayout(ViewLayout::Compared);
    }
    m_bench.variants().compareWith(wanted);
}

void MainWindow::endComparison() {
    m_bench.variants().compareWith({});
    followComparison();
}

void MainWindow::followComparison() {
    if (m_views->viewLayout() == ViewLayout::Compared && !m_bench.variants().compared())
        m_views->setViewLayout(m_layoutBefore);
    m_actions[u"compare-variants"_s]->setChecked(m_bench.variants().compared().has_value());
}

} // namespace moldwright
