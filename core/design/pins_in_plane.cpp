// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/pins_in_plane.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldwright {

namespace {

constexpr double kAcross = 0.3; ///< of its edge to the pin, that a neighbour comes to lie beyond the plane

/// Where the surface about v lies on one side of the plane only, brings one neighbour to the other.
void crossAt(int v, IndexedMesh& mesh) {
    int nearest = -1;
    bool above = false;
    bool below = false;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.F(f, 0) != v && mesh.F(f, 1) != v && mesh.F(f, 2) != v)
            continue;
        for (int k = 0; k < 3; ++k) {
            const int w = mesh.F(f, k);
            if (w == v)
                continue;
            above = above || mesh.V(w, 2) > 0;
            below = below || mesh.V(w, 2) < 0;
            if (nearest < 0 || std::abs(mesh.V(w, 2)) < std::abs(mesh.V(nearest, 2)))
                nearest = w;
        }
    }
    if (above != below) {
        const double edge = (mesh.point(nearest) - mesh.point(v)).norm();
        mesh.V(nearest, 2) = (above ? -kAcross : kAcross) * edge;
    }
}

/// The place in face f of `to` that p has in the same face of `from`.
Eigen::Vector3d carried(const Eigen::Vector3d& p, int f, const IndexedMesh& from, const IndexedMesh& to) {
    Eigen::Matrix<double, 3, 2> there;
    there << from.corner(f, 1) - from.corner(f, 0), from.corner(f, 2) - from.corner(f, 0);
    Eigen::Matrix<double, 3, 2> here;
    here << to.corner(f, 1) - to.corner(f, 0), to.corner(f, 2) - to.corner(f, 0);
    return to.corner(f, 0) + here * there.colPivHouseholderQr().solve(p - from.corner(f, 0));
}

} // namespace

std::vector<PlacedPin> pinsToWork(std::vector<PlacedPin> pins, const WorkingFrame& frame) {
    for (PlacedPin& pin : pins) {
        pin.place = frame.toWork(pin.place);
        pin.place.z() = 0;
    }
    return pins;
}

IndexedMesh withPinsInPlane(IndexedMesh mesh, const std::vector<PlacedPin>& pins) {
    for (const PlacedPin& pin : pins)
        if (pin.surfacePoint >= 0)
            mesh.V(pin.surfacePoint, 2) = 0;
    for (const PlacedPin& pin : pins)
        if (pin.surfacePoint >= 0)
            crossAt(pin.surfacePoint, mesh);
    return mesh;
}

bool pinsAreInPlane(const IndexedMesh& mesh, const std::vector<PlacedPin>& pins) {
    return std::all_of(pins.begin(), pins.end(), [&](const PlacedPin& pin) {
        return pin.surfacePoint < 0 || mesh.V(pin.surfacePoint, 2) == 0;
    });
}

std::vector<PlacedPin> pinsAfterFilling(std::vector<PlacedPin> pins, const std::vector<int>& sourceVertex) {
    for (PlacedPin& pin : pins)
        if (pin.surfacePoint >= 0) {
            const auto at = std::find(sourceVertex.begin(), sourceVertex.end(), pin.surfacePoint);
            pin.surfacePoint = at == sourceVertex.end() ? -1 : static_cast<int>(at - sourceVertex.begin());
        }
    return pins;
}

IndexedMesh beforePinning(const PartedPart& part, const IndexedMesh& shape, const IndexedMesh& original) {
    IndexedMesh before = part.frame.toPart(part.surface.mesh);
    const std::vector<int>& source = part.surface.sourceFace;
    if (&shape == &original || std::any_of(source.begin(), source.end(), [](int f) { return f < 0; }))
        return before;
    const IndexedMesh bent = before;
    before.V.topRows(original.vertexCount()) = original.V; // points of the input keep their index
    for (int f = 0; f < before.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (const int v = before.F(f, k); v >= original.vertexCount())
                before.V.row(v) =
                    carried(bent.point(v), source[static_cast<std::size_t>(f)], shape, original).transpose();
    return before;
}

std::vector<PinnedPoint> pinnedPoints(const std::vector<PlacedPin>& pins, const PartedPart& part,
                                      const IndexedMesh& cast, const std::vector<int>& sourceVertex) {
    const Points& rest = part.surface.mesh.V;
    std::vector<PinnedPoint> points;
    for (const PlacedPin& pin : pins) {
        Eigen::Vector3d place = part.frame.toPart(pin.place);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < sourceVertex.size() && pin.surfacePoint >= 0; ++i) {
            const double away = (rest.row(sourceVertex[i]) - rest.row(pin.surfacePoint)).norm();
            if (rest(sourceVertex[i], 2) == 0 && away < nearest) {
                nearest = away;
                place = cast.point(static_cast<int>(i));
            }
        }
        points.push_back({place, std::abs(part.state.plane.distance(place))});
    }
    return points;
}

} // namespace moldwright
