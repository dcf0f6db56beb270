// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/working_body.h"

#include "deformation/tet_topology.h"
#include "exchange/tetrahedralize.h"
#include "mesh/closest_point.h"

namespace moldwright {

namespace {

constexpr double kOnSurface = 1e-3; ///< working units: pins no deeper hold a point of the surface

int nearestPoint(const Points& V, const Eigen::Vector3d& p) {
    Eigen::Index nearest = 0;
    (V.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
}

/// The pins (working frame) that want a point of their own: those near a point of the surface take that.
Points pinsInside(const IndexedMesh& work, const std::vector<Pin>& pins, const WorkingFrame& frame) {
    Points inside(static_cast<Eigen::Index>(pins.size()), 3);
    Eigen::Index count = 0;
    const ClosestPoint surface(work);
    for (const Pin& pin : pins) {
        const Eigen::Vector3d p = frame.toWork(pin.point);
        bool again = false;
        for (Eigen::Index i = 0; i < count; ++i)
            again = again || inside.row(i) == p.transpose();
        if (!again && surface.distance(p) > kOnSurface)
            inside.row(count++) = p.transpose();
    }
    inside.conservativeResize(count, Eigen::NoChange);
    return inside;
}

} // namespace

IndexedMesh WorkingBody::surfaceAt(const Positions& X) const {
    return frame.toPart(IndexedMesh{Points(X.topRows(surfacePoints)), shape.F});
}

std::vector<PlacedPin> WorkingBody::pinsAt(const Positions& X) const {
    std::vector<PlacedPin> pins;
    for (const int v : pinned)
        pins.push_back({frame.toPart(Eigen::Vector3d(X.row(v))), v < surfacePoints ? v : -1});
    return pins;
}

void WorkingBody::setPins(const std::vector<Pin>& pins) {
    pinned.clear();
    for (const Pin& pin : pins)
        pinned.push_back(nearestPoint(shape.V, frame.toWork(pin.point)));
}

Result<WorkingBody> workingBody(const IndexedMesh& part, const MoldState& state, const std::vector<Pin>& pins,
                                const std::vector<double>& faceWeights, const Task& task) {
    const WorkingFrame frame(part, state);
    const IndexedMesh work = frame.toWork(part);
    Result<TetMesh> tets = tetrahedralize(work, task, kTetGenSwitches, pinsInside(work, pins, frame));
    if (!tets)
        return std::unexpected(tets.error());
    WorkingBody body{frame, {}, part.vertexCount(), {}};
    body.shape.V = tets->V;
    body.shape.T = tets->T;
    body.shape.F = part.F;
    if (!faceWeights.empty())
        body.shape.tetWeights = tetWeights(tets->T, part.F, faceWeights);
    body.setPins(pins);
    return body;
}

} // namespace moldwright
