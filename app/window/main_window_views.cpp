// SPDX-License-Identifier: AGPL-3.0-or-later
// What the views show, and what happens in them.
#include "window/main_window.h"

#include "project/edits.h"
#include "view/part_view.h"
#include "window/chosen_features.h"
#include "window/face_paint.h"
#include "window/importance_pages.h"
#include "window/importance_paint.h"
#include "window/live_steel.h"
#include "window/measure_tool.h"
#include "window/obstruction_words.h"
#include "window/opening_bar.h"
#include "window/paint_tool.h"
#include "window/pin_pages.h"
#include "window/preferences.h"
#include "window/refusal_pages.h"
#include "window/steel_paint.h"
#include "window/undercut_pages.h"
#include "window/view_area.h"
#include "window/view_bar.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <QMenu>

#include <algorithm>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array layouts = {ViewLayout::One, ViewLayout::Two, ViewLayout::Four};

QString layoutCommand(ViewLayout layout) {
    return layout == ViewLayout::One   ? u"one-view"_s
           : layout == ViewLayout::Two ? u"two-views"_s
                                       : u"four-views"_s;
}

scene::PanelContent legendIn(DisplayMode mode, const Workbench& bench, const ShownSurface& surface,
                             const FaceMap* map, const Visibility& visible) {
    return mode == DisplayMode::Importance ? importanceLegend(bench, surface, visible)
                                           : legendFor(bench, surface, mode, map);
}

/// A direction turned by hand is meant: the run shall take it as it is.
Project draggedTo(const Project& project, const MoldState& state, scene::Grip grip) {
    const bool direction = grip == scene::Grip::Direction1 || grip == scene::Grip::Direction2;
    return direction ? withDirections(project, state.directions) : withState(project, state, true);
}

} // namespace

void MainWindow::buildViews(QWidget* parent) {
    m_views = new ViewArea(parent);
    m_measure = new MeasureTool(m_bench, this);
    m_paint = new PaintTool(m_bench, this);
    m_steel = new LiveSteel(this);
    connect(m_steel, &LiveSteel::measured, this, &MainWindow::refreshSoon);
    connect(m_paint, &PaintTool::painted, this, [this](int region) {
        if (region >= 0)
            select(regionId(region));
    });
    connect(m_measure, &MeasureTool::changed, this, &MainWindow::refreshSoon);
    connect(m_views, &ViewArea::paneMade, this, &MainWindow::connectPane);
    connect(m_views, &ViewArea::activeChanged, this, [this] {
        m_view = &m_views->active().view();
        refreshSoon();
    });
    connect(m_views, &ViewArea::settingsChanged, this, [this] {
        m_bench.keepPartReady(m_views->showsPart());
        refreshSoon();
    });
    connect(m_views, &ViewArea::layoutChanged, this, [this] {
        m_fitWhenDrawn = std::max(m_fitWhenDrawn, Fit::AsTheyLook);
        refreshSoon();
    });
    m_views->restore(preferences::layout(u"views"_s));
    connect(m_viewBar, &ViewBar::modeChosen, this, &MainWindow::setMode);
    connect(m_opening, &OpeningBar::openingChanged, this, [this](double opening) {
        for (const ViewPane* pane : m_views->shown()) {
            pane->view().scene().setOpening(scene::openingAt(opening));
            if (moldShown())
                pane->view().scene().setChips(halfChips(pane->view().scene()));
            pane->view().fitAll();
        }
    });
}

void MainWindow::connectPane(ViewPane& pane) {
    m_measure->serve(pane);
    serveTools(pane);
    serveFeatures(pane);
    serveChoosing(pane);
    PartView* view = &pane.view();
    view->setNavigation(scene::navigationScheme(preferences::navigation().toStdString()));
    view->scene().setLook(theme().scene, view->devicePixelRatioF());
    connect(view, &PartView::dragPreviewed, this, [this](const MoldState& state, scene::Grip grip) {
        m_bench.document().preview(draggedTo(m_bench.projectInView(), state, grip));
    });
    connect(view, &PartView::dragCommitted, this, [this](const MoldState& state, scene::Grip grip) {
        const QString words = grip == scene::Grip::Direction1   ? tr("Turn direction 1")
                              : grip == scene::Grip::Direction2 ? tr("Turn direction 2")
                                                                : tr("Move the plane");
        m_bench.document().edit(words, draggedTo(m_bench.projectInView(), state, grip));
    });
    connect(view, &PartView::dragCancelled, this, [this] { m_bench.document().endPreview(); });
    connect(view, &PartView::markClicked, this, [this](int chip) {
        if (const RefusedMesh* refused = m_bench.refused())
            return select(faultId(markedFaults(*refused, m_selected).at(static_cast<std::size_t>(chip))));
        const auto obstructions = static_cast<int>(m_bench.obstructions().size());
        const std::vector<int> undercuts = markedUndercuts(m_bench, m_selected);
        if (chip < obstructions)
            select(obstructionId(chip));
        else if (chip < obstructions + static_cast<int>(undercuts.size()))
            select(undercutId(undercuts[static_cast<std::size_t>(chip - obstructions)]));
    });
    connect(view, &PartView::menuRequested, this, &MainWindow::showViewMenu);
}

void MainWindow::showViewMenu(const QPoint& place) {
    QMenu menu;
    for (const QString& id : {u"fit"_s, u"fit-selection"_s, u"home"_s, u"along-normal"_s, u"show-plane"_s,
                              u"show-directions"_s, u"see-through"_s, u"lay-flat"_s, u"run"_s})
        menu.addAction(m_actions[id]);
    menu.exec(place);
}

void MainWindow::connectViewActions() {
    m_actions.on(u"fit"_s, [this] { m_view->fitAll(); });
    m_actions.on(u"fit-selection"_s,
                 [this] { m_tool == Tool::Paint ? m_view->sizeBrush() : fitSelection(); });
    m_actions.on(u"home"_s, [this] { m_view->lookHome(); });
    m_actions.on(u"front"_s, [this] { m_view->lookFrom(-Eigen::Vector3d::UnitY()); });
    m_actions.on(u"right"_s, [this] { m_view->lookFrom(Eigen::Vector3d::UnitX()); });
    m_actions.on(u"top"_s, [this] { m_view->lookFrom(Eigen::Vector3d::UnitZ()); });
    m_actions.on(u"opposite"_s, [this] { m_view->lookFromOpposite(); });
    m_actions.on(u"along-normal"_s, [this] { m_view->lookFrom(m_bench.project().state->plane.normal); });
    m_actions.on(u"perspective"_s,
                 [this] { m_view->setPerspective(m_actions[u"perspective"_s]->isChecked()); });
    for (const ViewLayout layout : layouts)
        m_actions.on(layoutCommand(layout), [this, layout] {
            m_bench.variants().compareWith({});
            m_views->setViewLayout(layout);
            refreshSoon();
        });
    m_actions.on(u"section"_s, [this] {
        ViewSettings settings = m_views->active().settings();
        settings.cut = m_actions[u"section"_s]->isChecked() ? std::optional(SectionCut()) : std::nullopt;
        m_views->setActiveSettings(settings);
    });
    m_actions.on(u"link-views"_s, [this] { m_views->setLinked(m_actions[u"link-views"_s]->isChecked()); });
    for (int mode = 0; mode < displayModeCount; ++mode)
        m_actions.on(displayModeCommand(static_cast<DisplayMode>(mode)),
                     [this, mode] { setMode(static_cast<DisplayMode>(mode)); });
    connectVisibility();
    m_actions.on(u"screenshot"_s, [this] { saveScreenshot(); });
    m_actions.on(u"turntable"_s, [this] { saveTurntable(); });
}

void MainWindow::connectVisibility() {
    m_actions.on(u"show-plane"_s, [this] {
        m_visible.plane = m_actions[u"show-plane"_s]->isChecked();
        refreshSoon();
    });
    m_actions.on(u"show-directions"_s, [this] {
        m_visible.directions = m_actions[u"show-directions"_s]->isChecked();
        refreshSoon();
    });
    const auto toggle = [this](const QString& id, bool ViewSettings::* look) {
        m_actions.on(id, [this, id, look] {
            ViewSettings settings = m_views->active().settings();
            settings.*look = m_actions[id]->isChecked();
            m_views->setActiveSettings(settings);
        });
    };
    toggle(u"show-edges"_s, &ViewSettings::edges);
    toggle(u"see-through"_s, &ViewSettings::seeThrough);
}

void MainWindow::setMode(DisplayMode mode) {
    ViewSettings settings = m_views->active().settings();
    settings.mode = mode;
    m_views->setActiveSettings(settings);
}

void MainWindow::refreshViewActions() {
    const ViewSettings& settings = m_views->active().settings();
    m_viewBar->setMode(settings.mode);
    m_viewBar->setModesEnabled(!m_bench.refused());
    for (int mode = 0; mode < displayModeCount; ++mode)
        m_actions[displayModeCommand(static_cast<DisplayMode>(mode))]->setChecked(
            settings.mode == static_cast<DisplayMode>(mode));
    m_actions[u"section"_s]->setChecked(settings.cut.has_value());
    m_actions[u"show-edges"_s]->setChecked(settings.edges);
    m_actions[u"see-through"_s]->setChecked(settings.seeThrough);
    m_actions[u"perspective"_s]->setChecked(m_view->camera().perspective);
    m_actions[u"show-plane"_s]->setChecked(m_visible.plane);
    m_actions[u"show-directions"_s]->setChecked(m_visible.directions);
    for (const ViewLayout layout : layouts)
        m_actions[layoutCommand(layout)]->setChecked(layout == m_views->viewLayout());
    QAction* link = m_actions[u"link-views"_s];
    link->setChecked(m_views->linked());
    link->setEnabled(link->isEnabled() && m_views->viewLayout() != ViewLayout::One);
}

void MainWindow::refreshViews() {
    m_opening->setVisible(moldShown());
    // Each takes its time on a large part: the active one comes at once, the others between events.
    m_oldViews.clear();
    for (ViewPane* pane : m_views->shown())
        if (pane != &m_views->active())
            m_oldViews.push_back(pane);
    m_oldViews.push_back(&m_views->active());
    refreshNextView();
}

void MainWindow::refreshNextView() {
    if (m_oldViews.empty())
        return;
    ViewPane* pane = m_oldViews.back();
    m_oldViews.pop_back();
    refreshView(*pane);
    if (!m_oldViews.empty()) {
        m_refreshViews.start();
        return;
    }
    const bool allDrawn = std::ranges::all_of(
        m_views->shown(), [](const ViewPane* shown) { return shown->view().scene().surface() != nullptr; });
    if (!allDrawn)
        return;
    const Fit fit = std::exchange(m_fitWhenDrawn, Fit::Not);
    if (fit == Fit::FromHome)
        m_views->lookAtAll();
    else if (fit == Fit::AsTheyLook)
        m_views->fitAll();
}

void MainWindow::refreshView(ViewPane& pane) {
    if (m_bench.refused())
        return showRefused(pane);
    const ViewSettings& settings = pane.settings();
    PartView& view = pane.view();
    scene::Scene& scene = view.scene();
    scene.setFaults({});
    scene.setTwoSided(false);
    const bool inMold = moldShown() && settings.content == ViewContent::Newest;
    const bool inPlan = planShown() && settings.content == ViewContent::Newest;
    view.setEditable(!inMold && !inPlan && !showsOther(pane) && m_bench.editable());
    const ShownSurface surface = m_bench.surface(settings.content);
    if (m_bench.shownMesh() && !surface.drawn)
        return; // the last picture stays until the next one can be drawn
    scene.setState(surface.drawn ? m_bench.stateIn(settings.content) : std::nullopt);
    const FaceMap* map = m_bench.map(settings.content, settings.mode);
    showSurface(view, surface, settings.mode, map);
    if (surface.picker)
        view.setPicker(surface.picker);
    const bool bySteel = settings.mode == DisplayMode::Steel;
    const ShownSteel* steel = inMold && bySteel ? m_steel->of(m_bench.mold()) : nullptr;
    showMold(scene, inMold, steel);
    scene.setEdges(settings.edges);
    scene.setSeeThrough(settings.seeThrough);
    scene.setSurfaceVisible(m_visible.shape);
    const bool onlyShape = inMold || m_modeBefore; // a brush in hand wants nothing before the part
    scene.setPlaneVisible(m_visible.plane && !onlyShape);
    scene.setDirectionsVisible(m_visible.directions && !onlyShape);
    showCut(pane);
    scene.setDirectionLimits(m_bench.project().design.limits, m_selected.startsWith(u"direction"_s));
    scene.setLegend(bySteel  ? steelLegend(steel, inMold)
                    : inMold ? contactLegend(m_bench.contacts())
                             : legendIn(settings.mode, m_bench, surface, map, m_visible));
    view.setBrushRadius(m_tool == Tool::Paint ? m_bench.brushRadius() : 0);
    scene.setStateChip(inMold ? moldChip(m_bench) : stateChipFor(m_bench, settings.content));
    scene.setChips(inMold          ? halfChips(scene)
                   : surface.drawn ? chipsIn(pane, map)
                                   : std::vector<scene::Chip>());
    const bool measured = surface.drawn && m_measure->measurement().isOf(surface.drawn->mesh);
    scene.setPath(measured ? m_measure->measurement().path() : m_planePoints);
    showGuides(pane, surface);
    scene.setPlan(inPlan ? planWithChosen(m_bench, m_selected) : scene::ShownPlan());
    view.redraw();
}

bool MainWindow::showsOther(const ViewPane& pane) const {
    return pane.settings().content == ViewContent::Compared && m_bench.variants().other();
}

void MainWindow::showGuides(ViewPane& pane, const ShownSurface& surface) {
    scene::Scene& scene = pane.view().scene();
    const bool onPart = !showsOther(pane) && surface.drawn && surface.drawn->mesh == m_bench.project().part;
    const bool onFrame = surface.drawn && m_bench.frame() && surface.drawn->mesh == m_bench.shownMesh();
    const bool suggested = onPart && m_visible.suggestedPins && pinsChosen(m_selected);
    scene.setPins((onPart || onFrame) && m_visible.pins ? shownPins(m_bench, m_selected, suggested, m_visible)
                                                        : scene::ShownPins());
    scene.setFilling(onPart ? shownFilling(m_bench, m_selected) : nullptr);
}

void MainWindow::showSurface(PartView& view, const ShownSurface& surface, DisplayMode mode,
                             const FaceMap* map) {
    scene::Scene& scene = view.scene();
    if (surface.drawn != scene.surface())
        scene.setSurface(surface.drawn, {});
    if (!surface.drawn)
        return;
    view.setCoarse(surface.coarse);
    view.setLive(m_bench.running() && !m_bench.resting());
    FacePaint paint = mode == DisplayMode::Importance ? importancePaint(m_bench, surface, m_visible)
                                                      : paintFor(surface, mode, map);
    if (!m_pointedAt.isEmpty())
        pointAt(paint, surface, m_pointedAt);
    scene.setFaceColours(paint.faces);
    scene.setStandInColours(paint.standIn);
}

void MainWindow::showPlace(const Eigen::AlignedBox3d& place) {
    m_view->frame(place);
    m_pointedAt = place;
    m_pointing.start();
    refreshSoon();
}

void MainWindow::showCut(ViewPane& pane) {
    ViewSettings settings = pane.settings();
    auto& cut = settings.cut;
    const std::optional<MoldState> state = m_bench.stateIn(settings.content);
    scene::Scene& scene = pane.view().scene();
    if (cut && cut->across == SectionCut::Across::View && !cut->normal && scene.surface()) {
        cut->normal = pane.view().camera().backwards();
        cut->offset = scene.middle().dot(*cut->normal);
        cut->flipped = false; // what is before the middle goes
        pane.setSettings(settings);
    }
    if (const auto plane = cut && !cut->flipped ? planeOf(*cut, state) : std::nullopt) {
        cut->flipped = plane->normal.dot(pane.view().camera().backwards()) < 0;
        pane.setSettings(settings);
    }
    scene.setCut(cut ? planeOf(*cut, state) : std::nullopt);
    if (!cut || !scene.surface() || !scene.cut())
        return;
    // Where the section lies is counted along the plane's own normal, whichever side stays.
    const PartingPlane from = *planeOf({cut->across, 0, false, cut->normal}, state);
    const Eigen::VectorXd along = (scene.surface()->bounds() * from.normal).array() - from.offset;
    pane.setCutRange(along.minCoeff(), along.maxCoeff());
}

void MainWindow::useLook() {
    const std::vector<ViewPane*>& shown = m_views->shown();
    for (const ViewPane* pane : m_views->made()) {
        PartView* view = &pane->view();
        const auto look = [view] {
            view->scene().setLook(theme().scene, view->devicePixelRatioF());
            // The halves' colours are the theme's.
            view->scene().setHalves(nullptr, nullptr, Eigen::Isometry3d::Identity(), {});
        };
        // What is out of sight comes later, one after the other: each takes its time.
        if (std::ranges::find(shown, pane) != shown.end())
            look();
        else
            QTimer::singleShot(0, view, look);
    }
}

} // namespace moldwright
