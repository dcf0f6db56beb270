// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/remedies.h"

#include "castability/topology.h"
#include "design/obstructions.h"
#include "fill/plan_regions.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace moldwright {

namespace {

/// How far a plane is moved to look for one at which nothing is in the way, in diagonals.
constexpr std::array kShifts = {0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.3};
constexpr int kPlanesTested = 24;  ///< of the best ones, after those
constexpr double kPinReach = 0.25; ///< in diagonals: points farther from the plane are not worth pinning

using Kind = Obstruction::Kind;

/// Rounded to so many decimals: facts to choose by, not to compute with.
std::string figure(double x, int decimals) {
    const double unit = std::pow(10, decimals);
    return readable(std::round(unit * x) / unit + 0.0);
}

/// The quick way to be sure of a plane: without bringing points across it first.
bool surelyPasses(const IndexedMesh& shape, const MoldState& state) {
    const PartedMesh parted = insertPartingLine(WorkingFrame(shape, state).toWork(shape), 0);
    return topologyAllowsCasting(parted.mesh, parted.labels);
}

/// The same normal, moved, the nearest first: the mold stays as it was meant.
std::optional<Remedy> movedPlane(const IndexedMesh& shape, const PartingPlane& plane, DesignRun& run) {
    for (const double share : kShifts)
        for (const double way : {1.0, -1.0}) {
            const double shift = way * share * diagonal(shape);
            MoldState state{{plane.normal, plane.offset + shift}, {}};
            const Eigen::VectorXd heights = (shape.V * plane.normal).array() - state.plane.offset;
            if (run.stopped() || heights.minCoeff() >= 0 || heights.maxCoeff() <= 0)
                continue;
            state.directions = run.directionsFor(shape, state.plane);
            if (surelyPasses(shape, state))
                return Remedy{Remedy::Kind::Plane,
                              {MW_TEXT("design", "Move the plane by {0} mm towards side {1}: nothing is in "
                                                 "the way there."),
                               {figure(std::abs(shift), 1), shift > 0 ? "1" : "2"}},
                              state};
        }
    return std::nullopt;
}

std::optional<Remedy> otherPlane(const IndexedMesh& shape, DesignRun& run) {
    for (const PlaneCandidate& candidate :
         findPlanes(shape, run.planeSearch(kPlanesTested), run.task().part(1, 1))) {
        if (run.stopped())
            break;
        if (!surelyPasses(shape, candidate.state))
            continue;
        const Eigen::Vector3d& n = candidate.state.plane.normal;
        return Remedy{
            Remedy::Kind::Plane,
            {MW_TEXT("design", "Part it square to ({0}, {1}, {2}), {3} mm from the origin, instead: nothing "
                               "is in the way there."),
             {figure(n.x(), 3), figure(n.y(), 3), figure(n.z(), 3), figure(candidate.state.plane.offset, 2)}},
            candidate.state};
    }
    return std::nullopt;
}

Remedy filling(bool joins, double volumeFilled, double partVolume, std::vector<Eigen::Vector3d> places) {
    const std::vector<std::string> facts{figure(volumeFilled / 1000, 2),
                                         figure(100 * volumeFilled / partVolume, 1)};
    if (joins)
        return {
            Remedy::Kind::Merge,
            {MW_TEXT("design", "Have it joined to the piece beside it: that fills in {0} cm³, {1} % of the "
                               "part."),
             facts},
            {},
            volumeFilled,
            std::move(places)};
    return {Remedy::Kind::Fill,
            {MW_TEXT("design", "Fill it: that takes {0} cm³, {1} % of the part."), facts},
            {},
            volumeFilled,
            std::move(places)};
}

/// The highest point of a piece: drawn into the plane it takes the obstruction with it.
std::optional<Remedy> pin(const SidePiece& piece, const PartedMesh& surface, const WorkingFrame& frame) {
    Eigen::Vector3d highest = Eigen::Vector3d::Zero();
    for (const int f : piece.faces)
        for (int k = 0; k < 3; ++k)
            if (const Eigen::Vector3d x = surface.mesh.corner(f, k); std::abs(x.z()) > std::abs(highest.z()))
                highest = x;
    if (std::abs(highest.z()) > kPinReach)
        return std::nullopt;
    const Eigen::Vector3d point = frame.toPart(highest);
    return Remedy{Remedy::Kind::Pin,
                  {MW_TEXT("design", "Pin the point {0} to the plane, {1} mm away, so that the plane runs "
                                     "through it."),
                   {placeText(point), figure(std::abs(highest.z()) * frame.scale(), 1)}},
                  {},
                  0,
                  {point}};
}

/// Filling, merging and pinning: what is known of each piece that is in the way.
void offerLocalRemedies(ObstructedPart& obstructed, const IndexedMesh& shape, const WorkingFrame& frame,
                        const Directions& directions, const Task& task) {
    const PartedMesh& surface = obstructed.surface;
    const Result<FillPlan> plan = planFill(surface, frame.directionsToWork(directions), task);
    if (!plan)
        return;
    const std::vector<char> joining = regionsThatJoin(*plan);
    const double cubed = std::pow(frame.scale(), 3);
    std::size_t next = 0;
    for (const SidePiece& piece : sidePieces(surface.mesh, surface.labels)) {
        if (pieceFault(surface.mesh, piece) == PieceFault::None || next == obstructed.obstructions.size())
            continue;
        Obstruction& obstruction = obstructed.obstructions[next++];
        double filled = 0;
        bool joins = false;
        std::vector<Eigen::Vector3d> places;
        for (const int region : neededRegionsAt(*plan, piece.faces)) {
            filled += plan->regions[static_cast<std::size_t>(region)].volume * cubed;
            joins = joins || joining[static_cast<std::size_t>(region)];
            places.push_back(frame.toPart(plan->regions[static_cast<std::size_t>(region)].place));
        }
        if (!places.empty())
            obstruction.remedies.push_back(filling(joins, filled, volume(shape), std::move(places)));
        if (obstruction.kind == Kind::Handle)
            if (const std::optional<Remedy> pinned = pin(piece, surface, frame))
                obstruction.remedies.push_back(*pinned);
    }
}

} // namespace

void offerRemedies(ObstructedPart& obstructed, const IndexedMesh& shape, const MoldState& state,
                   DesignRun& run) {
    // With the plane left free, the best ones were tried already.
    if (run.request().plane) {
        std::optional<Remedy> plane = movedPlane(shape, state.plane, run);
        if (!plane && !run.stopped())
            plane = otherPlane(shape, run);
        for (Obstruction& obstruction : obstructed.obstructions)
            if (plane)
                obstruction.remedies.push_back(*plane);
    }
    if (!run.stopped())
        offerLocalRemedies(obstructed, shape, WorkingFrame(shape, state), state.directions, run.task());
}

} // namespace moldwright
