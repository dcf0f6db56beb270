// SPDX-License-Identifier: AGPL-3.0-or-later
// The steel between the mold's features: listed, and shown where it is.
#include "window/main_window.h"

#include "panels/steel_table.h"
#include "view/part_view.h"
#include "window/mold_placing.h"
#include "window/workbench.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr std::size_t listedAtMost = 100; ///< pairs, thinnest first
constexpr double aboutPlace = 0.12;       ///< of the block's length: what is brought into sight

} // namespace

/// Of the mold as it was built, or while that is out of date, as it would be.
const std::vector<ThinSteel>& MainWindow::steelInView() const {
    static const std::vector<ThinSteel> none;
    const MoldSketch* sketch = m_bench.placing().sketch();
    if (m_bench.refused())
        return none;
    return m_bench.moldIsCurrent()         ? m_bench.mold()->steelOfEach
           : m_bench.castShown() && sketch ? sketch->steel
                                           : none;
}

void MainWindow::refreshSteel() {
    std::vector<SteelRow> rows;
    const std::vector<ThinSteel>& steel = steelInView();
    for (std::size_t i = 0; i < std::min(steel.size(), listedAtMost); ++i)
        rows.push_back(
            {steelEnds(steel[i]), steel[i].thickness, steelAsked(steel[i], m_bench.project().mold)});
    m_steelTable->setRows(rows);
}

void MainWindow::showSteel(int row) {
    const std::vector<ThinSteel>& steel = steelInView();
    if (row >= static_cast<int>(steel.size()))
        return;
    const Eigen::Vector3d& place = steel[static_cast<std::size_t>(row)].place;
    const bool built = m_bench.moldIsCurrent();
    const Eigen::Isometry3d& partToMold =
        built ? m_bench.mold()->partToMold : m_bench.placing().sketch()->partToMold;
    const Block& block = built ? m_bench.mold()->block : m_bench.placing().sketch()->block;
    const Eigen::Vector3d seen = moldShown() ? m_view->scene().placeOnHalf(place.z() > 0 ? 1 : 2, place)
                                             : partToMold.inverse() * place;
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(aboutPlace * block.box().sizes().maxCoeff());
    m_view->frame({seen - half, seen + half});
}

} // namespace moldwright
