// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/placed_feature.h"
#include "mold/steel.h"
#include "scene/scene.h"
#include "theme/theme.h"
#include "window/action_table.h"
#include "window/presentation.h"

#include <QMainWindow>
#include <QTimer>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

class QActionGroup;
class QLabel;
class QListWidget;
class QStackedWidget;

namespace moldwright {

class Banner;
class CommandSearch;
class LiveSteel;
class MeasureTool;
class MessageList;
class PaintTool;
class PartView;
class FrameSlider;
class ProgressPlots;
class ProjectModel;
class ProjectTree;
class PropertyPanel;
class Recovery;
class StartPage;
class Tour;
class Turntable;
class ViewArea;
class Dock;
class OpeningBar;
class SteelTable;
class ViewBar;
class ViewPane;
class WorkflowBar;
class Workbench;
struct Advice;
struct FaceMap;
struct OpenedMesh;
struct ProjectRow;
struct ShownSteel;
struct ShownSurface;

enum class ViewLayout;

/// What a click on the part does.
enum class Tool {
    None,
    Measure,
    LayFlat,
    Pin,
    PinInside,
    AcceptLasso,
    PlaneOnFace,
    PlaneByPoints,
    Paint,
    PaintCrease,
    PaintPiece,
    PaintLasso
};

/// The window: shows the workbench and sends it what the user wants. It holds no data of its own but what is
/// hidden and selected, so that it can be built anew when the language changes.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    MainWindow(Workbench& bench, Recovery& recovery, QWidget* parent = nullptr);
    ~MainWindow() override;

    [[nodiscard]] Actions& actions() { return m_actions; }
    /// The active view.
    [[nodiscard]] PartView& view() { return *m_view; }
    [[nodiscard]] ViewArea& views() { return *m_views; }

    /// Remembers where window and panels are, for the next window.
    void keepLayout() const;

    /// Opens a project or a mesh, by its ending.
    void openPath(const QString& file);

Q_SIGNALS:
    void languageChosen(const QString& language);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // main_window_layout.cpp
    void buildMenus();
    void buildLanguageMenu(QMenu* menu);
    void buildNavigationMenu(QMenu* menu);
    void buildWorkflow();
    void buildCentre();
    void buildDocks();
    void buildStatusBar();
    void restoreLayout();
    void placeDocks();

    // main_window_actions.cpp
    void connectActions();
    void connectFileActions();
    void connectPartActions();
    void connectDesignActions();
    void connectWindowActions();
    void connectBench();
    void advise(const Advice& advice);
    void connectPanels();
    void askTurn();
    /// Shows the kept frame before (−1) or after (1) that in view.
    void showFrameBeside(int way);
    void showKeys();
    void showPreferences();
    void startTour();
    void useNavigation(const QString& id);
    void showAbout();
    void walkZones(int way);
    void useThemeChoice(ThemeChoice choice);
    void escape();

    // main_window_tools.cpp
    void connectToolActions();
    void connectPinActions();
    void useTool(Tool tool);
    [[nodiscard]] QString toolHint() const;
    void serveTools(ViewPane& pane);
    void servePins(ViewPane& pane);
    void takePlanePoint(const Eigen::Vector3d& point);
    void snapPlane(const PartingPlane& plane);

    // main_window_mold.cpp
    [[nodiscard]] bool moldShown() const;
    /// Shows the halves, or hides them; painted where the steel is given.
    void showMold(scene::Scene& scene, bool shown, const ShownSteel* steel);
    /// Whether the views show where the mold's features stand.
    [[nodiscard]] bool planShown() const;
    [[nodiscard]] const std::vector<ThinSteel>& steelInView() const;
    void refreshSteel();
    void showSteel(int row);
    /// Eases the mold open and looks at both parting faces.
    void showMoldOpen();
    /// The halves by their names, and the smallest steel, as the mold is open in a scene.
    [[nodiscard]] std::vector<scene::Chip> halfChips(const scene::Scene& scene) const;
    void serveFeatures(ViewPane& pane);
    void dragFeature(const PartView& view, const scene::FeatureAt& at, const scene::Ray& ray, bool exactly);
    void connectFeatureActions();

    // main_window_importance.cpp
    void connectImportanceActions();
    void usePaintTool();
    [[nodiscard]] QString paintHint() const;

    // main_window_variants.cpp
    void connectVariantActions();
    void compareVariants();
    void endComparison();
    void followComparison();
    void chooseVariantNow(int variant);

    // main_window_tray.cpp
    void connectTrayActions();
    void choosePartsForMold();

    // main_window_tree.cpp
    void connectTree();
    void showRowMenu(const QString& id, const QPoint& place);
    /// The row that a command is for; null where there is none.
    [[nodiscard]] const ProjectRow* rowOf(const QString& id) const;
    [[nodiscard]] QString rowMeant() const;

    // main_window_start.cpp
    void connectStart();
    void showStart();
    /// Says once that there is lost work, where the start page is not seen.
    void tellOfLost();
    void reopenLost(int which);

    // main_window_views.cpp
    void buildViews(QWidget* parent);
    void connectPane(ViewPane& pane);
    void connectViewActions();
    void connectVisibility();
    void showViewMenu(const QPoint& place);
    void setMode(DisplayMode mode);
    void refreshViewActions();
    void refreshViews();
    void refreshNextView();
    void refreshView(ViewPane& pane);
    void showGuides(ViewPane& pane, const ShownSurface& surface);
    void showSurface(PartView& view, const ShownSurface& surface, DisplayMode mode, const FaceMap* map);
    void showCut(ViewPane& pane);
    [[nodiscard]] std::vector<scene::Chip> chipsIn(const ViewPane& pane, const FaceMap* map) const;
    [[nodiscard]] std::vector<scene::Chip> directionChips(const ViewPane& pane) const;
    [[nodiscard]] std::vector<scene::Chip> guideChips(const ViewPane& pane) const;
    /// Whether a view shows another variant than the current one.
    [[nodiscard]] bool showsOther(const ViewPane& pane) const;
    /// Brings a place into sight and points at its faces for a moment.
    void showPlace(const Eigen::AlignedBox3d& place);
    void useLook();

    // main_window_refusal.cpp
    void connectRefusal();
    void enterRefusal();
    void leaveRefusal();
    void showNextFault();
    void showRefused(ViewPane& pane);

    // main_window_files.cpp
    void chooseFileToOpen();
    void chooseFileToExport();
    void chooseFolderForMold();
    void chooseFileForReport();
    void choosePinsToImport();
    void choosePinsToExport();
    void chooseWeightsToImport();
    void chooseWeightsToExport();
    void askUnit(const OpenedMesh& opened);
    void save(const std::function<void()>& then = {});
    void saveAs(const std::function<void()>& then = {});
    void saveTo(const QString& file, const std::function<void()>& then);
    void saveScreenshot();
    void saveTurntable();
    /// Does `then` once the open document may go: it is unchanged, saved now, or given up.
    void leaving(const std::function<void()>& then);
    /// Does `then` once no job runs; a running one is stopped.
    void whenIdle(const std::function<void()>& then);
    [[nodiscard]] QByteArray thumbnail();
    [[nodiscard]] QString fileToWrite(const QString& title, const QString& ending, const QString& kinds);

    // main_window.cpp
    void refreshSoon() { m_refresh.start(); }
    void refresh();
    void refreshHistory();
    /// What holds now, of what commands may need.
    [[nodiscard]] std::set<Needs> given() const;
    void refreshActions();
    void refreshTitle();
    void refreshHint();
    void refreshProperties(bool evenIfSame = false);
    void select(const QString& id);
    /// Clicked or boxed rows go into what is chosen.
    void choose(const QStringList& ids, Qt::KeyboardModifiers keys);
    void serveChoosing(ViewPane& pane);
    [[nodiscard]] bool regionsShown(const ViewPane& pane) const;
    void removeChosen();
    void fitSelection();
    void chooseStep(int step);
    void applyTheme();

    static constexpr int layoutVersion = 1; ///< of the docks; another one forgets what was kept

    Workbench& m_bench;
    Recovery& m_recovery;
    bool m_toldOfLost = false;
    Actions m_actions;
    QTimer m_refresh;
    QTimer m_refreshViews;
    std::vector<ViewPane*> m_oldViews; ///< that are still to be refreshed, the next one last
    Eigen::AlignedBox3d m_pointedAt;   ///< while m_pointing runs; else empty
    QTimer m_pointing;
    Visibility m_visible;
    QString m_selected = QStringLiteral("part");
    Tool m_tool = Tool::None;
    std::vector<Eigen::Vector3d> m_planePoints; ///< clicked so far, mm
    std::optional<bool> m_pinInside;            ///< whether the pin that is dragged lies inside the part
    std::optional<PlacedFeature> m_dragged;     ///< the mold's feature in hand, where it is dragged to
    Eigen::Vector2d m_dragOrigin = {0, 0};      ///< of its frame, mm in the mold's
    enum class Fit { Not, AsTheyLook, FromHome };
    Fit m_fitWhenDrawn = Fit::FromHome; ///< how the next surfaces are to be brought into sight

    WorkflowBar* m_workflow = nullptr;
    QStackedWidget* m_centre = nullptr;
    StartPage* m_start = nullptr;
    Banner* m_banner = nullptr;
    ViewBar* m_viewBar = nullptr;
    OpeningBar* m_opening = nullptr;
    SteelTable* m_steelTable = nullptr;
    Dock* m_progressDock = nullptr;
    Dock* m_steelDock = nullptr;
    ViewArea* m_views = nullptr;
    PartView* m_view = nullptr;  ///< the active one
    ViewLayout m_layoutBefore{}; ///< of the views, while variants are compared
    MeasureTool* m_measure = nullptr;
    PaintTool* m_paint = nullptr;
    LiveSteel* m_steel = nullptr;
    std::optional<DisplayMode> m_modeBefore; ///< of the active view, while a tool that paints is in hand
    Turntable* m_turntable = nullptr;        ///< while one is taken
    Tour* m_tour = nullptr;                  ///< while it is on
    ProjectModel* m_projectModel = nullptr;
    ProjectTree* m_tree = nullptr;
    PropertyPanel* m_properties = nullptr;
    ProgressPlots* m_plots = nullptr;
    FrameSlider* m_frames = nullptr;
    MessageList* m_messages = nullptr;
    QListWidget* m_history = nullptr;
    CommandSearch* m_search = nullptr;
    QLabel* m_navigationLabel = nullptr;
    QLabel* m_hint = nullptr;
    QMenu* m_dockMenu = nullptr;
    QList<Dock*> m_docks;
    QByteArray m_firstLayout;
    bool m_docksPlaced = false;
    QStringList m_remedies; ///< the commands that the banner offers
    /// What is to come back once a mesh that cannot be used is left.
    struct BeforeRefusal {
        QString selected;
        std::map<ViewPane*, scene::Camera> cameras;
    };
    std::optional<BeforeRefusal> m_beforeRefusal;
    bool m_mayClose = false; ///< what was to be asked before closing has been asked
    QLabel* m_savedLabel = nullptr;
};

} // namespace moldwright
