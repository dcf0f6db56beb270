// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/joined_channel.h"

#include "base/stop_point.h"
#include "castability/certificate.h"
#include "castability/exact_predicates.h"
#include "castability/float_rounding.h"
#include "features/cgal/solid_union.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace moldwright {

namespace {

using Eigen::Vector3d;

class PointSet {
public:
    explicit PointSet(const std::vector<Vector3d>& points) {
        for (const Vector3d& p : points)
            m_points.insert({p.x(), p.y(), p.z()});
    }
    [[nodiscard]] bool holdsFace(const IndexedMesh& mesh, int f) const {
        for (int k = 0; k < 3; ++k) {
            const Vector3d p = mesh.corner(f, k);
            if (!m_points.contains({p.x(), p.y(), p.z()}))
                return false;
        }
        return true;
    }

private:
    std::set<std::array<double, 3>> m_points;
};

/// The sides of the faces that are held to the draft; 0 for those that are not. Walls of bores lie along the
/// direction or overhang it, what is left of the cast's own faces has the draft but for rounding.
SideLabels heldToDraft(const IndexedMesh& mesh, SideLabels labels, const JointRequest& request) {
    const double least = std::sin(radians(request.draftDegrees)) / 2;
    for (int f = 0; request.bores && f < mesh.faceCount(); ++f) {
        std::uint8_t& side = labels[static_cast<std::size_t>(f)];
        if (side != 0 && doubleAreaVector(mesh, f).normalized().dot(request.directions.of(side)) < least)
            side = 0;
    }
    return labels;
}

bool keepsDraft(const IndexedMesh& mesh, const SideLabels& labels, const JointRequest& request) {
    const PointSet openings(request.openings);
    const double tau = provableTolerance(request.draftDegrees);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        const int side = labels[static_cast<std::size_t>(f)];
        if (side == 0 && request.bores)
            continue;
        if (side == 0 || (!leavesAlong(mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2),
                                       request.directions.of(side), tau) &&
                          !openings.holdsFace(mesh, f)))
            return false;
    }
    return true;
}

} // namespace

std::optional<IndexedMesh> joinedSolid(const IndexedMesh& cast, const std::vector<IndexedMesh>& bodies,
                                       const JointRequest& request) {
    IndexedMesh whole = cast;
    for (const IndexedMesh& body : bodies) {
        std::optional<IndexedMesh> joined = unionOfSolids(whole, body);
        if (!joined)
            return std::nullopt;
        whole = *std::move(joined);
    }
    const double near = std::max(onPlaneTolerance(whole), request.grid);
    for (int v = 0; v < whole.vertexCount(); ++v)
        if (std::abs(whole.V(v, 2)) <= near)
            whole.V(v, 2) = 0;
    const SideLabels labels = heldToDraft(whole, labelSides(whole, {}), request);
    whole = roundKeepingDraft(whole, labels, request.directions, request.draftDegrees, request.grid);
    const MeshDiagnosis diagnosis = diagnose(whole);
    if (!diagnosis.usable() || !keepsDraft(whole, labels, request))
        return std::nullopt;
    return whole;
}

IndexedMesh openedAt(const IndexedMesh& mesh, const std::vector<Vector3d>& points) {
    const PointSet set(points);
    IndexedMesh opened{mesh.V, Triangles(mesh.F.rows(), 3)};
    Eigen::Index kept = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        if (!set.holdsFace(mesh, f))
            opened.F.row(kept++) = mesh.F.row(f);
    }
    opened.F.conservativeResize(kept, 3);
    return withoutUnusedPoints(opened).mesh;
}

} // namespace moldwright
