// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/parting.h"

#include "castability/topology.h"
#include "design/design_run.h"
#include "design/obstructions.h"
#include "design/pins_in_plane.h"
#include "exchange/tetrahedralize.h"
#include "mesh/check.h"

#include <algorithm>

namespace moldwright {

namespace {

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
        if (crossed.V == work.V)
            break;
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

/// The part in the working frame, ready for its parting line: points near the plane across it, pins in it.
IndexedMesh readyToPart(const IndexedMesh& work, double reach, const std::vector<PlacedPin>& pins = {}) {
    return withPinsInPlane(reach > 0 ? crossWhereFree(work, reach) : work, pins);
}

Result<PartedPart> partUntil(const Taking& take, const IndexedMesh& part, const MoldState& state,
                             const Task& task, const std::vector<PlacedPin>& partPins) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    const std::vector<PlacedPin> pins = pinsToWork(partPins, frame);
    std::optional<Error> refusal;
    for (const double reach : kReaches) {
        // What crosses itself as it is, as a shape amid its bending may, does so however it is parted.
        if (refusal && refusal->code == ErrorCode::Internal && !selfIntersections(work).empty())
            break;
        const IndexedMesh ready = readyToPart(work, reach, pins);
        for (const double snap : kSnaps) {
            if (task.stopped())
                return DesignRun::cancelled();
            PartedMesh surface = insertPartingLine(ready, snap);
            if (const auto obstructions = findObstructions(surface.mesh, surface.labels, frame);
                !obstructions.empty()) {
                refusal = Error{
                    ErrorCode::Impossible, obstructions.front().message, {}, {obstructions.front().place}};
                continue;
            }
            if (!pinsAreInPlane(surface.mesh, pins))
                refusal = missesPin();
            else
                refusal = selfIntersections(surface.mesh).empty() ? take(surface, pins) : crossesItself();
            if (!refusal)
                return PartedPart{state, frame, std::move(surface), 0, false, pins};
        }
    }
    return std::unexpected(*refusal);
}

} // namespace

std::optional<Error> takeAny(const PartedMesh&, const std::vector<PlacedPin>&) {
    return std::nullopt;
}

Taking takeTetrahedralized(TetMesh& tets, const Task& task) {
    return [&](const PartedMesh& surface, const std::vector<PlacedPin>& pins) -> std::optional<Error> {
        Result<TetMesh> filled = tetrahedralize(surface.mesh, task, kTetGenSwitches, innerPlaces(pins));
        if (!filled)
            return filled.error();
        tets = std::move(*filled);
        return std::nullopt;
    };
}

Result<PartedSolid> solidOf(Result<PartedPart> part, TetMesh tets) {
    if (!part)
        return std::unexpected(part.error());
    return PartedSolid{std::move(*part), std::move(tets)};
}

Error crossesItself() {
    return {ErrorCode::Internal,
            {MW_TEXT("design", "The parting line could not be inserted without the surface crossing itself."),
             {}},
            {},
            {}};
}

Error missesPin() {
    return {ErrorCode::Impossible,
            {MW_TEXT("design", "A pinned point of the surface could not be made a point of the parting line. "
                               "Pin a point inside the part instead."),
             {}},
            {},
            {}};
}

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
        return passes(insertPartingLine(readyToPart(work, parting.reach), parting.snap));
    });
}

ObstructedPart obstructionsAt(const IndexedMesh& part, const MoldState& state) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    ObstructedPart found;
    for (const auto& [reach, snap] : kPartings) {
        PartedMesh surface = insertPartingLine(readyToPart(work, reach), snap);
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
    Result<PartedPart> taken = partUntil(takeTetrahedralized(tets, task), part, state, task, pins);
    return solidOf(std::move(taken), std::move(tets));
}

} // namespace moldwright
