// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/release.h"

#include "base/parallel.h"
#include "castability/certificate.h"
#include "castability/exact_predicates.h"
#include "castability/overhang.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace moldwright {

namespace {

using Eigen::Vector3d;

bool isSound(const IndexedMesh& half) {
    const MeshDiagnosis diagnosis = diagnose(half);
    return diagnosis.usable() && diagnosis.components == 1;
}

/// Faces of the mold's outside: no point of the mold lies beyond their plane by more than rounding, so what
/// moves there moves into free air. Each plane is looked at once, for the block's faces are many triangles.
class Outside {
public:
    Outside(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast)
        : m_half(half), m_meshes{&half, &other, &cast}, m_tolerance(onPlaneTolerance(half)) {}

    [[nodiscard]] bool holds(int f) {
        const Vector3d normal = doubleAreaVector(m_half, f).normalized();
        const double offset = m_half.corner(f, 0).dot(normal);
        const auto [at, isNew] = m_known.try_emplace({normal.x(), normal.y(), normal.z(), offset}, false);
        if (isNew)
            at->second = std::all_of(m_meshes.begin(), m_meshes.end(), [&](const IndexedMesh* mesh) {
                return (mesh->V * normal).maxCoeff() <= offset + m_tolerance;
            });
        return at->second;
    }

private:
    const IndexedMesh& m_half;
    std::array<const IndexedMesh*, 3> m_meshes;
    double m_tolerance;
    std::map<std::array<double, 4>, bool> m_known;
};

std::vector<int> facesNotLeaving(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast,
                                 const Vector3d& d, double tau) {
    Outside outside(half, other, cast);
    std::vector<int> stuck;
    for (int f = 0; f < half.faceCount(); ++f)
        // Turned round: the face as the cast or the other half shows it.
        if (!leavesAlong(half.corner(f, 0), half.corner(f, 2), half.corner(f, 1), d, tau) &&
            !outside.holds(f))
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
    std::vector<char> meets(static_cast<std::size_t>(half.faceCount()), 0);
    constexpr std::size_t grain = 4096;
    parallelFor(meets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int f = static_cast<int>(i);
            const Vector3d centre = (half.corner(f, 0) + half.corner(f, 1) + half.corner(f, 2)) / 3;
            meets[i] = canBeAimedAt(half, f, d) && over.above(centre) > touching;
        }
    });
    std::vector<int> meeting;
    for (std::size_t i = 0; i < meets.size(); ++i)
        if (meets[i] != 0)
            meeting.push_back(static_cast<int>(i));
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
