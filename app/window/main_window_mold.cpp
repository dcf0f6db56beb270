// SPDX-License-Identifier: AGPL-3.0-or-later
// The mold's features in the views: chosen, dragged in the parting plane, given back to the program.
#include "window/main_window.h"

#include "view/part_view.h"
#include "window/chosen_features.h"
#include "window/live_steel.h"
#include "window/mold_feature_pages.h"
#include "window/mold_placing.h"
#include "window/opening_bar.h"
#include "window/placing_snap.h"
#include "window/steel_paint.h"
#include "window/tray_pages.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <cmath>
#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr double snapReach = 6; ///< logical pixels

/// Where a ray meets the parting plane, in the mold's frame; none where it runs along it.
std::optional<Eigen::Vector2d> onPlane(const scene::Ray& ray, const Eigen::Isometry3d& partToMold) {
    const Eigen::Vector3d origin = partToMold * ray.origin;
    const Eigen::Vector3d way = partToMold.linear() * ray.direction;
    constexpr double alongIt = 0.02;
    if (std::abs(way.z()) < alongIt)
        return std::nullopt;
    return Eigen::Vector2d((origin - way * (origin.z() / way.z())).head<2>());
}

/// The row of a feature in a view; null where an answer that the view has not shown yet left it out.
const PlacedRow* shownRow(const MoldPlacing& placing, const scene::FeatureAt& at) {
    const auto row = static_cast<std::size_t>(at.feature);
    const auto copy = static_cast<std::size_t>(at.copy);
    const bool known = row < placing.rows().size() && copy < placing.rows()[row].copies.size();
    return known ? &placing.rows()[row] : nullptr;
}

} // namespace

bool MainWindow::moldShown() const {
    return m_bench.moldIsCurrent() && m_visible.mold &&
           (m_selected == u"mold"_s || m_selected.startsWith(u"half"_s) || trayNumber(m_selected) >= 0);
}

void MainWindow::showMold(scene::Scene& scene, bool shown, const ShownSteel* steel) {
    const auto half = [&](int side) {
        return !shown  ? scene::SharedDrawnMesh()
               : steel ? steel->halves[static_cast<std::size_t>(side - 1)]
                       : m_bench.drawnHalf(side);
    };
    if (half(1) == scene.half(1))
        return;
    if (!shown) {
        scene.setHalves(nullptr, nullptr, Eigen::Isometry3d::Identity(), {});
        return;
    }
    scene.setHalves(half(1), half(2), m_bench.mold()->partToMold.inverse(),
                    m_bench.project().cast->state.directions);
    for (const int side : {1, 2})
        if (const auto i = static_cast<std::size_t>(side - 1); steel)
            scene.setHalfColours(side, steelPaint(steel->maps[i], steel->maps[i].thickness, side),
                                 steelPaint(steel->maps[i], steel->standInSteel[i], side));
    scene.setContacts(m_bench.contacts());
    scene.setOpening(scene::openingAt(m_opening->opening()));
}

void MainWindow::showMoldOpen() {
    // Both parting faces look along the normal: from there, and a little from below as one looks at a table.
    const Eigen::Vector3d normal = m_bench.project().state->plane.normal;
    const bool upright = std::abs(normal.z()) < 0.7;
    const Eigen::Vector3d aside = upright ? Eigen::Vector3d::UnitZ().eval()
                                          : Eigen::Vector3d(-m_bench.mold()->partToMold.linear().row(1));
    scene::Scene& scene = m_view->scene();
    scene.setOpening(scene::openingAt(1)); // all of it is to be in sight once it is open
    m_view->lookFrom(normal + 0.5 * aside);
    scene.setOpening(scene::openingAt(m_opening->opening()));
    m_opening->ease(1);
}

std::vector<scene::Chip> MainWindow::halfChips(const scene::Scene& scene) const {
    std::vector<scene::Chip> chips;
    if (m_opening->opening() < 0.5)
        return chips; // they would lie on one another
    for (const int side : {1, 2}) {
        const scene::SharedDrawnMesh& half = scene.half(side);
        if (!half)
            return {};
        const Eigen::Vector3d edge(half->box.center().x(), half->box.min().y(), 0);
        chips.push_back({scene.placeOnHalf(side, edge),
                         {{},
                          {{std::nullopt,
                            {{tr("Half %1").arg(side).toStdString(),
                              side == 1 ? scene::Ink::Side1 : scene::Ink::Side2, true},
                             {tr("opens along direction %1").arg(side).toStdString()}},
                            {}}}}});
    }
    const Mold& mold = *m_bench.mold();
    chips.push_back({scene.placeOnHalf(mold.minWallPlace.z() > 0 ? 1 : 2, mold.minWallPlace),
                     {{},
                      {{std::nullopt,
                        {{tr("Smallest steel").toStdString()},
                         {tr("%1 mm").arg(mold.minWall, 0, 'f', 2).toStdString(), scene::Ink::Text, true}},
                        {}}}}});
    return chips;
}

bool MainWindow::planShown() const {
    const bool chosen =
        m_selected == u"mold"_s || m_selected.startsWith(u"feature-"_s) || trayNumber(m_selected) >= 0;
    return chosen && m_bench.castShown() && m_visible.mold && !moldShown();
}

void MainWindow::serveFeatures(ViewPane& pane) {
    PartView* view = &pane.view();
    connect(view, &PartView::featureDragged, this,
            [this, view](const scene::FeatureAt& at, const scene::Ray& ray, bool exactly) {
                dragFeature(*view, at, ray, exactly);
            });
    connect(view, &PartView::featureDropped, this, [this] {
        if (const auto feature = std::exchange(m_dragged, std::nullopt))
            m_bench.placing().place(*feature, {}, false);
    });
    connect(view, &PartView::featureDragCancelled, this, [this] {
        m_dragged.reset();
        m_bench.document().endPreview();
    });
    connect(view, &PartView::featureClicked, this,
            [this](const scene::FeatureAt& at, Qt::KeyboardModifiers keys) {
                if (const PlacedRow* row = shownRow(m_bench.placing(), at))
                    choose({featureId(row->stands.kind, row->stands.number)}, keys);
            });
}

void MainWindow::dragFeature(const PartView& view, const scene::FeatureAt& at, const scene::Ray& ray,
                             bool exactly) {
    const MoldPlacing& placing = m_bench.placing();
    if (m_bench.background().busy() || placing.sketch() == nullptr)
        return;
    const auto pointed = onPlane(ray, placing.sketch()->partToMold);
    // Rows come and go with answers: the one that is held is known by its name.
    const PlacedRow* row =
        m_dragged ? placing.row(m_dragged->kind, m_dragged->number) : shownRow(placing, at);
    if (!pointed || row == nullptr)
        return;
    if (!m_dragged)
        m_dragOrigin = row->copies.at(static_cast<std::size_t>(at.copy))->origin;
    const Eigen::Vector2d wish = *pointed - m_dragOrigin;
    PlacedFeature feature = row->stands;
    feature.place = exactly ? (wish * 100).array().round().matrix() / 100
                            : snapped(wish, *row, placing.rows(), snapReach * view.pixelLength());
    m_dragged = feature;
    select(featureId(feature.kind, feature.number));
    m_bench.placing().place(feature, {}, true);
}

void MainWindow::connectFeatureActions() {
    m_actions.on(u"place-automatically"_s, [this] {
        std::vector<std::pair<Placeable, int>> features;
        for (const auto& [kind, number] : featuresOf(m_selected))
            features.emplace_back(kind, number);
        m_bench.placing().placeAutomatically(features);
    });
    m_actions.on(u"place-all-automatically"_s, [this] { m_bench.placing().placeAllAutomatically(); });
}

} // namespace moldwright
