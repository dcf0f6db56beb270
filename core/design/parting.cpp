// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/parting.h"

#include "castability/topology.h"
#include "design/obstructions.h"
#include "design/pins_in_plane.h"
#include "exchange/tetrahedralize.h"
#include "fill/fill_plan.h"
#include "mesh/check.h"

#include <functional>
#include <optional>

namespace moldwright {

namespace {

/// Shares of the shortest edge within which points are snapped to the plane: round faces first, caution
/// later.
constexpr std::array kSnaps = {0.25, 0.1, 0.02, 0.0};

/// How near to the plane points may lie that are brought across it, in diagonals; none where that does not
/// serve.
constexpr std::array kReaches = {0.015, 0.0};
constexpr int kUncrossingRounds = 10;

/// How a part is parted to see what hangs together: as it will be; then untouched, so that no snapped point
/// is blamed on the part.
struct Parting {
    double reach;
    double snap;
};
constexpr std::array kPartings = {Parting{kReaches.front(), kSnaps.front()}, Parting{0, kSnaps.front()},
                                  Parting{0, 0}};

/// crossNearPoints() where that makes nothing cross: points of faces that then intersect go back, with their
/// neighbours.
IndexedMesh crossWhereFree(const IndexedMesh& work, double reach) {
    IndexedMesh crossed = crossNearPoints(work, reach);
    for (int round = 0; round < kUncrossingRounds; ++round) {
        const auto pairs = selfIntersections(crossed);
        if (pairs.empty())
            return crossed;
        std::vector<char> back(static_cast<std::size_t>(work.vertexCount()), 0);
        for (const auto& [f, g] : pairs)
            for (int k = 0; k < 3; ++k)
                back[static_cast<std::size_t>(work.F(f, k))] = back[static_cast<std::size_t>(work.F(g, k))] =
                    1;
        for (int f = 0; f < work.faceCount(); ++f) {
            const Eigen::RowVector3i c = work.F.row(f);
            if (back[static_cast<std::size_t>(c[0])] || back[static_cast<std::size_t>(c[1])] ||
                back[static_cast<std::size_t>(c[2])])
                for (int k = 0; k < 3; ++k)
                    crossed.V.row(c[k]) = work.V.row(c[k]);
        }
    }
    return work;
}

/// The part in the working frame with its parting line inserted, through its pins too.
PartedMesh parted(const IndexedMesh& work, double reach, double snap,
                  const std::vector<PlacedPin>& pins = {}) {
    return insertPartingLine(withPinsInPlane(reach > 0 ? crossWhereFree(work, reach) : work, pins), snap);
}

Result<FilledPart> filledTo(FillExtent extent, const PartedMesh& surface, const Directions& directions,
                            const Task& task) {
    if (extent == FillExtent::All)
        return fill(surface, directions, task);
    const Result<FillPlan> plan = planFill(surface, directions, task);
    if (!plan)
        return std::unexpected(plan.error());
    return minimalFill(*plan);
}

Error crossesItself() {
    return {ErrorCode::Internal,
            {MW_TEXT("design", "The parting line could not be inserted without the surface crossing itself."),
             {}},
            {},
            {}};
}

Error doesNotHold() {
    return {ErrorCode::Impossible,
            {MW_TEXT("design", "A pinned point of the surface could not be made a point of the parting line. "
                               "Pin a point inside the part instead."),
             {}},
            {},
            {}};
}

Error wasCancelled() {
    return {ErrorCode::Cancelled, {MW_TEXT("design", "The design was cancelled."), {}}, {}, {}};
}

/// What takes a parted surface with its pins, or refuses it and why.
using Taking = std::function<std::optional<Error>(const PartedMesh&, const std::vector<PlacedPin>&)>;

std::optional<Error> takeAny(const PartedMesh&, const std::vector<PlacedPin>&) {
    return std::nullopt;
}

/// Takes a surface when TetGen fills it; the tetrahedra go to `tets`.
Taking takeFilled(TetMesh& tets, const Task& task) {
    return [&](const PartedMesh& surface, const std::vector<PlacedPin>& pins) -> std::optional<Error> {
        Result<TetMesh> filled = tetrahedralize(surface.mesh, task, kTetGenSwitches, innerPlaces(pins));
        if (!filled)
            return filled.error();
        tets = std::move(*filled);
        return std::nullopt;
    };
}

Result<PartedPart> partUntil(const Taking& take, const IndexedMesh& part, const MoldState& state,
                             const Task& task, const std::vector<PlacedPin>& partPins) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    const std::vector<PlacedPin> pins = pinsToWork(partPins, frame);
    std::optional<Error> refusal;
    for (const double reach : kReaches)
        for (const double snap : kSnaps) {
            if (task.stopped())
                return std::unexpected(wasCancelled());
            PartedMesh surface = parted(work, reach, snap, pins);
            if (const auto obstructions = findObstructions(surface.mesh, surface.labels, frame);
                !obstructions.empty()) {
                refusal = Error{
                    ErrorCode::Impossible, obstructions.front().message, {}, {obstructions.front().place}};
                continue;
            }
            if (!pinsAreInPlane(surface.mesh, pins))
                refusal = doesNotHold();
            else
                refusal = selfIntersections(surface.mesh).empty() ? take(surface, pins) : crossesItself();
            if (!refusal)
                return PartedPart{state, frame, std::move(surface), 0, pins};
        }
    return std::unexpected(*refusal);
}

/// A way to fill a parted surface.
using Filling = std::function<Result<FilledPart>(const PartedMesh&, const Directions&)>;

Filling fillingTo(FillExtent extent, const Task& task) {
    return [extent, &task](const PartedMesh& surface, const Directions& directions) {
        return filledTo(extent, surface, directions, task);
    };
}

Result<PartedPart> fillUntil(const Taking& take, const IndexedMesh& part, const MoldState& state,
                             const Filling& filling, const Task& task,
                             const std::vector<PlacedPin>& partPins) {
    const WorkingFrame frame(part, state);
    const std::vector<PlacedPin> pins = pinsToWork(partPins, frame);
    const IndexedMesh work = withPinsInPlane(frame.toWork(part), pins);
    const Directions directions = frame.directionsToWork(state.directions);
    std::optional<Error> refusal;
    for (const double snap : kSnaps) {
        if (task.stopped())
            return std::unexpected(wasCancelled());
        const PartedMesh surface = insertPartingLine(work, snap);
        if (!selfIntersections(surface.mesh).empty()) {
            refusal = crossesItself();
            continue;
        }
        Result<FilledPart> filled = filling(surface, directions);
        if (!filled) {
            refusal = filled.error();
            continue;
        }
        std::vector<PlacedPin> left = pinsAfterFilling(pins, filled->sourceVertex);
        refusal = pinsAreInPlane(filled->surface.mesh, left) ? take(filled->surface, left) : doesNotHold();
        if (refusal)
            continue;
        for (int& source : filled->surface.sourceFace)
            if (source >= 0)
                source = surface.sourceFace[static_cast<std::size_t>(source)];
        const double cubed = frame.scale() * frame.scale() * frame.scale();
        return PartedPart{state, frame, std::move(filled->surface), filled->volume * cubed, std::move(left)};
    }
    return std::unexpected(*refusal);
}

/// A parted part with the tetrahedra that were made on taking it.
Result<PartedSolid> solidOf(Result<PartedPart> part, TetMesh tets) {
    if (!part)
        return std::unexpected(part.error());
    return PartedSolid{std::move(*part), std::move(tets)};
}

} // namespace

bool planePasses(const IndexedMesh& part, const MoldState& state) {
    const IndexedMesh work = WorkingFrame(part, state).toWork(part);
    return std::any_of(kPartings.begin(), kPartings.end(), [&](const Parting& parting) {
        // Whether anything would cross takes longest to tell: only where it matters.
        const auto passes = [](const PartedMesh& surface) {
            return topologyAllowsCasting(surface.mesh, surface.labels);
        };
        if (parting.reach > 0 &&
            !passes(insertPartingLine(crossNearPoints(work, parting.reach), parting.snap)))
            return false;
        return passes(parted(work, parting.reach, parting.snap));
    });
}

ObstructedPart obstructionsAt(const IndexedMesh& part, const MoldState& state) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    ObstructedPart found;
    for (const auto& [reach, snap] : kPartings) {
        PartedMesh surface = parted(work, reach, snap);
        found = {findObstructions(surface.mesh, surface.labels, frame), std::move(surface)};
        if (found.obstructions.empty())
            break;
    }
    return found;
}

Result<PartedPart> partSurface(const IndexedMesh& part, const MoldState& state, const Task& task,
                               const std::vector<PlacedPin>& pins) {
    return partUntil(takeAny, part, state, task, pins);
}

Result<PartedSolid> partSolid(const IndexedMesh& part, const MoldState& state, const Task& task,
                              const std::vector<PlacedPin>& pins) {
    TetMesh tets;
    Result<PartedPart> taken = partUntil(takeFilled(tets, task), part, state, task, pins);
    return solidOf(std::move(taken), std::move(tets));
}

Result<PartedPart> filledSurface(const IndexedMesh& part, const MoldState& state, FillExtent extent,
                                 const Task& task, const std::vector<PlacedPin>& pins) {
    return fillUntil(takeAny, part, state, fillingTo(extent, task), task, pins);
}

Result<PartedSolid> filledSolid(const IndexedMesh& part, const MoldState& state, FillExtent extent,
                                const Task& task, const std::vector<PlacedPin>& pins) {
    TetMesh tets;
    Result<PartedPart> taken =
        fillUntil(takeFilled(tets, task), part, state, fillingTo(extent, task), task, pins);
    return solidOf(std::move(taken), std::move(tets));
}

Result<PartedPart> filledWithDraft(const IndexedMesh& part, const MoldState& state, double draftDegrees,
                                   const Task& task, const std::vector<PlacedPin>& pins) {
    const Filling filling = [&](const PartedMesh& surface, const Directions& directions) {
        return fillWithDraft(surface, directions, draftDegrees, task);
    };
    return fillUntil(takeAny, part, state, filling, task, pins);
}

} // namespace moldwright
