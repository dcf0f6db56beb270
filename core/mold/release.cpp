// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/release.h"

#include "castability/certificate.h"
#include "castability/exact_predicates.h"
#include "castability/overhang.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moldwright {

namespace {

using Eigen::Vector3d;

bool isSound(const IndexedMesh& half) {
    const MeshDiagnosis diagnosis = diagnose(half);
    return diagnosis.usable() && diagnosis.components == 1;
}

/// Whether no point of the mold lies beyond the plane of face f by more than rounding: what moves there moves
/// into free air.
bool onOutside(const IndexedMesh& half, int f, const IndexedMesh& other, const IndexedMesh& cast) {
    const Vector3d a = half.corner(f, 0);
    const Vector3d normal = doubleAreaVector(half, f).normalized();
    const double tolerance = onPlaneTolerance(half);
    const auto within = [&](const IndexedMesh& mesh) {
        return ((mesh.V.rowwise() - a.transpose()) * normal).maxCoeff() <= tolerance;
    };
    return within(half) && within(other) && within(cast);
}

std::vector<int> facesNotLeaving(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast,
                                 const Vector3d& d, double tau) {
    std::vector<int> stuck;
    for (int f = 0; f < half.faceCount(); ++f)
        // Turned round: the face as the cast or the other half shows it.
        if (!leavesAlong(half.corner(f, 0), half.corner(f, 2), half.corner(f, 1), d, tau) &&
            !onOutside(half, f, other, cast))
            stuck.push_back(f);
    return stuck;
}

/// Seen along d, the face is wide enough for a ray to meet it where it should.
bool canBeAimedAt(const IndexedMesh& mesh, int f, const Vector3d& d) {
    const Vector3d e = mesh.corner(f, 1) - mesh.corner(f, 0);
    const Vector3d g = mesh.corner(f, 2) - mesh.corner(f, 0);
    constexpr double thin = 1e-7;
    return std::abs(e.cross(g).dot(d)) > thin * std::max(e.squaredNorm(), g.squaredNorm());
}

std::vector<int> facesMeeting(const IndexedMesh& half, const IndexedMesh& obstacle, const Vector3d& d) {
    std::vector<int> all(static_cast<std::size_t>(obstacle.faceCount()));
    std::iota(all.begin(), all.end(), 0);
    const Overhang over(obstacle, all, d);
    // Halves and cast touch: a ray starts on the surface that it is compared with.
    const double touching = 16 * onPlaneTolerance(half);
    std::vector<int> meeting;
    for (int f = 0; f < half.faceCount(); ++f) {
        const Vector3d centre = (half.corner(f, 0) + half.corner(f, 1) + half.corner(f, 2)) / 3;
        if (canBeAimedAt(half, f, d) && over.above(centre) > touching)
            meeting.push_back(f);
    }
    return meeting;
}

} // namespace

HalfRelease examineRelease(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast,
                           const Vector3d& d, double draftDegrees) {
    HalfRelease release;
    release.sound = isSound(half);
    release.stuckFaces = facesNotLeaving(half, other, cast, d, provableTolerance(draftDegrees));
    release.sweptFaces = facesMeeting(half, cast, d);
    const std::vector<int> meetingOther = facesMeeting(half, other, d);
    release.sweptFaces.insert(release.sweptFaces.end(), meetingOther.begin(), meetingOther.end());
    return release;
}

bool leavesOther(const IndexedMesh& half, const IndexedMesh& other, const Vector3d& d) {
    return facesMeeting(half, other, d).empty();
}

} // namespace moldwright
