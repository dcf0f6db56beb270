// SPDX-License-Identifier: AGPL-3.0-or-later
// What each command and each panel of the window does.
#include "window/main_window.h"

#include "mesh/measures.h"
#include "panels/banner.h"
#include "panels/command_search.h"
#include "panels/dock_title.h"
#include "panels/key_sheet.h"
#include "panels/message_list.h"
#include "panels/plain_text.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "panels/start_page.h"
#include "panels/step_button.h"
#include "panels/workflow_bar.h"
#include "project/edits.h"
#include "theme/theme.h"
#include "view/part_view.h"
#include "window/importance_pages.h"
#include "window/material_pages.h"
#include "window/measure_tool.h"
#include "window/obstruction_words.h"
#include "window/opening_bar.h"
#include "window/pin_offers.h"
#include "window/pin_pages.h"
#include "window/preferences.h"
#include "window/preferences_dialog.h"
#include "window/preset_choice.h"
#include "window/property_pages.h"
#include "window/tour.h"
#include "window/turn_dialog.h"
#include "window/turntable.h"
#include "window/variant_pages.h"
#include "window/view_area.h"
#include "window/view_bar.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <QActionGroup>
#include <QApplication>
#include <QDesktopServices>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QStatusBar>
#include <QUrl>

#include <algorithm>
#include <array>
#include <chrono>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr std::chrono::milliseconds betweenThemes(20);

} // namespace

void MainWindow::connectActions() {
    connectFileActions();
    connectViewActions();
    connectToolActions();
    connectPartActions();
    connectPinActions();
    connectImportanceActions();
    connectVariantActions();
    connectDesignActions();
    connectWindowActions();
    connectRefusal();
    // The actions' own keys work wherever the focus is in the window, in menus or not.
    addActions(QList<QAction*>(m_actions.all().begin(), m_actions.all().end()));
}

void MainWindow::connectFileActions() {
    m_actions.on(u"open"_s, [this] { chooseFileToOpen(); });
    m_actions.on(u"start-page"_s, [this] {
        if (m_bench.refused())
            m_bench.leaveRefused();
        else
            leaving([this] { m_bench.closePart(); });
    });
    m_actions.on(u"save"_s, [this] { save(); });
    m_actions.on(u"save-as"_s, [this] { saveAs(); });
    m_actions.on(u"export-cast"_s, [this] { chooseFileToExport(); });
    m_actions.on(u"export-mold"_s, [this] { chooseFolderForMold(); });
    m_actions.on(u"quit"_s, [this] { close(); });
    m_actions.on(u"undo"_s, [this] { m_bench.document().undo(); });
    m_actions.on(u"redo"_s, [this] { m_bench.document().redo(); });
    m_actions.on(u"copy-measured"_s, [this] { m_measure->copy(); });
    m_actions.on(u"find-command"_s, [this] { m_search->setFocus(Qt::ShortcutFocusReason); });
}

void MainWindow::connectPartActions() {
    m_actions.on(u"turn-x"_s, [this] { m_bench.quarterTurnPart(Eigen::Vector3d::UnitX()); });
    m_actions.on(u"turn-y"_s, [this] { m_bench.quarterTurnPart(Eigen::Vector3d::UnitY()); });
    m_actions.on(u"turn-z"_s, [this] { m_bench.quarterTurnPart(Eigen::Vector3d::UnitZ()); });
    m_actions.on(u"turn-by"_s, [this] { askTurn(); });
    m_actions.on(u"centre"_s, [this] { m_bench.centrePart(); });
    m_actions.on(u"best-plane"_s, [this] { m_bench.findBestPlane(); });
    m_actions.on(u"next-plane"_s, [this] { m_bench.takeNextPlane(); });
    m_actions.on(u"suggested-plane"_s, [this] {
        m_banner->hide();
        select(u"plane"_s);
        m_bench.takeSuggestedPlane();
    });
    m_actions.on(u"best-directions"_s, [this] { m_bench.findBestDirections(); });
    m_actions.on(u"normal-directions"_s, [this] {
        const PartingPlane plane = m_bench.projectInView().state->plane;
        m_bench.setState({plane, Directions::normalTo(plane)}, tr("Directions along the normal"));
    });
}

void MainWindow::connectDesignActions() {
    m_actions.on(u"find-undercuts"_s, [this] { m_bench.findUndercuts(); });
    m_actions.on(u"fill-here"_s, [this] { m_bench.fillObstruction(obstructionNumber(m_selected)); });
    m_actions.on(u"run"_s, [this] {
        m_banner->hide();
        select(u"deform"_s);
        m_view->setFocus(); // the button goes while it runs
        m_progressDock->raise();
        m_bench.run();
    });
    m_actions.on(u"fill-and-run"_s, [this] {
        m_banner->hide();
        select(u"deform"_s);
        m_view->setFocus();
        m_bench.fillAndRun();
    });
    m_actions.on(u"finish"_s, [this] {
        m_view->setFocus();
        m_bench.finish();
    });
    m_actions.on(u"step-once"_s, [this] { m_bench.stepOnce(); });
    m_actions.on(u"earlier-frame"_s, [this] { showFrameBeside(-1); });
    m_actions.on(u"later-frame"_s, [this] { showFrameBeside(1); });
    m_actions.on(u"branch"_s, [this] {
        m_view->setFocus();
        m_bench.goOnFromHere();
    });
    m_actions.on(u"pause"_s, [this] { m_bench.resting() ? m_bench.goOn() : m_bench.rest(); });
    m_actions.on(u"stop"_s, [this] {
        m_view->setFocus();
        m_bench.stop();
    });
    m_actions.on(u"restore"_s, [this] {
        m_view->setFocus();
        m_bench.restoreShape();
    });
    connectFeatureActions();
    connectTrayActions();
    m_actions.on(u"build-mold"_s, [this] { m_bench.buildMoldNow(); });
    connectPresets(m_actions, m_bench, this);
    connectMaterials(m_actions, m_bench, this);
    m_actions.on(u"print-report"_s, [this] { chooseFileForReport(); });
    m_actions.on(u"open-mold"_s, [this] {
        select(u"mold"_s);
        m_opening->ease(m_opening->opening() > 0.5 ? 0 : 1);
    });
}

void MainWindow::connectWindowActions() {
    m_actions.on(u"theme-light"_s, [this] { useThemeChoice(ThemeChoice::Light); });
    m_actions.on(u"theme-dark"_s, [this] { useThemeChoice(ThemeChoice::Dark); });
    m_actions.on(u"theme-system"_s, [this] { useThemeChoice(ThemeChoice::System); });
    auto* themes = new QActionGroup(this);
    for (const QString& id : {u"theme-light"_s, u"theme-dark"_s, u"theme-system"_s})
        themes->addAction(m_actions[id]);
    const ThemeChoice choice = preferences::themeChoice();
    m_actions[choice == ThemeChoice::Light  ? u"theme-light"_s
              : choice == ThemeChoice::Dark ? u"theme-dark"_s
                                            : u"theme-system"_s]
        ->setChecked(true);
    const std::array steps = {u"step-part"_s,  u"step-plane"_s, u"step-guides"_s, u"step-deform"_s,
                              u"step-check"_s, u"step-mold"_s,  u"step-report"_s};
    for (int step = 0; step < stepCount; ++step)
        m_actions.on(steps[static_cast<std::size_t>(step)], [this, step] { chooseStep(step); });
    m_actions.on(u"next-zone"_s, [this] { walkZones(1); });
    m_actions.on(u"previous-zone"_s, [this] { walkZones(-1); });
    m_actions.on(u"reset-layout"_s, [this] {
        for (Dock* dock : m_docks)
            dock->toggleViewAction()->setProperty("wanted", true);
        restoreState(m_firstLayout, layoutVersion);
        refreshSoon();
    });
    m_actions.on(u"keys"_s, [this] { showKeys(); });
    m_actions.on(u"preferences"_s, [this] { showPreferences(); });
    m_actions.on(u"tour"_s, [this] { startTour(); });
    m_actions.on(u"about"_s, [this] { showAbout(); });
    auto* leave = new QShortcut(QKeySequence(Qt::Key_Escape), this);
    connect(leave, &QShortcut::activated, this, &MainWindow::escape);
}

void MainWindow::connectBench() {
    connect(&m_bench, &Workbench::changed, this, &MainWindow::refreshSoon);
    connect(&m_bench, &Workbench::partOpened, this, [this] {
        m_banner->hide();
        m_beforeRefusal.reset();
        select(u"part"_s);
        for (const ViewPane* pane : m_views->made())
            pane->view().scene().setSurface(nullptr, {});
        m_fitWhenDrawn = Fit::FromHome;
        refresh();
        m_view->setFocus();
        tellOfLost();
    });
    connect(&m_bench, &Workbench::unitAsked, this, &MainWindow::askUnit);
    connect(&m_bench, &Workbench::problem, this, [this](const QString& headline, const QString& text) {
        m_banner->showMessage(Standing::Failing, headline, text);
    });
    connect(&m_bench, &Workbench::advised, this, &MainWindow::advise);
    connect(m_banner, &Banner::actionChosen, this, [this](int action) {
        m_banner->setVisible(m_bench.refused()); // it stays as long as what it tells of
        m_actions[m_remedies.at(action)]->trigger();
    });
    connect(&m_bench, &Workbench::obstructed, this, [this] { select(obstructionId(0)); });
    connect(&m_bench, &Workbench::planesFound, this, [this] { select(u"plane"_s); });
    connect(&m_bench.pinOffers(), &PinOffers::found, this, [this] {
        if (!pinsChosen(m_selected))
            select(u"pins"_s);
    });
    connect(&m_bench, &Workbench::undercutsFound, this, [this] { select(u"undercuts"_s); });
    connect(&m_bench, &Workbench::saved, this,
            [this] { m_savedLabel->setText(tr("Saved %1").arg(QTime::currentTime().toString(u"HH:mm"_s))); });
    connect(&m_bench, &Workbench::reportWritten, this,
            [](const QString& file) { QDesktopServices::openUrl(QUrl::fromLocalFile(file)); });
    connect(&m_bench, &Workbench::moldBuilt, this, [this] {
        select(u"mold"_s);
        refresh();
        showMoldOpen();
        m_steelDock->raise();
    });
}

void MainWindow::advise(const Advice& advice) {
    m_remedies.clear();
    QStringList words;
    for (const QString& action : {advice.action, advice.otherAction})
        if (!action.isEmpty()) {
            m_remedies << action;
            words << plainText(m_actions[action]->text());
        }
    m_banner->showMessage(advice.standing, advice.headline, advice.text, words);
}

void MainWindow::connectPanels() {
    connect(m_workflow, &WorkflowBar::stepChosen, this, &MainWindow::chooseStep);
    connect(m_workflow, &WorkflowBar::verdictClicked, this, [this] { m_view->fitAll(); });
    connect(m_properties, &PropertyPanel::previewed, this, [this](const QString& id, const QVariant& value) {
        applyProperty(m_bench, m_properties->pageId(), id, value, true);
    });
    connect(m_properties, &PropertyPanel::committed, this, [this](const QString& id, const QVariant& value) {
        if (id == allVariantsId())
            return select(variantId(value.toInt()));
        applyProperty(m_bench, m_properties->pageId(), id, value, false);
    });
    connect(m_messages, &MessageList::showMe, this, &MainWindow::showPlace);
    connect(m_history, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0 && m_bench.editable())
            m_bench.document().goTo(static_cast<std::size_t>(row));
    });
}

void MainWindow::showFrameBeside(int way) {
    const int newest = static_cast<int>(m_bench.keptFrames().size()) - 1;
    m_bench.showKept(std::clamp(m_bench.frameInView() + way, 0, newest));
}

void MainWindow::askTurn() {
    const Project& project = m_bench.document().committed();
    auto* dialog =
        new TurnDialog(project.state ? std::optional(project.state->plane.normal) : std::nullopt, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &TurnDialog::previewed, this,
            [this, dialog] { m_bench.turnPart(dialog->axis(), dialog->degrees(), true); });
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { m_bench.turnPart(dialog->axis(), dialog->degrees(), false); });
    connect(dialog, &QDialog::rejected, this, [this] { m_bench.document().endPreview(); });
    // Beside the part, which is to be seen while it turns.
    dialog->adjustSize();
    dialog->move(m_view->mapToGlobal(m_view->rect().bottomRight()) -
                 QPoint(dialog->width() + 16, dialog->height() + 48));
    dialog->open();
}

void MainWindow::showKeys() {
    auto* sheet =
        new KeySheet(m_actions.all(), scene::navigationScheme(preferences::navigation().toStdString()), this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->open();
}

void MainWindow::showPreferences() {
    auto* dialog = new PreferencesDialog(m_actions, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PreferencesDialog::themeChosen, this, [this](ThemeChoice choice) {
        m_actions[choice == ThemeChoice::Light  ? u"theme-light"_s
                  : choice == ThemeChoice::Dark ? u"theme-dark"_s
                                                : u"theme-system"_s]
            ->setChecked(true);
        useThemeChoice(choice);
    });
    connect(dialog, &PreferencesDialog::languageChosen, this, &MainWindow::languageChosen);
    connect(dialog, &PreferencesDialog::navigationChosen, this, &MainWindow::useNavigation);
    dialog->show();
}

void MainWindow::showAbout() {
    QMessageBox box(this);
    box.setWindowTitle(tr("About Moldwright"));
    box.setIconPixmap(themeIcon(u"moldwright"_s).pixmap(48, 48));
    box.setText(u"<b>Moldwright %1</b>"_s.arg(QApplication::applicationVersion()));
    box.setInformativeText(
        tr("Takes any closed mesh to a castable shape and a proved two-piece mold, after Stein et al. 2019. "
           "Free software under the GNU AGPL 3 or later. Built on Qt, VTK, CGAL, OpenMesh, Eigen, TetGen and "
           "oneTBB."));
    box.addButton(tr("Close"), QMessageBox::RejectRole);
    box.exec();
}

void MainWindow::walkZones(int way) {
    QList<QWidget*> zones = {m_workflow->step(0), m_tree};
    for (const ViewPane* pane : m_views->shown())
        zones << &pane->view();
    zones << m_properties << m_messages << m_start;
    QList<QWidget*> seen;
    for (QWidget* zone : zones)
        if (zone->isVisible())
            seen << zone;
    if (seen.isEmpty())
        return;
    qsizetype at = way > 0 ? -1 : seen.size();
    for (qsizetype i = 0; i < seen.size(); ++i)
        if (QWidget* focus = QApplication::focusWidget();
            focus && (seen[i] == focus || seen[i]->isAncestorOf(focus)))
            at = i;
    QWidget* next = seen[(at + way + seen.size()) % seen.size()];
    next->setFocus(Qt::TabFocusReason);
    if (!next->hasFocus())
        for (QWidget* child : next->findChildren<QWidget*>())
            if (child->focusPolicy() != Qt::NoFocus && child->isVisible()) {
                child->setFocus(Qt::TabFocusReason);
                break;
            }
}

void MainWindow::useThemeChoice(ThemeChoice choice) {
    preferences::setThemeChoice(choice);
    useTheme(choice);
    // Both at once would be felt: the window hears and paints in between.
    QTimer::singleShot(betweenThemes, this, &MainWindow::applyTheme);
}

void MainWindow::escape() {
    if (m_turntable) {
        m_turntable->end();
        return;
    }
    for (const ViewPane* pane : m_views->shown())
        if (pane->view().cancelDrag())
            return;
    if (m_bench.refused())
        m_bench.leaveRefused();
    else if (m_tool == Tool::None && m_tour)
        Q_EMIT m_tour->ended();
    else if (m_tool == Tool::None)
        endComparison();
    useTool(Tool::None);
}

} // namespace moldwright
