// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/filling.h"
#include "exchange/mesh_file.h"
#include "mold/mold.h"
#include "panels/message_list.h"
#include "panels/progress_plots.h"
#include "scene/lasso.h"
#include "window/advice.h"
#include "window/background.h"
#include "window/built_mold.h"
#include "window/display_mode.h"
#include "window/document.h"
#include "window/frame_history.h"
#include "window/known_undercuts.h"
#include "window/live_analysis.h"
#include "window/live_frames.h"
#include "window/live_maps.h"
#include "window/live_origins.h"
#include "window/mesh_figures.h"
#include "window/opened_mesh.h"
#include "window/plane_offers.h"
#include "window/run_control.h"
#include "window/shown_surface.h"
#include "window/variant_comparison.h"

#include <QObject>
#include <QTimer>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

class MoldPlacing;
class PinOffers;
struct RefusedMesh;

/// Everything the window works on: the document, what is derived from it, and the jobs that change it. It
/// knows no widget; windows come and go (with the language) while the workbench stays.
class Workbench : public QObject {
    Q_OBJECT
public:
    explicit Workbench(QObject* parent = nullptr);

    [[nodiscard]] Document& document() { return m_document; }
    [[nodiscard]] const Document& document() const { return m_document; }
    [[nodiscard]] const Project& project() const { return m_document.project(); }
    [[nodiscard]] Background& background() { return m_background; }
    [[nodiscard]] const Background& background() const { return m_background; }
    [[nodiscard]] MessageModel* messages() { return &m_messages; }

    /// The surface in view: a run's newest frame, the cast when it is current, else the part.
    [[nodiscard]] SharedMesh shownMesh() const;
    [[nodiscard]] std::optional<MoldState> shownState() const;
    /// The state of the surface that a view with this content shows.
    [[nodiscard]] std::optional<MoldState> stateIn(ViewContent content) const;
    [[nodiscard]] bool castShown() const { return !m_frame && project().cast; }

    /// shownMesh() made ready to be drawn; null while that is not done.
    [[nodiscard]] scene::SharedDrawnMesh drawnSurface() const;
    /// Box, area and volume of a mesh; measured when asked for the first time.
    [[nodiscard]] MeshFigures figures(const SharedMesh& mesh) const { return m_figures.of(mesh); }

    /// The newest analysis; of shownMesh() when analysisIsCurrent().
    [[nodiscard]] const AnalysisAnswer* analysis() const { return m_answer.get(); }
    [[nodiscard]] bool analysisIsCurrent() const;
    [[nodiscard]] const DraftAnalysis* shownAnalysis() const;
    /// Whether shownAnalysis() is of the stand-in of shownMesh() only.
    [[nodiscard]] bool analysisIsCoarse() const;

    /// What a view is to show of it.
    [[nodiscard]] ShownSurface surface(ViewContent content) const;
    /// The newest map of it in this mode, also while one of a moved plane is still being made; null for none.
    [[nodiscard]] const FaceMap* map(ViewContent content, DisplayMode mode);
    /// Whether the part as it was opened is to be kept ready beside its cast.
    void keepPartReady(bool wanted);

    /// Whether the cast in view is proved on its coordinates.
    [[nodiscard]] bool castIsProved() const;

    [[nodiscard]] bool running() const { return m_stream != nullptr; }
    /// Whether plane, directions and pins may be edited: in view, and no job runs but one that takes them up.
    [[nodiscard]] bool editable() const { return !m_refused && (running() || !m_background.busy()); }
    /// Whether a run holds still.
    [[nodiscard]] bool resting() const { return running() && m_control->resting(); }
    /// Whether a run is at the stage that finish() ends.
    [[nodiscard]] bool bending() const {
        return running() && m_frame && m_frame->frame.stage == "deformation";
    }
    [[nodiscard]] const std::optional<ShownFrame>& frame() const { return m_frame; }
    /// The frames kept of the run, or of the last one of this part, from its first to its newest.
    [[nodiscard]] const std::vector<DesignFrame>& keptFrames() const { return m_kept.frames(); }
    /// The number of the one of them that is in view; −1 while there are none.
    [[nodiscard]] int frameInView() const {
        return goneBack() ? m_kept.at(m_backTo) : static_cast<int>(m_kept.frames().size()) - 1;
    }
    /// Whether it was gone back to; else it is the newest.
    [[nodiscard]] bool goneBack() const { return m_kept.at(m_backTo) >= 0; }
    /// The project as an edit of plane or directions is to find it: at the state in view.
    [[nodiscard]] Project projectInView() const;
    /// Where the document's pins are in the shape in view; empty where that is not known.
    [[nodiscard]] std::vector<Pin> pinsInView() const;
    /// Something will be clicked on the shape in view.
    void setPicking(bool picking);
    [[nodiscard]] const std::vector<ProgressPoint>& progress() const { return m_progress; }
    /// The planes that the last search offers for this part, best first; none before a search.
    [[nodiscard]] const std::vector<OfferedPlane>& offeredPlanes() const;
    /// The one of them that is taken; −1 for none.
    [[nodiscard]] int offeredPlane() const;
    /// Another word for each search, so that a list of its planes can be kept until the next.
    [[nodiscard]] int searchNumber() const { return m_searchNumber; }

    /// What stood in the way of the last run, as long as part and plane are those it ran with.
    [[nodiscard]] const std::vector<Obstruction>& obstructions() const;
    /// A box about one of them, mm.
    [[nodiscard]] Eigen::AlignedBox3d placeOf(int obstruction) const;

    /// The mold that was built last for the current variant, also where it is out of date; null for none.
    [[nodiscard]] const std::shared_ptr<const Mold>& mold() const { return built().mold; }
    [[nodiscard]] bool moldIsCurrent() const;
    /// Half 1 or 2 of the mold, ready to be drawn. Precondition: there is a mold.
    [[nodiscard]] const scene::SharedDrawnMesh& drawnHalf(int side) const { return built().halves[side - 1]; }

    /// What the halves of the mold meet of its cast on their way out; nothing where they are proved.
    [[nodiscard]] const std::array<ContactWays, 2>& contacts() const { return built().contacts; }
    /// Where the mold's features stand.
    [[nodiscard]] MoldPlacing& placing() { return *m_placing; }
    [[nodiscard]] const MoldPlacing& placing() const { return *m_placing; }

    // Variants: other designs of the part, by their numbers
    [[nodiscard]] VariantComparison& variants() { return m_variants; }
    [[nodiscard]] const VariantComparison& variants() const { return m_variants; }
    void chooseVariant(int variant);
    /// The next one in their order, or with −1 the one before, round and round.
    void walkVariants(int way);
    void duplicateVariant(int variant);
    void addVariant();
    void renameVariant(int variant, const QString& name);
    void removeVariant(int variant);

    // Further parts of the mold, by their numbers
    /// Reads finished casts from project files. All of them come into the mold in one undo step, or none.
    void addPartsToMold(const QStringList& files);
    void readPartAgain(int part);
    void renamePartOfMold(int part, const QString& name);
    /// A preview is no step yet.
    void countPartOfMold(int part, int cavities, bool preview);
    void removePartOfMold(int part);

    // Files
    /// A mesh that cannot be designed with, in view before the document until it is left; null for none.
    [[nodiscard]] const RefusedMesh* refused() const { return m_refused.get(); }
    void leaveRefused();
    /// Has it mended, or a closed skin made about it, and opens that as a part of the same name.
    void repairRefused();
    void openFile(const QString& file);
    void openSample(const QString& file, const QString& name);
    void take(const OpenedMesh& opened, Unit unit, double scale);
    /// Opens work that was lost, and is in no file.
    void openLost(const Project& project);
    void closePart();
    /// Saves the project; `thumbnail` is a PNG of the view. `then` is done once it is safe on the disk.
    void save(const QString& file, const QByteArray& thumbnail, const std::function<void()>& then = {});
    void exportShape(const QString& file);
    void exportMold(const QString& folder);
    /// Has moldwright-render write the report as a PDF.
    void writeReport(const QString& file);

    // The part
    void setPlacement(const Placement& placement, const QString& words, const QString& mergeKey = {});
    void quarterTurnPart(const Eigen::Vector3d& axis);
    /// About the part's middle; a preview is no step yet.
    void turnPart(const Eigen::Vector3d& axis, double degrees, bool preview);
    void layFlatOn(int face);
    void centrePart();

    // Plane and directions
    /// Searches, takes the best plane, and offers the others.
    void findBestPlane();
    /// Takes one of offeredPlanes(). Those tried one after the other are one undo step.
    void takeOffered(int plane);
    void takeNextPlane();
    /// A plane at which none of the obstructions() stands in the way, if the run found one.
    [[nodiscard]] std::optional<MoldState> suggestedPlane() const;
    /// Precondition: there is one.
    void takeSuggestedPlane();
    void findBestDirections();
    void setState(const MoldState& state, const QString& words, const QString& mergeKey = {});

    // Undercuts that can be filled one by one
    /// Looks for them; undercuts() has them then.
    void findUndercuts();
    [[nodiscard]] bool undercutsKnown() const;
    /// Those of the part at its plane, the largest first; none while they are not known.
    [[nodiscard]] const std::vector<FillableUndercut>& undercuts() const;
    /// A box about one of them, mm.
    [[nodiscard]] Eigen::AlignedBox3d placeOfUndercut(int undercut) const;
    /// The walls that filling it would make, without draft.
    [[nodiscard]] const SharedMesh& wallsOf(int undercut) const {
        return m_undercuts.walls.at(static_cast<std::size_t>(undercut));
    }
    /// What was chosen for one of them; none: the rule.
    [[nodiscard]] std::optional<UndercutChoice::Treatment> treatmentOf(int undercut) const;
    void treat(int undercut, std::optional<UndercutChoice::Treatment> treatment);
    /// Where filling would take an obstruction away; empty where that is not known.
    [[nodiscard]] std::vector<Eigen::Vector3d> placesToFill(int obstruction) const;
    [[nodiscard]] bool willBeFilled(int obstruction) const;
    /// How many of the obstructions() are still to be decided on.
    [[nodiscard]] int obstructionsLeft() const;
    void fillObstruction(int obstruction);

    // Pins
    void addPin(const Eigen::Vector3d& place);
    /// A preview is no step yet.
    void movePin(int pin, const Eigen::Vector3d& place, const QString& mergeKey, bool preview = false);
    /// An empty name: it goes by its number.
    void renamePin(int pin, const QString& name);
    [[nodiscard]] QString pinName(int pin) const;
    void removePins(const std::vector<int>& pins);
    void clearPins();
    /// Pins from and to the JSON that the command line takes.
    void importPins(const QString& file);
    void exportPins(const QString& file);
    /// Points worth pinning, and those of them that are taken.
    [[nodiscard]] PinOffers& pinOffers() { return *m_pinOffers; }
    [[nodiscard]] const PinOffers& pinOffers() const { return *m_pinOffers; }

    // Importance
    /// The regions with one more stroke over `faces` of the part (ascending) are shown, without a step; see
    /// stroke().
    void previewStroke(int region, const std::vector<int>& faces, bool erase);
    /// Doubles the weight of faces in a region (−1: a new one), or halves it (−1: in all). One undo step.
    /// Returns the region.
    int stroke(int region, const std::vector<int>& faces, bool erase);
    /// The same for the faces of a surface seen in a lasso, which are looked for in the background; `then`
    /// hears of the region.
    void strokeIn(const scene::Lasso& lasso, const ShownSurface& surface, int region, bool erase,
                  const std::function<void(int)>& then);
    /// Where the faces of casts and frames were on the part.
    [[nodiscard]] LiveOrigins& origins() const { return m_origins; }
    void renameRegion(int region, const QString& name);
    void weighRegions(const std::vector<int>& regions, double weight, bool preview);
    void limitRegions(const std::vector<int>& regions, double keepWithin, bool preview);
    void removeRegions(const std::vector<int>& regions);
    void clearImportance();
    /// Regions from and to the JSON that the command line takes.
    void importWeights(const QString& file);
    void exportWeights(const QString& file);
    /// How a region came through in the cast; null while none has measured it.
    [[nodiscard]] const RegionMeasure* measureOf(int region) const;
    [[nodiscard]] double brushRadius() const; ///< mm over the surface
    [[nodiscard]] double largestBrush() const;
    void setBrushRadius(double mm);
    [[nodiscard]] double creaseDegrees() const { return m_creaseDegrees; }
    void setCreaseDegrees(double degrees);

    // The cast and its mold
    void run();
    /// Fills what no bending frees, in this run and the next.
    void fillAndRun();
    /// Holds the run's shape where it is; goOn() bends it further.
    void rest();
    void goOn();
    /// Has a resting run do one step.
    void stepOnce();
    /// Shows one of the keptFrames(); a run rests meanwhile.
    void showKept(int frame);
    /// Begins another run from the shape and the settings of the frame in view, instead of one that goes on.
    void goOnFromHere();
    /// Bends no further: the run finishes the shape from where it is, and proves it.
    void finish();
    /// Ends the job that runs. A run keeps what it reached, in one undo step; else all stays as it was.
    void stop() { m_background.cancel(); }
    void restoreShape();
    void rename(const QString& name);
    void buildMoldNow();

    /// A message in the list; errors also go to the banner by problem().
    void say(Standing standing, const QString& text, const Eigen::AlignedBox3d& place = {});

Q_SIGNALS:
    /// Anything that is shown may be another.
    void changed();
    /// Another part is in view: bring it into sight.
    void partOpened();
    /// Another mesh is refused(), or none any more.
    void refusalChanged();
    /// A mesh was read; its unit must be asked for.
    void unitAsked(const moldwright::OpenedMesh& opened);
    void problem(const QString& headline, const QString& text);
    void advised(const moldwright::Advice& advice);
    /// A run found obstructions().
    void obstructed();
    void undercutsFound();
    void planesFound();
    void moldBuilt();
    void partOfMoldAdded(int part);
    void saved();
    void reportWritten(const QString& file);

private:
    [[nodiscard]] const BuiltMold& built() const;
    void forgetOldPart();
    void show(const Project& project, const QString& file);
    void readProject(const QString& file);
    void readFile(const QString& file, const QString& name, bool sample);
    void takeResult(const Result<DesignResult>& result, const Project& from);
    void takeCast(const DesignResult& result, const Project& from);
    void takeLateCast(const DesignResult& result, const Project& from);
    void postLive();
    void startRun(const std::shared_ptr<const Points>& start);
    void showNewest();
    void takeKept(int step, const ShownFrame& frame);
    void forgetKept();
    void placePins();
    [[nodiscard]] Eigen::Vector3d inPart(const Eigen::Vector3d& inView) const;
    void takeObstructions(const DesignResult& result, const Project& from);
    void tellOfCast(const DesignResult& result);
    void tellOfStop(const DesignResult& result);
    void pullFrames();
    [[nodiscard]] int undercutOf(const UndercutChoice& choice) const;
    template <class Read, class With>
    void importGuides(const QString& file, const QString& reading, Read read, With with, const QString& edit,
                      const QString& done);
    void exportGuides(const QString& file, const std::string& text, const QString& done);
    void setPins(std::vector<NamedPin> pins, const QString& words, const QString& mergeKey = {});
    [[nodiscard]] Project painted(int region, const std::vector<int>& faces, bool erase) const;
    [[nodiscard]] QString newRegionName() const;
    void editRegions(const std::vector<int>& numbers, const QString& words, const QString& mergeKey,
                     bool preview, const std::function<void(ImportantRegion&)>& change);
    void tellOfRegions();
    void askAnalysis();
    void askPart();
    void forgetOldMaps();
    [[nodiscard]] std::optional<MapRequest> mapRequest(ViewContent content, DisplayMode mode) const;
    [[nodiscard]] const AnalysisAnswer* partAnswer() const;
    [[nodiscard]] const Variant& variantIn(ViewContent content) const;
    [[nodiscard]] bool completeRequest(MapRequest& request, ViewContent content) const;
    void refuse(const std::shared_ptr<const RefusedMesh>& refused);
    void complain(const Error& error, const QString& what);
    void tellOfMold(const std::optional<Error>& refusal);

    Document m_document;
    MoldPlacing* m_placing; ///< a child
    Background m_background;
    PinOffers* m_pinOffers; ///< a child
    LiveAnalysis m_analysis;
    AnalysisRequest m_analysisAsked; ///< the last request, but for its labels
    MessageModel m_messages;
    std::shared_ptr<const RefusedMesh> m_refused;
    std::shared_ptr<const AnalysisAnswer> m_answer;
    LiveAnalysis m_partAnalysis; ///< of the part while its cast is shown beside it
    std::shared_ptr<const AnalysisAnswer> m_partAnswer;
    bool m_partWanted = false;
    VariantComparison m_variants;
    LiveMaps m_liveMaps;
    std::map<std::pair<ViewContent, DisplayMode>, std::shared_ptr<const FaceMap>> m_maps;
    std::map<std::pair<ViewContent, DisplayMode>, MapRequest> m_asked; ///< for each map the last request
    mutable KnownFigures m_figures;
    mutable LiveOrigins m_origins;
    std::shared_ptr<FrameStream> m_stream;
    std::shared_ptr<RunControl> m_control;
    QTimer m_frameTimer;
    std::optional<ShownFrame> m_frame;
    FrameHistory m_kept;
    SharedMesh m_keptPart;
    int m_backTo = 0; ///< the step of the kept frame gone back to; 0: none
    LiveFrames m_liveFrames;
    std::optional<DesignFrame> m_branch; ///< where the next run begins once this one has ended
    Project m_runFrom;                   ///< what the run began with
    LiveSettings m_posted;               ///< what it was told last
    bool m_picking = false;
    bool m_toldOfLate = false; ///< that something waits for the next run
    std::vector<ProgressPoint> m_progress;
    std::vector<OfferedPlane> m_offered;
    SharedMesh m_offeredPart;
    int m_searchNumber = 0;
    std::vector<Obstruction> m_obstructions;
    SharedMesh m_obstructedPart;
    std::optional<MoldState> m_obstructedState;
    KnownUndercuts m_undercuts;
    std::optional<double> m_brushRadius; ///< mm; none: by the part's size
    double m_creaseDegrees = 30;
    std::map<std::string, BuiltMold> m_molds; ///< by the variant's name
};

} // namespace moldwright
