// SPDX-License-Identifier: AGPL-3.0-or-later
// What the window is made of, and where it lies.
#include "window/main_window.h"

#include "panels/banner.h"
#include "panels/command_search.h"
#include "panels/dock_title.h"
#include "panels/frame_slider.h"
#include "panels/message_list.h"
#include "panels/progress_plots.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "panels/start_page.h"
#include "panels/steel_table.h"
#include "panels/workflow_bar.h"
#include "scene/navigation.h"
#include "view/part_view.h"
#include "window/languages.h"
#include "window/opening_bar.h"
#include "window/preferences.h"
#include "window/samples.h"
#include "window/status_progress.h"
#include "window/view_area.h"
#include "window/view_bar.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <QActionGroup>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>

namespace moldwright {

using namespace Qt::StringLiterals;

void MainWindow::buildMenus() {
    std::map<QString, QMenu*> menus;
    std::size_t i = 0;
    for (const ActionSpec& spec : actionTable()) {
        QAction* action = m_actions.all()[i++];
        const QString title = action->property("menu").toString();
        QMenu*& menu = menus[title];
        if (!menu) {
            menu = menuBar()->addMenu(title);
            menu->setObjectName(QStringLiteral("menu-") + QString::fromLatin1(spec.menu).remove(u'&'));
        }
        if (spec.separatorBefore)
            menu->addSeparator();
        menu->addAction(action);
    }
    auto* window = menuBar()->findChild<QMenu*>(u"menu-Window"_s);
    auto* help = menuBar()->findChild<QMenu*>(u"menu-Help"_s);
    window->addSeparator();
    m_dockMenu = window->addMenu(tr("&Panels"));
    buildLanguageMenu(window->addMenu(tr("Lan&guage")));
    buildNavigationMenu(help->addMenu(tr("Mouse &navigation")));
    m_search = new CommandSearch(this);
    m_search->setCommands(m_actions.all());
    m_search->setOwnCommand(m_actions[u"find-command"_s]);
    auto* corner = new QWidget(menuBar());
    auto* row = new QHBoxLayout(corner);
    row->setContentsMargins(0, 3, 6, 3);
    row->addWidget(m_search);
    menuBar()->setCornerWidget(corner);
}

void MainWindow::buildLanguageMenu(QMenu* menu) {
    auto* group = new QActionGroup(menu);
    std::vector<Language> choices = languages();
    choices.insert(choices.begin(), {QString(), tr("Like the desktop")});
    for (const auto& [code, name] : choices) {
        QAction* action = menu->addAction(name);
        action->setCheckable(true);
        action->setChecked(code == preferences::language());
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, code = code] { Q_EMIT languageChosen(code); });
    }
}

void MainWindow::buildNavigationMenu(QMenu* menu) {
    auto* group = new QActionGroup(menu);
    const std::string current = scene::navigationScheme(preferences::navigation().toStdString()).id;
    for (const scene::NavigationScheme& scheme : scene::navigationSchemes()) {
        QAction* action = menu->addAction(QString::fromStdString(scheme.name));
        action->setCheckable(true);
        action->setChecked(scheme.id == current);
        group->addAction(action);
        action->setObjectName(u"navigation-"_s + QString::fromStdString(scheme.id));
        connect(action, &QAction::triggered, this,
                [this, &scheme] { useNavigation(QString::fromStdString(scheme.id)); });
    }
}

void MainWindow::useNavigation(const QString& id) {
    const scene::NavigationScheme& scheme = scene::navigationScheme(id.toStdString());
    preferences::setNavigation(id);
    for (const ViewPane* pane : m_views->made())
        pane->view().setNavigation(scheme);
    m_navigationLabel->setText(tr("Navigation: %1").arg(QString::fromStdString(scheme.name)));
    if (auto* action = menuBar()->findChild<QAction*>(u"navigation-"_s + id))
        action->setChecked(true);
}

void MainWindow::buildWorkflow() {
    m_workflow = new WorkflowBar({{u"part"_s, tr("Part")},
                                  {u"plane"_s, tr("Plane")},
                                  {u"guides"_s, tr("Guides")},
                                  {u"deform"_s, tr("Deform")},
                                  {u"check"_s, tr("Check")},
                                  {u"mold"_s, tr("Mold")},
                                  {u"report"_s, tr("Report")}},
                                 this);
    addToolBar(Qt::TopToolBarArea, m_workflow);
    m_workflow->setCurrentStep(0);
}

void MainWindow::buildCentre() {
    auto* centre = new QWidget(this);
    auto* rows = new QVBoxLayout(centre);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    m_banner = new Banner(centre);
    rows->addWidget(m_banner);
    m_centre = new QStackedWidget(centre);
    rows->addWidget(m_centre, 1);
    m_start = new StartPage(m_actions[u"open"_s], m_actions[u"tour"_s], bundledSamples(), m_centre);
    m_centre->addWidget(m_start);
    auto* work = new QWidget(m_centre);
    auto* column = new QVBoxLayout(work);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_viewBar = new ViewBar(m_actions, work);
    column->addWidget(m_viewBar);
    m_opening = new OpeningBar(work);
    column->addWidget(m_opening);
    buildViews(work);
    column->addWidget(m_views, 1);
    m_centre->addWidget(work);
    setCentralWidget(centre);
}

void MainWindow::buildDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setDockOptions(AllowTabbedDocks | AllowNestedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);

    m_projectModel = new ProjectModel(this);
    m_tree = new ProjectTree(m_projectModel, this);
    m_tree->setMinimumWidth(256);
    m_properties = new PropertyPanel(this);
    m_plots = new ProgressPlots(this);
    auto* course = new QWidget(this);
    auto* courseColumn = new QVBoxLayout(course);
    courseColumn->setContentsMargins(0, 0, 0, 0);
    courseColumn->setSpacing(0);
    m_frames = new FrameSlider(course);
    courseColumn->addWidget(m_plots, 1);
    courseColumn->addWidget(m_frames);
    connect(m_frames, &FrameSlider::chosen, &m_bench, &Workbench::showKept);
    m_messages = new MessageList(m_bench.messages(), this);
    m_history = new QListWidget(this);
    m_history->setFrameShape(QFrame::NoFrame);
    m_history->setObjectName(u"history"_s);
    m_history->setAccessibleName(tr("History"));
    m_history->setToolTip(tr("Every edit appears here. Click one to go back to it."));

    m_steelTable = new SteelTable(this);
    connect(m_steelTable, &SteelTable::showMe, this, &MainWindow::showSteel);

    auto* project = new Dock(u"dock-project"_s, tr("Project"), m_tree, this);
    auto* properties = new Dock(u"dock-properties"_s, tr("Properties"), m_properties, this);
    Dock* progress = m_progressDock = new Dock(u"dock-progress"_s, tr("Progress"), course, this);
    auto* messages = new Dock(u"dock-messages"_s, tr("Messages"), m_messages, this);
    auto* history = new Dock(u"dock-history"_s, tr("History"), m_history, this);
    Dock* steel = m_steelDock = new Dock(u"dock-steel"_s, tr("Steel between features"), m_steelTable, this);
    addDockWidget(Qt::LeftDockWidgetArea, project);
    addDockWidget(Qt::RightDockWidgetArea, properties);
    addDockWidget(Qt::BottomDockWidgetArea, progress);
    splitDockWidget(progress, messages, Qt::Horizontal);
    tabifyDockWidget(progress, steel);
    tabifyDockWidget(steel, history);
    progress->raise();
    m_docks = {project, properties, progress, messages, history, steel};
    for (Dock* dock : m_docks) {
        QAction* toggle = dock->toggleViewAction();
        toggle->setProperty("wanted", true);
        m_dockMenu->addAction(toggle);
        connect(toggle, &QAction::triggered, this, [toggle](bool on) { toggle->setProperty("wanted", on); });
        connect(dock, &QDockWidget::topLevelChanged, this, &MainWindow::refreshSoon);
        connect(dock, &QDockWidget::dockLocationChanged, this, &MainWindow::refreshSoon);
        connect(dock, &Dock::closed, this, [toggle] { toggle->setProperty("wanted", false); });
    }
}

void MainWindow::placeDocks() {
    Dock* project = m_docks[0];
    Dock* properties = m_docks[1];
    Dock* progress = m_progressDock;
    Dock* messages = m_docks[3];
    resizeDocks({project, properties}, {260, 304}, Qt::Horizontal);
    resizeDocks({progress, messages}, {500, 380}, Qt::Horizontal);
    resizeDocks({progress}, {190}, Qt::Vertical);
    m_firstLayout = saveState(layoutVersion);
    restoreState(preferences::layout(u"docks"_s), layoutVersion);
}

void MainWindow::buildStatusBar() {
    statusBar()->setFixedHeight(26);
    statusBar()->setSizeGripEnabled(false);
    m_hint = new QLabel(this);
    m_hint->setContentsMargins(8, 0, 0, 0);
    statusBar()->addWidget(m_hint, 1);
    statusBar()->addPermanentWidget(new StatusProgress(m_bench.background(), this));
    const scene::NavigationScheme& scheme = scene::navigationScheme(preferences::navigation().toStdString());
    m_navigationLabel = new QLabel(tr("Navigation: %1").arg(QString::fromStdString(scheme.name)), this);
    m_savedLabel = new QLabel(this);
    m_savedLabel->setForegroundRole(QPalette::PlaceholderText);
    statusBar()->addPermanentWidget(m_savedLabel);
    m_navigationLabel->setForegroundRole(QPalette::PlaceholderText);
    statusBar()->addPermanentWidget(m_navigationLabel);
    auto* units = new QLabel(u"mm, °"_s, this);
    units->setForegroundRole(QPalette::PlaceholderText);
    units->setContentsMargins(8, 0, 8, 0);
    statusBar()->addPermanentWidget(units);
}

void MainWindow::restoreLayout() {
    resize(1440, 900);
    restoreGeometry(preferences::layout(u"geometry"_s));
}

} // namespace moldwright
