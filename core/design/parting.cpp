// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/parting.h"

#include "castability/topology.h"
#include "design/obstructions.h"
#include "exchange/tetrahedralize.h"
#include "fill/fill_plan.h"
#include "mesh/check.h"

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

/// The part in the working frame with its parting line inserted.
PartedMesh parted(const IndexedMesh& work, double reach, double snap) {
    return insertPartingLine(reach > 0 ? crossWhereFree(work, reach) : work, snap);
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

} // namespace

bool planePasses(const IndexedMesh& part, const MoldState& state) {
    const IndexedMesh work = WorkingFrame(part, state).toWork(part);
    return std::any_of(kPartings.begin(), kPartings.end(), [&](const Parting& parting) {
        const PartedMesh surface = parted(work, parting.reach, parting.snap);
        return topologyAllowsCasting(surface.mesh, surface.labels);
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

Result<PartedSolid> partSolid(const IndexedMesh& part, const MoldState& state, const Task& task) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    std::optional<Error> refusal;
    for (const double reach : kReaches)
        for (const double snap : kSnaps) {
            if (task.stopped())
                return failure(ErrorCode::Cancelled, MW_TEXT("design", "The design was cancelled."));
            PartedMesh surface = parted(work, reach, snap);
            if (const auto obstructions = findObstructions(surface.mesh, surface.labels, frame);
                !obstructions.empty()) {
                refusal = Error{
                    ErrorCode::Impossible, obstructions.front().message, {}, {obstructions.front().place}};
                continue;
            }
            if (!selfIntersections(surface.mesh).empty()) {
                refusal = crossesItself();
                continue;
            }
            Result<TetMesh> tets = tetrahedralize(surface.mesh, task);
            if (tets)
                return PartedSolid{state, frame, std::move(surface), std::move(*tets)};
            refusal = tets.error();
            if (refusal->code == ErrorCode::Cancelled)
                return std::unexpected(*refusal);
        }
    return std::unexpected(*refusal);
}

Result<PartedSolid> filledSolid(const IndexedMesh& part, const MoldState& state, FillExtent extent,
                                const Task& task) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    const Directions directions = frame.directionsToWork(state.directions);
    std::optional<Error> refusal;
    for (const double snap : kSnaps) {
        const PartedMesh surface = insertPartingLine(work, snap);
        if (!selfIntersections(surface.mesh).empty()) {
            refusal = crossesItself();
            continue;
        }
        Result<FilledPart> filled = filledTo(extent, surface, directions, task);
        Result<TetMesh> tets = filled ? tetrahedralize(filled->surface.mesh, task)
                                      : Result<TetMesh>(std::unexpected(filled.error()));
        if (!tets) {
            refusal = tets.error();
            if (task.stopped())
                break;
            continue;
        }
        for (int& source : filled->surface.sourceFace)
            if (source >= 0)
                source = surface.sourceFace[static_cast<std::size_t>(source)];
        const double cubed = frame.scale() * frame.scale() * frame.scale();
        return PartedSolid{state, frame, std::move(filled->surface), std::move(*tets),
                           filled->volume * cubed};
    }
    return std::unexpected(*refusal);
}

} // namespace moldwright
