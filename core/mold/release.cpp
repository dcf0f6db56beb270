// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/release.h"

#include "base/parallel.h"
#include "base/stop_point.h"
#include "castability/certificate.h"
#include "castability/exact_predicates.h"
#include "castability/overhang.h"
#include "mesh/check.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
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
/// moves there moves into free air. Each plane is looked at once, for the block's faces are many triangles;
/// most others are refuted by a point that refuted one before.
class Outside {
public:
    Outside(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast)
        : m_half(half), m_meshes{&half, &other, &cast}, m_tolerance(onPlaneTolerance(half)) {}

    [[nodiscard]] bool holds(int f) {
        stopPoint();
        const Vector3d normal = doubleAreaVector(m_half, f).normalized();
        const double offset = m_half.corner(f, 0).dot(normal);
        const auto [at, isNew] = m_known.try_emplace({normal.x(), normal.y(), normal.z(), offset}, false);
        if (isNew)
            at->second = !beyond(normal, offset + m_tolerance);
        return at->second;
    }

private:
    [[nodiscard]] bool beyond(const Vector3d& normal, double offset) {
        if (std::any_of(m_refuting.begin(), m_refuting.end(),
                        [&](const Vector3d& p) { return p.dot(normal) > offset; }))
            return true;
        for (const IndexedMesh* mesh : m_meshes) {
            Eigen::Index farthest = 0;
            if ((mesh->V * normal).maxCoeff(&farthest) <= offset)
                continue;
            m_refuting.emplace_back(mesh->V.row(farthest).transpose());
            return true;
        }
        return false;
    }

    const IndexedMesh& m_half;
    std::array<const IndexedMesh*, 3> m_meshes;
    double m_tolerance;
    std::vector<Vector3d> m_refuting;
    std::map<std::array<double, 4>, bool> m_known;
};

/// Where some faces stand, seen along z: places of a grid over them. Tells which faces of other meshes can be
/// near.
class PlanGrid {
public:
    PlanGrid(const IndexedMesh& mesh, const std::vector<int>& faces, double reach) : m_reach(reach) {
        for (const int f : faces)
            m_box.extend(boxOf(mesh, f));
        m_cell = m_box.sizes() / cells;
        for (const int f : faces) {
            const auto [low, high] = range(boxOf(mesh, f));
            for (int i = low[0]; i <= high[0]; ++i)
                for (int j = low[1]; j <= high[1]; ++j)
                    sum(i + 1, j + 1) = 1;
        }
        for (int i = 1; i <= cells; ++i)
            for (int j = 1; j <= cells; ++j)
                sum(i, j) += sum(i - 1, j) + sum(i, j - 1) - sum(i - 1, j - 1);
    }

    void addNear(const IndexedMesh& mesh, IndexedMesh& near) const {
        std::vector<int> faces;
        for (int f = 0; f < mesh.faceCount(); ++f) {
            stopPointAt(f);
            const Eigen::AlignedBox2d box = boxOf(mesh, f);
            if (!box.intersects(m_box))
                continue;
            const auto [low, high] = range(box);
            if (sum(high[0] + 1, high[1] + 1) - sum(low[0], high[1] + 1) - sum(high[0] + 1, low[1]) +
                    sum(low[0], low[1]) >
                0)
                faces.push_back(f);
        }
        const auto first = static_cast<int>(near.V.rows());
        near.V.conservativeResize(first + 3 * static_cast<Eigen::Index>(faces.size()), 3);
        near.F.conservativeResize(near.V.rows() / 3, 3);
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const int v = first + 3 * static_cast<int>(i) + k;
                near.V.row(v) = mesh.corner(faces[i], k).transpose();
                near.F(v / 3, k) = v;
            }
    }

private:
    static constexpr int cells = 512;

    [[nodiscard]] Eigen::AlignedBox2d boxOf(const IndexedMesh& mesh, int f) const {
        Eigen::AlignedBox2d box;
        for (int k = 0; k < 3; ++k)
            box.extend(Eigen::Vector2d(mesh.corner(f, k).head<2>()));
        return {Eigen::Vector2d(box.min().array() - m_reach), Eigen::Vector2d(box.max().array() + m_reach)};
    }
    [[nodiscard]] std::pair<std::array<int, 2>, std::array<int, 2>>
    range(const Eigen::AlignedBox2d& box) const {
        const auto cellOf = [&](const Eigen::Vector2d& p) {
            std::array<int, 2> cell{};
            for (int k = 0; k < 2; ++k)
                cell[static_cast<std::size_t>(k)] =
                    static_cast<int>(std::clamp((p[k] - m_box.min()[k]) / m_cell[k], 0.0, cells - 1.0));
            return cell;
        };
        return {cellOf(box.min()), cellOf(box.max())};
    }
    [[nodiscard]] int& sum(int i, int j) { return m_sums[static_cast<std::size_t>(i * (cells + 1) + j)]; }
    [[nodiscard]] int sum(int i, int j) const {
        return m_sums[static_cast<std::size_t>(i * (cells + 1) + j)];
    }

    double m_reach;
    Eigen::AlignedBox2d m_box;
    Eigen::Vector2d m_cell = Eigen::Vector2d::Zero();
    /// How many places from the corner up to here are taken.
    std::vector<int> m_sums = std::vector<int>(static_cast<std::size_t>((cells + 1) * (cells + 1)), 0);
};

/// A mesh in the way of a half that moves along d.
struct Obstacle {
    Obstacle(const IndexedMesh& obstacle, const Vector3d& d)
        : mesh(obstacle), over(obstacle, allFaces(obstacle), d) {}
    const IndexedMesh& mesh;
    Overhang over;
};
using Obstacles = std::array<const Obstacle*, 2>;

/// Of these faces of a half those that something touches, or that meet something when they move along the
/// obstacles' direction. The others, in bores or lettering, need no draft. Places all over a face are looked
/// at.
class FreeAir {
public:
    FreeAir(const IndexedMesh& half, const std::vector<int>& faces, const Obstacles& obstacles)
        : m_half(half), m_obstacles(obstacles), m_touching(touchingDistance(half)),
          m_same(onPlaneTolerance(half)) {
        const PlanGrid grid(half, faces, 2 * m_same);
        IndexedMesh near;
        for (const Obstacle* obstacle : obstacles)
            grid.addNear(obstacle->mesh, near);
        if (near.faceCount() > 0)
            m_nearest.emplace(near);
    }

    [[nodiscard]] bool holds(int f) const {
        const std::vector<Vector3d> places = placesOn(f);
        const bool meets = std::any_of(places.begin(), places.end(), [&](const Vector3d& p) {
            return std::any_of(m_obstacles.begin(), m_obstacles.end(), [&](const Obstacle* obstacle) {
                return obstacle->over.above(p) > m_touching;
            });
        });
        return !meets && (!m_nearest || std::any_of(places.begin(), places.end(), [&](const Vector3d& p) {
            return m_nearest->distance(p) > m_same;
        }));
    }

private:
    [[nodiscard]] std::vector<Vector3d> placesOn(int f) const {
        constexpr int parts = 8;
        std::vector<Vector3d> places;
        for (int i = 1; i < parts; ++i)
            for (int j = 1; i + j < parts; ++j)
                places.emplace_back((i * m_half.corner(f, 0) + j * m_half.corner(f, 1) +
                                     (parts - i - j) * m_half.corner(f, 2)) /
                                    parts);
        return places;
    }

    const IndexedMesh& m_half;
    Obstacles m_obstacles;
    double m_touching;
    double m_same; ///< surfaces that touch agree to a few units of the grid
    std::optional<ClosestPoint> m_nearest;
};

constexpr std::size_t grain = 4096;

/// The faces of a mesh for which `test` holds, in ascending order.
std::vector<int> facesThat(const IndexedMesh& mesh, const std::function<bool(int)>& test) {
    std::vector<char> holds(static_cast<std::size_t>(mesh.faceCount()), 0);
    parallelFor(holds.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            stopPointAt(static_cast<std::ptrdiff_t>(f));
            holds[f] = test(static_cast<int>(f)) ? 1 : 0;
        }
    });
    std::vector<int> faces;
    for (std::size_t f = 0; f < holds.size(); ++f)
        if (holds[f] != 0)
            faces.push_back(static_cast<int>(f));
    return faces;
}

using Edge = std::array<int, 2>;

Edge edgeOf(const IndexedMesh& mesh, int f, int k) {
    const auto [low, high] = std::minmax(mesh.F(f, k), mesh.F(f, (k + 1) % 3));
    return {low, high};
}

/// Free faces, and those that are thinner than what counts as touching and stand, over none but such, beside
/// one: slivers where a bore's wall ends at the cavity. They go with the wall.
std::set<int> withRimSlivers(const IndexedMesh& half, const std::vector<int>& free) {
    const double thin = touchingDistance(half);
    std::map<Edge, std::vector<int>> thinAt;
    for (const int f : facesThat(half, [&](int face) {
             double longest = 0;
             for (int k = 0; k < 3; ++k)
                 longest = std::max(longest, (half.corner(face, (k + 1) % 3) - half.corner(face, k)).norm());
             return doubleAreaVector(half, face).norm() <= thin * longest;
         }))
        for (int k = 0; k < 3; ++k)
            thinAt[edgeOf(half, f, k)].push_back(f);
    std::set<int> reached(free.begin(), free.end());
    std::vector<int> next = free;
    while (!next.empty()) {
        const int f = next.back();
        next.pop_back();
        for (int k = 0; k < 3; ++k)
            if (const auto beside = thinAt.find(edgeOf(half, f, k)); beside != thinAt.end())
                for (const int g : beside->second)
                    if (reached.insert(g).second)
                        next.push_back(g);
    }
    return reached;
}

std::vector<int> facesNotLeaving(const IndexedMesh& half, const Obstacles& obstacles, const Vector3d& d,
                                 double tau) {
    // Turned round: the face as the cast or the other half shows it.
    std::vector<int> stuck = facesThat(half, [&](int f) {
        return !leavesAlong(half.corner(f, 0), half.corner(f, 2), half.corner(f, 1), d, tau);
    });
    Outside outside(half, obstacles[0]->mesh, obstacles[1]->mesh);
    std::erase_if(stuck, [&](int f) { return outside.holds(f); });
    if (stuck.empty())
        return stuck;
    const FreeAir air(half, stuck, obstacles);
    std::vector<char> isFree(stuck.size(), 0);
    parallelFor(stuck.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            isFree[i] = air.holds(stuck[i]) ? 1 : 0;
    });
    std::vector<int> free;
    std::vector<int> held;
    for (std::size_t i = 0; i < stuck.size(); ++i)
        (isFree[i] != 0 ? free : held).push_back(stuck[i]);
    if (held.empty())
        return held;
    const std::set<int> taken = withRimSlivers(half, free);
    std::erase_if(held, [&](int f) { return taken.contains(f); });
    return held;
}

/// Seen along d, the face is wide enough for a ray to meet it where it should.
bool canBeAimedAt(const IndexedMesh& mesh, int f, const Vector3d& d) {
    const Vector3d e = mesh.corner(f, 1) - mesh.corner(f, 0);
    const Vector3d g = mesh.corner(f, 2) - mesh.corner(f, 0);
    constexpr double thin = 1e-7;
    return std::abs(e.cross(g).dot(d)) > thin * std::max(e.squaredNorm(), g.squaredNorm());
}

Vector3d centreOf(const IndexedMesh& mesh, int f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

/// Faces whose centre meets the obstacle on its way along d. Where half and obstacle touch, rounding puts a
/// centre a little below the surface, and along a steep one it is a long way out: such a way is known by
/// never being deeper than that.
std::vector<int> facesMeeting(const IndexedMesh& half, const Obstacle& obstacle, const Vector3d& d) {
    const double touching = touchingDistance(half);
    std::vector<int> meeting = facesThat(half, [&](int f) {
        return canBeAimedAt(half, f, d) && obstacle.over.above(centreOf(half, f)) > touching;
    });
    constexpr double longest = 1; // mm that rounding can be on its way out
    if (meeting.empty())
        return meeting;
    IndexedMesh near;
    PlanGrid(half, meeting, longest).addNear(obstacle.mesh, near);
    const ClosestPoint surface(near);
    std::erase_if(meeting, [&](int f) {
        const Vector3d from = centreOf(half, f);
        const double way = obstacle.over.above(from);
        constexpr std::array along = {0.25, 0.5, 0.75};
        return way < longest &&
               std::all_of(
                   along.begin(), along.end(),
                   [&](double part) { return surface.distance(from + part * way * d) <= touching; });
    });
    return meeting;
}

} // namespace

HalfRelease examineRelease(const IndexedMesh& half, const IndexedMesh& other, const IndexedMesh& cast,
                           const Vector3d& d, double draftDegrees) {
    HalfRelease release;
    const Obstacle inHalf(other, d);
    const Obstacle inCavity(cast, d);
    release.sound = isSound(half);
    release.stuckFaces = facesNotLeaving(half, {&inHalf, &inCavity}, d, provableTolerance(draftDegrees));
    release.sweptFaces = facesMeeting(half, inCavity, d);
    const std::vector<int> meetingOther = facesMeeting(half, inHalf, d);
    release.sweptFaces.insert(release.sweptFaces.end(), meetingOther.begin(), meetingOther.end());
    return release;
}

bool leavesOther(const IndexedMesh& half, const IndexedMesh& other, const Vector3d& d) {
    return facesMeeting(half, Obstacle(other, d), d).empty();
}

} // namespace moldwright
