// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/main_window.h"

#include "panels/banner.h"
#include "panels/dock_title.h"
#include "panels/frame_slider.h"
#include "panels/message_list.h"
#include "panels/progress_plots.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "panels/start_page.h"
#include "panels/step_button.h"
#include "panels/workflow_bar.h"
#include "project/edits.h"
#include "project/variants.h"
#include "theme/theme.h"
#include "view/part_view.h"
#include "window/chosen_features.h"
#include "window/importance_pages.h"
#include "window/measure_tool.h"
#include "window/mold_feature_pages.h"
#include "window/mold_placing.h"
#include "window/obstruction_words.h"
#include "window/paint_tool.h"
#include "window/pin_offers.h"
#include "window/pin_pages.h"
#include "window/preferences.h"
#include "window/property_pages.h"
#include "window/recovery.h"
#include "window/refusal_pages.h"
#include "window/refused_mesh.h"
#include "window/row_places.h"
#include "window/row_steps.h"
#include "window/selection.h"
#include "window/tour.h"
#include "window/tray_pages.h"
#include "window/undercut_pages.h"
#include "window/variant_pages.h"
#include "window/workbench.h"

#include <QDialog>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QStackedWidget>

#include <algorithm>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int historyRow = 24; ///< px
constexpr int pointingMilliseconds = 1500;

} // namespace

MainWindow::MainWindow(Workbench& bench, Recovery& recovery, QWidget* parent)
    : QMainWindow(parent), m_bench(bench), m_recovery(recovery), m_actions(this) {
    setWindowIcon(themeIcon(u"moldwright"_s));
    setMinimumSize(1024, 700);
    setAcceptDrops(true);
    setAnimated(false);
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(0);
    connect(&m_refresh, &QTimer::timeout, this, &MainWindow::refresh);
    m_pointing.setSingleShot(true);
    m_pointing.setInterval(pointingMilliseconds);
    connect(&m_pointing, &QTimer::timeout, this, [this] {
        m_pointedAt.setEmpty();
        refreshSoon();
    });
    m_refreshViews.setSingleShot(true);
    m_refreshViews.setInterval(0);
    connect(&m_refreshViews, &QTimer::timeout, this, &MainWindow::refreshNextView);
    buildMenus();
    buildWorkflow();
    buildCentre();
    buildDocks();
    buildStatusBar();
    connectActions();
    connectBench();
    connectPanels();
    connectTree();
    connectStart();
    restoreLayout();
    applyTheme();
    m_centre->currentWidget()->setFocus();
}

MainWindow::~MainWindow() {
    // Dialogs know the commands, and lose the keyboard as they go: they go while the commands are there.
    qDeleteAll(findChildren<QDialog*>(Qt::FindDirectChildrenOnly));
}

void MainWindow::applyTheme() {
    const Theme& t = theme();
    useLook();
    QPalette panel = t.palette;
    panel.setColor(QPalette::Window, t.panel);
    m_properties->setPalette(panel);
    QPalette bar = t.palette;
    bar.setColor(QPalette::Window, t.panel);
    bar.setColor(QPalette::Button, t.panel);
    m_workflow->setPalette(bar);
    m_workflow->setAutoFillBackground(true);
    refreshProperties(true);
    refresh();
}

void MainWindow::refresh() {
    const bool open = m_bench.project().part || m_bench.refused();
    m_centre->setCurrentIndex(open ? 1 : 0);
    for (Dock* dock : m_docks)
        dock->setVisible(open && dock->toggleViewAction()->property("wanted").toBool());
    if (open && !m_docksPlaced && isVisible()) {
        m_docksPlaced = true;
        QTimer::singleShot(0, this, &MainWindow::placeDocks); // sizes hold only once the docks are seen
    }
    for (Dock* dock : m_docks)
        dock->setTitleShown(dock->isFloating() || tabifiedDockWidgets(dock).isEmpty());
    if (!open)
        showStart();
    m_workflow->setStepsEnabled(open && !m_bench.refused());
    const Verdict verdict = verdictOf(m_bench);
    m_workflow->verdict()->setVerdict(verdict.standing, verdict.sentence, verdict.reason);
    const auto states = stepStates(m_bench);
    for (int step = 0; step < stepCount; ++step)
        m_workflow->setStanding(step, states[step].standing, states[step].words);
    m_projectModel->setRows(projectRows(m_bench, m_visible));
    select(stillThere(m_selected, m_bench));
    m_bench.placing().setWanted(stepOf(m_selected) == Step::Mold);
    m_paint->setRegion(regionNumber(m_selected));
    m_tree->select(chosenIds(m_selected));
    m_plots->setRequiredDraft(m_bench.project().design.draftDegrees);
    if (m_bench.progress().size() < m_plots->points().size())
        m_plots->clear();
    while (m_plots->points().size() < m_bench.progress().size())
        m_plots->add(m_bench.progress()[m_plots->points().size()]);
    std::vector<int> steps;
    for (const DesignFrame& frame : m_bench.keptFrames())
        steps.push_back(frame.step);
    m_frames->setSteps(steps, m_bench.frameInView());
    m_frames->setEnabled(m_bench.editable());
    m_plots->setMarked(m_bench.goneBack() && m_bench.frame() ? m_bench.frame()->frame.step : 0);
    followComparison();
    refreshViews();
    refreshHistory();
    refreshSteel();
    refreshActions();
    refreshTitle();
    refreshHint();
    refreshProperties();
    if (m_tour)
        m_tour->follow();
}

void MainWindow::refreshHistory() {
    const History& history = m_bench.document().history();
    const QSignalBlocker quiet(m_history);
    m_history->clear();
    m_history->addItem(m_bench.project().part ? tr("Opened") : QString());
    for (const History::Step& step : history.steps())
        m_history->addItem(step.words);
    for (int row = static_cast<int>(history.done()) + 1; row < m_history->count(); ++row)
        m_history->item(row)->setForeground(theme().palette.color(QPalette::Disabled, QPalette::Text));
    for (int row = 0; row < m_history->count(); ++row)
        m_history->item(row)->setSizeHint({0, historyRow});
    m_history->setCurrentRow(static_cast<int>(history.done()));
}

std::set<Needs> MainWindow::given() const {
    const Project& project = m_bench.project();
    const bool idle = !m_bench.background().busy();
    const bool part = project.part && !m_bench.refused();
    const bool plane = part && m_bench.shownState().has_value();
    const bool editable = m_bench.editable();
    const History& history = m_bench.document().history();
    std::set<Needs> given = {Needs::Nothing};
    const auto add = [&](Needs needs, bool so) {
        if (so)
            given.insert(needs);
    };
    add(Needs::Idle, idle);
    add(Needs::Part, part);
    add(Needs::IdlePart, part && idle);
    add(Needs::InView, part || m_bench.refused());
    add(Needs::IdleInView, idle && (part || m_bench.refused()));
    add(Needs::Refused, idle && m_bench.refused());
    add(Needs::FaultPlace, m_bench.refused() && listedFaults(*m_bench.refused()) > 0);
    add(Needs::Plane, plane);
    add(Needs::IdlePlane, plane && idle);
    add(Needs::EditablePart, part && editable);
    add(Needs::EditablePlane, plane && editable);
    add(Needs::SuggestedPlane, idle && m_bench.suggestedPlane().has_value());
    add(Needs::SuggestedPins, editable && !m_bench.pinOffers().inView().empty());
    add(Needs::SuggestedTips,
        editable && std::ranges::count(m_bench.pinOffers().inView(), PinKind::Tip, &SuggestedPin::kind) > 0);
    add(Needs::Pins, editable && !project.pins.empty());
    const bool variant = idle && variantNumber(m_selected) >= 0;
    const bool furtherPart = idle && trayNumber(m_selected) > 0;
    add(Needs::FurtherPart, furtherPart);
    add(Needs::ChosenGuide,
        variant || furtherPart ||
            (editable && !(pinNumbers(m_selected).empty() && regionNumbers(m_selected).empty())));
    add(Needs::Comparable, !project.others.empty());
    add(Needs::Variants, idle && !project.others.empty());
    add(Needs::OtherVariant, variant && variantNumber(m_selected) != static_cast<int>(project.place));
    add(Needs::Regions, idle && !project.importance.empty());
    add(Needs::FillableObstruction, idle && !m_bench.placesToFill(obstructionNumber(m_selected)).empty());
    add(Needs::CastShape, idle && project.cast != nullptr);
    add(Needs::ProvedCast, idle && m_bench.castIsProved());
    add(Needs::MoldBuilt, idle && m_bench.moldIsCurrent());
    add(Needs::AnyByHand, idle && !project.mold.placed.empty());
    add(Needs::ChosenByHand,
        idle && std::ranges::any_of(featuresOf(m_selected), [&](const FeatureName& feature) {
            return placeByHand(project.mold.placed, feature.kind, feature.number).has_value();
        }));
    add(Needs::Running, m_bench.running());
    add(Needs::Bending, m_bench.bending());
    const int frame = m_bench.frameInView();
    add(Needs::Resting, m_bench.resting());
    add(Needs::EarlierFrame, editable && frame > 0);
    add(Needs::LaterFrame, editable && frame + 1 < static_cast<int>(m_bench.keptFrames().size()));
    add(Needs::Branch, editable && m_bench.frame() && m_bench.frame()->frame.partPoints);
    add(Needs::Measured, !m_measure->measurement().empty());
    const ProjectRow* row = rowOf(rowMeant());
    add(Needs::Renamable, idle && row && row->renamable);
    const ProjectRow* last = rowOf(chosenIds(rowMeant()).back());
    add(Needs::Hideable, last && last->visible);
    add(Needs::LostWork, idle && !m_recovery.found().empty() && m_recovery.found().front().project);
    add(Needs::Undo, editable && history.canUndo());
    add(Needs::Redo, editable && history.canRedo());
    return given;
}

void MainWindow::refreshActions() {
    const std::set<Needs> holds = given();
    m_actions.update([&](Needs needs) { return holds.contains(needs); });
    m_actions[u"run"_s]->setVisible(!m_bench.running());
    for (const QString& id : {u"finish"_s, u"pause"_s, u"step-once"_s, u"stop"_s})
        m_actions[id]->setVisible(m_bench.running());
    QAction* pause = m_actions[u"pause"_s];
    if (const QString words = m_bench.resting() ? tr("&Go on") : tr("&Pause"); pause->text() != words) {
        pause->setText(words);
        pause->setIcon(themeIcon(m_bench.resting() ? u"play"_s : u"pause"_s));
    }
    refreshViewActions();
}

void MainWindow::refreshTitle() {
    const Project& project = m_bench.project();
    if (m_bench.refused()) {
        setWindowTitle(tr("%1 · Moldwright").arg(m_bench.refused()->name));
        return;
    }
    if (!project.part) {
        setWindowTitle(tr("Moldwright"));
        return;
    }
    const QString name = QString::fromStdString(project.name);
    setWindowTitle(m_bench.document().isChanged() ? tr("%1 (changed) · Moldwright").arg(name)
                                                  : tr("%1 · Moldwright").arg(name));
}

void MainWindow::refreshHint() {
    if (m_turntable)
        return; // it tells how far it is
    const QString keys = tr("<b>?</b> shows all keys.");
    if (m_bench.refused())
        m_hint->setText(
            tr("<b>F3</b> goes from place to place, <b>Ctrl+R</b> repairs the mesh, <b>F5</b> reads the "
               "file again, <b>Esc</b> goes back to what was open. %1")
                .arg(keys));
    else if (!m_bench.project().part)
        m_hint->setText(tr("Open a part, drop one here, or choose a sample. %1").arg(keys));
    else if (m_tool != Tool::None)
        m_hint->setText(toolHint());
    else if (m_bench.resting())
        m_hint->setText(
            tr("The shape rests. <b>Space</b> bends it further, <b>Ctrl+Shift+Return</b> finishes it."));
    else if (m_bench.running())
        m_hint->setText(tr("The part bends; plane, pins and draft may change meanwhile. <b>Space</b> holds "
                           "it, <b>Ctrl+.</b> stops "
                           "it."));
    else if (pinsChosen(m_selected))
        m_hint->setText(tr("<b>Click</b> a pin to choose it, with <b>Ctrl</b> several, or draw a box; "
                           "<b>Del</b> removes them; <b>P</b> pins another point. %1")
                            .arg(keys));
    else if (regionsChosen(m_selected))
        m_hint->setText(
            tr("<b>B</b> takes the brush; <b>F2</b> renames the region, <b>Del</b> removes it. %1")
                .arg(keys));
    else if (variantsChosen(m_selected))
        m_hint->setText(tr("<b>Return</b> makes the chosen variant the current one, <b>Ctrl+D</b> duplicates "
                           "it, <b>F2</b> renames it, <b>Del</b> removes it. %1")
                            .arg(keys));
    else if (planShown())
        m_hint->setText(
            tr("<b>Drag</b> a disc to place a feature of the mold, with <b>Shift</b> without steps. "
               "%1")
                .arg(keys));
    else if (moldShown())
        m_hint->setText(tr("<b>X</b> opens and closes the mold. %1").arg(keys));
    else
        m_hint->setText(
            tr("<b>Drag</b> a grip of the plane or the tip of an arrow, with <b>Ctrl</b> in whole steps. %1")
                .arg(keys));
}

void MainWindow::refreshProperties(bool evenIfSame) {
    if (!m_bench.project().part && !m_bench.refused())
        return;
    m_properties->showPage(propertyPage(m_selected, m_bench, m_actions), evenIfSame);
    fillPage(*m_properties, m_bench);
    m_bench.variants().setWanted(variantsChosen(m_selected));
    fillVariantPage(*m_properties, m_selected, m_bench);
}

void MainWindow::select(const QString& id) {
    if (id == m_selected)
        return;
    m_selected = id;
    m_tree->select(chosenIds(id));
    if (obstructionNumber(id) >= 0 || undercutNumber(id) >= 0 || faultNumber(id) >= 0)
        fitSelection();
    m_workflow->setCurrentStep(static_cast<int>(stepOf(id)));
    refreshSoon();
}

void MainWindow::fitSelection() {
    Eigen::AlignedBox3d place;
    for (const QString& id : chosenIds(m_selected))
        place.extend(placeOfRow(id, m_bench));
    place.isEmpty() ? m_view->fitAll() : m_view->frame(place);
}

void MainWindow::chooseStep(int step) {
    switch (static_cast<Step>(step)) {
    case Step::Part:
        select(u"part"_s);
        break;
    case Step::Plane:
        select(u"plane"_s);
        break;
    case Step::Guides:
        select(u"pins"_s);
        break;
    case Step::Deform:
        select(u"deform"_s);
        break;
    case Step::Check:
        select(m_bench.project().cast ? u"cast"_s : u"deform"_s);
        break;
    case Step::Mold:
        select(u"mold"_s);
        break;
    case Step::Report:
        m_actions[u"print-report"_s]->trigger();
        break;
    }
}

} // namespace moldwright
