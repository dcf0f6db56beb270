// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/geodesic_disc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace moldwright {

namespace {

using Eigen::Vector3d;

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;
constexpr double kBetter = 1e-12; ///< share that a way must gain to be followed anew

/// The way to a point r of a face that comes in over its side pq, whose ends are dp and dq away from the
/// source: the source is laid into the face's plane, on the other side of pq. Infinity where the straight way
/// does not cross that side.
double waySideOn(const Vector3d& p, const Vector3d& q, const Vector3d& r, double dp, double dq) {
    const double length = (q - p).norm();
    if (!(length > 0) || dp == kFar || dq == kFar)
        return kFar;
    const Vector3d along = (q - p) / length;
    const double rx = (r - p).dot(along);
    const double ry = (r - p - rx * along).norm();
    const double sx = (dp * dp - dq * dq + length * length) / (2 * length);
    const double under = dp * dp - sx * sx;
    if (under < -kRounding * dp * dp)
        return kFar;
    const double sy = std::sqrt(std::max(0.0, under)); // 0: the source lies on the side's line
    const double crossing = sy + ry > 0 ? sx + (rx - sx) * sy / (sy + ry) : rx;
    if (crossing < 0 || crossing > length)
        return kFar;
    return std::hypot(rx - sx, ry + sy);
}

/// The way to a point of face f from the distances of its corners other than `except` (−1: of all three).
double wayWithin(const IndexedMesh& mesh, const std::vector<double>& distance, int f, const Vector3d& to,
                 int except) {
    double best = kFar;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const double dp = distance[static_cast<std::size_t>(mesh.F(f, k))];
        if (k != except)
            best = std::min(best, dp + (to - mesh.corner(f, k)).norm());
        if (k != except && next != except)
            best = std::min(best, waySideOn(mesh.corner(f, k), mesh.corner(f, next), to, dp,
                                            distance[static_cast<std::size_t>(mesh.F(f, next))]));
    }
    return best;
}

double longestSideAt(const FaceNeighbours& neighbours, int v) {
    const IndexedMesh& mesh = neighbours.mesh();
    double longest = 0;
    for (const int f : neighbours.around(v))
        for (int k = 0; k < 3; ++k)
            longest = std::max(longest, (mesh.corner(f, k) - mesh.point(v)).norm());
    return longest;
}

/// Ways that get shorter are followed anew: beyond an obtuse corner the short way is found after the long
/// one.
class Wave {
public:
    explicit Wave(const FaceNeighbours& neighbours)
        : m_neighbours(neighbours), m_mesh(neighbours.mesh()),
          m_distance(static_cast<std::size_t>(m_mesh.vertexCount()), kFar) {}

    void start(const SurfacePlace& from) {
        for (int k = 0; k < 3; ++k)
            reach(m_mesh.F(from.face, k), (m_mesh.corner(from.face, k) - from.point).norm());
    }

    void run(double reach) {
        while (!m_queue.empty()) {
            const auto [d, v] = m_queue.top();
            m_queue.pop();
            // A face may reach back by one of its sides to where its middle is near enough.
            if (d == m_distance[static_cast<std::size_t>(v)] && d - longestSideAt(m_neighbours, v) <= reach)
                spread(v);
        }
    }

    [[nodiscard]] std::vector<double>& distance() { return m_distance; }

private:
    using Entry = std::pair<double, int>;

    void reach(int v, double d) {
        double& here = m_distance[static_cast<std::size_t>(v)];
        if (!(d < here - kBetter * d))
            return;
        here = d;
        m_queue.emplace(d, v);
    }

    void spread(int v) {
        for (const int f : m_neighbours.around(v))
            for (int k = 0; k < 3; ++k)
                if (m_mesh.F(f, k) != v)
                    reach(m_mesh.F(f, k), wayWithin(m_mesh, m_distance, f, m_mesh.corner(f, k), k));
    }

    const FaceNeighbours& m_neighbours;
    const IndexedMesh& m_mesh;
    std::vector<double> m_distance;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_queue;
};

} // namespace

std::vector<double> geodesicDistances(const FaceNeighbours& neighbours, const SurfacePlace& from,
                                      double reach) {
    Wave wave(neighbours);
    wave.start(from);
    wave.run(reach);
    return std::move(wave.distance());
}

std::vector<int> geodesicDisc(const FaceNeighbours& neighbours, const SurfacePlace& from, double radius) {
    const IndexedMesh& mesh = neighbours.mesh();
    const std::vector<double> distance = geodesicDistances(neighbours, from, radius);
    std::vector<int> disc = {from.face};
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const bool seen = std::ranges::any_of(std::array{0, 1, 2}, [&](int k) {
            return distance[static_cast<std::size_t>(mesh.F(f, k))] < kFar;
        });
        if (!seen || f == from.face)
            continue;
        const Vector3d middle = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
        if (wayWithin(mesh, distance, f, middle, -1) <= radius)
            disc.push_back(f);
    }
    std::ranges::sort(disc);
    return disc;
}

} // namespace moldwright
