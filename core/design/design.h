// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"
#include "base/task.h"
#include "castability/certificate.h"
#include "castability/direction_limits.h"
#include "castability/mold_state.h"
#include "design/region_measure.h"
#include "design/strain.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

enum class DirectionsChoice { Automatic, Normal, Given };
enum class DeformationMethod { Default, Paper };

/// What happens to places that no bending frees: nothing (the obstruction is the answer), or they are filled.
enum class FillChoice { None, Auto };

/// A point of the part that may move only in the parting plane. [Stein 2019], Section 6.1.
struct Pin {
    /// mm, part frame, in the undeformed shape: inside, or on the surface, where the nearest point of the
    /// mesh is meant.
    Eigen::Vector3d point;
    bool operator==(const Pin&) const = default;
};

/// What the designer wants done about one undercut, whatever the rule for the others is.
struct UndercutChoice {
    enum class Treatment { Bend, Fill };
    Eigen::Vector3d
        place; ///< mm, part frame: on its surface; the nearest undercut that can be filled is meant
    Treatment treatment = Treatment::Fill;
    bool operator==(const UndercutChoice&) const = default;
};

/// What the designer may change while the deformation runs. [Stein 2019], Section 6.3.
struct LiveSettings {
    std::optional<PartingPlane> plane; ///< none: the best plane that passes the topological certificate; in a
                                       ///< run that has one already: that
    DirectionsChoice directionsChoice = DirectionsChoice::Automatic;
    Directions directions;         ///< used when Given
    bool followDirections = false; ///< Automatic directions are sought anew as the shape bends (the published
                                   ///< method always does that)
    double draftDegrees = 1;
    DirectionLimits limits; ///< where directions that are not Given may point
    double smoothing = 0.1; ///< γ of [Stein 2019], Eq. (6): how much neighbours turn alike in the published
                            ///< method
    std::vector<Pin> pins;
    std::vector<double> faceWeights; ///< importance per face of the part, 1 = plain; empty: all plain
    std::vector<KeptRegion> regions; ///< of the part: measured in the result
    bool operator==(const LiveSettings&) const = default;
};

/// What Algorithm 1 is asked to do.
struct DesignRequest : LiveSettings {
    SharedMesh part; ///< closed, usable (see prepare()), mm
    /// The part's points where bending is to begin, bent already; none: as they are. It needs a plane.
    std::shared_ptr<const Points> start;
    DeformationMethod method = DeformationMethod::Default;
    std::vector<Eigen::Vector3d> limbTips; ///< where limb measures are wanted; empty: found automatically
    FillChoice fill = FillChoice::None;
    std::vector<UndercutChoice> undercuts; ///< treated as chosen; they need a plane
    bool mergePieces = false; ///< filling may join pieces that were apart, where no choice says so too
    bool keepUnfinished =
        false; ///< a stopped run returns what it reached, marked cutShort, if it got that far
    unsigned seed = 1;
    /// Asked after every step: true ends the bending there and goes on to the finish; may be empty. Called
    /// from one thread at a time, as are the next two and the sink of frames.
    std::function<bool()> finishNow;
    /// Asked after every step: what is to hold from now on; none when nothing was changed. The run goes on
    /// from its present shape: at once where draft, directions or weights were changed while the part is
    /// bent; parted anew where it was the plane, the pins, or anything while the bent part is finished or
    /// filled. May be empty.
    std::function<std::optional<LiveSettings>()> newest;
    /// Asked when something was changed that needs time to be made ready: true: until then the shape goes on
    /// being bent as before, and seen; false or empty: it stands still.
    std::function<bool()> bendMeanwhile;
};

/// One picture of a running deformation: enough to draw it.
struct DesignFrame {
    std::string stage; ///< English name of the stage
    SharedMesh shape;  ///< mm, part frame
    SideLabels labels; ///< side of each face of shape; empty while the part is not split
    MoldState state;
    /// n×3: where each point of shape was before it was bent, in the part; null where filling made points.
    std::shared_ptr<const Points> before;
    /// The part's own points as they are now, a start for another run; null where filling changed the part.
    std::shared_ptr<const Points> partPoints;
    int step = 0;
    double energy = 0; ///< castability energy, scale-free (diagonal 1)
    double worstDraftDegrees = 0;
    double violatingAreaFraction = 0;
    LiveSettings settings; ///< what it was made with
};
using FrameSink = std::function<void(const DesignFrame&)>;

/// What would take an obstruction away, with the facts to choose by.
struct Remedy {
    enum class Kind { Plane, Fill, Merge, Pin };
    Kind kind = Kind::Fill;
    Message message;                          ///< what to do and what it takes
    std::optional<MoldState> state = {};      ///< Plane: where nothing is in the way
    double volume = 0;                        ///< Fill, Merge: what would be filled in, mm³
    std::vector<Eigen::Vector3d> places = {}; ///< mm, part frame. Fill, Merge: on each undercut to be filled;
                                              ///< Pin: the point to be drawn into the plane
};

/// A named reason why the shape cannot be cast with these choices, whatever the deformation.
struct Obstruction {
    enum class Kind { Pocket, ClosedPiece, Handle, Link, SteepFaces };
    Kind kind = Kind::Pocket;
    Message message;       ///< what, where, what would help
    Eigen::Vector3d place; ///< mm, part frame
    double size = 0;       ///< mm, diagonal of the piece concerned
    int side = 0;          ///< 1 or 2
    std::vector<Remedy> remedies;
};

/// How far the cast is from the part, after the best rigid fit; distances over the part's diagonal.
struct Change {
    double meanDistance = 0;
    double maxDistance = 0;
    double volumeRatio = 1;
    double filledVolumeFraction = 0;
};

/// How a limb came through: geodesic length tip to joint and volume, cast over part.
struct LimbMeasure {
    Eigen::Vector3d tip; ///< mm, part frame, on the undeformed part
    double lengthRatio = 1;
    double volumeRatio = 1;
};

/// Where a pinned point has come to.
struct PinnedPoint {
    Eigen::Vector3d place;        ///< mm, part frame; in the cast or on it
    double distanceFromPlane = 0; ///< mm
};

struct DesignResult {
    SharedMesh cast; ///< mm, part frame, every coordinate a float; none when an obstruction stood in the way
    SideLabels labels; ///< side of each face of cast
    Points before;     ///< n×3, mm, part frame: where each point of cast was before it was bent, in the part,
                       ///< filled where it was filled
    MoldState state;
    LiveSettings settings; ///< what it was made with: the request's, or what they were changed to
    bool castable = false; ///< exactly: certificate.holds()
    bool cutShort = false; ///< stopped before its end: what was reached until then
    Certificate certificate;
    double energy = 0;
    double violatingAreaFraction = 0;
    Change change;
    SurfaceStrain strain; ///< from the part, filled where it was filled, to the cast
    std::vector<LimbMeasure> limbs;
    std::vector<RegionMeasure> regions; ///< one for each of the request's; none without a cast
    std::vector<PinnedPoint> pins;      ///< one for each of the request's; none without a cast
    std::vector<Obstruction> obstructions;
    SharedMesh parted; ///< mm, part frame: the part with its parting line, where obstructions were found
    SideLabels partedLabels; ///< side of each face of parted
    std::vector<Message> warnings;
    bool bentByProxy = false; ///< by a coarse stand-in, see proxy.h
    int tets = 0;
    int plasticSteps = 0;
    int steps = 0; ///< of the whole run; without `frames` only those of the published method are counted
    int localGlobalIterations = 0;
    std::map<std::string, double> seconds; ///< keys of timings.json
};

/// Runs Algorithm 1 unattended ([Stein 2019], Section 6.3; the pipeline is described in ARCHITECTURE.md):
/// plane → parting line → deformation → finish → proof. `frames`, if set, is called from this thread after
/// every step; while it does not return, the run rests. A result that is not castable is a value with
/// castable = false; obstructions say why when one was found. Errors: BadInput, Impossible (no plane passes),
/// Cancelled, Worker.
[[nodiscard]] Result<DesignResult> design(const DesignRequest& request, const Task& task = {},
                                          const FrameSink& frames = {});

} // namespace moldwright
