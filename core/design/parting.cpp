// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/parting.h"

#include "castability/topology.h"
#include "design/obstructions.h"
#include "exchange/tetrahedralize.h"
#include "mesh/check.h"

namespace moldwright {

namespace {

/// Shares of the shortest edge within which points are snapped to the plane: round faces first, caution
/// later.
constexpr std::array kSnaps = {0.25, 0.1, 0.02, 0.0};

} // namespace

bool planePasses(const IndexedMesh& part, const MoldState& state) {
    const PartedMesh parted = insertPartingLine(WorkingFrame(part, state).toWork(part), kSnaps.front());
    return topologyAllowsCasting(parted.mesh, parted.labels);
}

std::vector<Obstruction> obstructionsAt(const IndexedMesh& part, const MoldState& state) {
    const WorkingFrame frame(part, state);
    const PartedMesh parted = insertPartingLine(frame.toWork(part), kSnaps.front());
    return findObstructions(parted.mesh, parted.labels, frame);
}

Result<PartedSolid> partSolid(const IndexedMesh& part, const MoldState& state, const Task& task) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    std::optional<Error> refusal;
    for (const double snap : kSnaps) {
        if (task.stopped())
            return failure(ErrorCode::Cancelled, MW_TEXT("design", "The design was cancelled."));
        PartedMesh parted = insertPartingLine(work, snap);
        if (!topologyAllowsCasting(parted.mesh, parted.labels)) {
            const auto obstructions = findObstructions(parted.mesh, parted.labels, frame);
            refusal =
                Error{ErrorCode::Impossible, obstructions.front().message, {}, {obstructions.front().place}};
            continue;
        }
        if (!selfIntersections(parted.mesh).empty()) {
            refusal = Error{
                ErrorCode::Internal,
                {MW_TEXT("design", "The parting line could not be inserted without the surface crossing "
                                   "itself."),
                 {}},
                {},
                {}};
            continue;
        }
        Result<TetMesh> tets = tetrahedralize(parted.mesh, task);
        if (tets)
            return PartedSolid{state, frame, std::move(parted), std::move(*tets)};
        refusal = tets.error();
        if (refusal->code == ErrorCode::Cancelled)
            break;
    }
    return std::unexpected(*refusal);
}

} // namespace moldwright
