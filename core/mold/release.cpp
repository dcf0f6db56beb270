// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/release.h"

#include "base/parallel.h"
#include "castability/certificate.h"
#include "castability/exact_predicates.h"
#include "castability/overhang.h"
#include "mesh/check.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace moldwright {

namespace {

using Eigen::Vector3d;

std::vector<int> allFaces(const IndexedMesh& mesh) {
    std::vector<int> all(static_cast<std::size_t>(mesh.faceCount()));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// Halves and cast touch: a ray starts on the surface that it is compared with.
double touchingDistance(const IndexedMesh& half) {
    return 16 * onPlaneTolerance(half);
}

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

/// Whether nothing touches a face, and nothing is met when it moves along d: a bore, or lettering in the
/// mold's outside. Such a face needs no draft. Places all over the face are looked at.
class FreeAir {
public:
    FreeAir(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast, const Vector3d& d)
        : m_half(half), m_touching(touchingDistance(half)),
          m_nearest{ClosestPoint(other), ClosestPoint(cast)},
          m_over{Overhang(other, allFaces(other), d), Overhang(cast, allFaces(cast), d)} {}

    [[nodiscard]] bool holds(int f) const {
        constexpr int parts = 8;
        double farthest = 0;
        for (int i = 1; i < parts; ++i)
            for (int j = 1; i + j < parts; ++j) {
                const Vector3d p = (i * m_half.corner(f, 0) + j * m_half.corner(f, 1) +
                                    (parts - i - j) * m_half.corner(f, 2)) /
                                   parts;
                for (const Overhang& over : m_over)
                    if (over.above(p) > m_touching)
                        return false;
                farthest = std::max(farthest, std::min(m_nearest[0].distance(p), m_nearest[1].distance(p)));
            }
        return farthest > m_same;
    }

private:
    const IndexedMesh& m_half;
    double m_touching;
    double m_same; ///< surfaces that touch agree to a unit of the grid
    std::array<ClosestPoint, 2> m_nearest;
    std::array<Overhang, 2> m_over;
};

/// Faces thinner than what counts as touching, where a bore's wall ends at the cavity: they go with the wall.
void addRimSlivers(const IndexedMesh& half, std::vector<int>& stuck, std::vector<int>& free) {
    const double thin = touchingDistance(half);
    std::set<std::array<int, 2>> edges;
    const auto edge = [&](int f, int k) {
        const auto [low, high] = std::minmax(half.F(f, k), half.F(f, (k + 1) % 3));
        return std::array{low, high};
    };
    for (std::size_t next = 0; next < free.size(); ++next) {
        for (int k = 0; k < 3; ++k)
            edges.insert(edge(free[next], k));
        if (next + 1 < free.size())
            continue;
        std::erase_if(stuck, [&](int f) {
            double longest = 0;
            bool beside = false;
            for (int k = 0; k < 3; ++k) {
                longest = std::max(longest, (half.corner(f, (k + 1) % 3) - half.corner(f, k)).norm());
                beside = beside || edges.contains(edge(f, k));
            }
            if (!beside || doubleAreaVector(half, f).norm() > thin * longest)
                return false;
            free.push_back(f);
            return true;
        });
    }
}

std::vector<int> facesNotLeaving(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast,
                                 const Vector3d& d, double tau) {
    Outside outside(half, other, cast);
    std::vector<int> stuck;
    for (int f = 0; f < half.faceCount(); ++f)
        // Turned round: the face as the cast or the other half shows it.
        if (!leavesAlong(half.corner(f, 0), half.corner(f, 2), half.corner(f, 1), d, tau) &&
            !outside.holds(f))
            stuck.push_back(f);
    if (stuck.empty())
        return stuck;
    const FreeAir air(half, other, cast, d);
    std::vector<int> free;
    std::erase_if(stuck, [&](int f) {
        if (!air.holds(f))
            return false;
        free.push_back(f);
        return true;
    });
    addRimSlivers(half, stuck, free);
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
    const Overhang over(obstacle, allFaces(obstacle), d);
    const double touching = touchingDistance(half);
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
