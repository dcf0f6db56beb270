// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/collapsing_axis.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kCostOfLength = 1e-5; ///< beside the error, so that flat places collapse short edges first
constexpr double kPullToMiddle = 1e-3; ///< share of the planes' weight that keeps the ball where they do not
constexpr double kFarthest = 1.5; ///< from the middle, in lengths of the edge: beyond, it is not believed

using Triangle = std::array<int, 3>;

bool uses(const Triangle& t, int v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

bool collapsed(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

Triangle sorted(Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
}

/// The ball that fits the planes best, near the edge; else the best of its ends and its middle.
Sphere bestBall(const SphereQuadric& q, const Sphere& u, const Sphere& v) {
    const Sphere middle = (u + v) / 2;
    const double pull = kPullToMiddle * q.A.trace() / 4;
    if (pull > 0) {
        const Eigen::Matrix4d A = q.A + pull * Eigen::Matrix4d::Identity();
        const Sphere best = A.llt().solve(q.b + pull * middle);
        const double reach = kFarthest * ((u - v).head<3>().norm() + std::abs(u[3] - v[3]));
        if (best.allFinite() && best[3] > 0 && (best - middle).norm() <= reach)
            return best;
    }
    Sphere best = middle;
    for (const Sphere& end : {u, v})
        if (q(end) < q(best))
            best = end;
    return best;
}

} // namespace

CollapsingAxis::CollapsingAxis(const MedialMesh& axis)
    : m_ballCount(axis.size()), m_quadrics(sphereQuadrics(axis)), m_gone(axis.balls.size(), 0),
      m_age(axis.balls.size(), 0), m_neighbours(axis.balls.size()), m_triangles(axis.triangles),
      m_trianglesAt(axis.balls.size()) {
    for (const MedialBall& ball : axis.balls)
        m_spheres.push_back(sphereOf(ball));
    for (const auto& [a, b] : axis.edges) {
        m_neighbours[static_cast<std::size_t>(a)].push_back(b);
        m_neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
        for (const int v : m_triangles[t])
            m_trianglesAt[static_cast<std::size_t>(v)].push_back(static_cast<int>(t));
}

CollapsingAxis::Collapse CollapsingAxis::collapseOf(int u, int v) const {
    const auto i = static_cast<std::size_t>(u);
    const auto j = static_cast<std::size_t>(v);
    SphereQuadric q = m_quadrics[i];
    q += m_quadrics[j];
    const Sphere ball = bestBall(q, m_spheres[i], m_spheres[j]);
    const double ratio = stabilityRatio(m_spheres[i], m_spheres[j]);
    return {(std::max(0.0, q(ball)) + kCostOfLength) * ratio * ratio, ball};
}

bool CollapsingAxis::joined(int u, int v) const {
    const std::vector<int>& around = neighbours(u);
    return std::find(around.begin(), around.end(), v) != around.end();
}

void CollapsingAxis::moveNeighbours(int from, int to) {
    std::erase(m_neighbours[static_cast<std::size_t>(to)], from);
    for (const int w : m_neighbours[static_cast<std::size_t>(from)]) {
        if (w == to)
            continue;
        std::vector<int>& around = m_neighbours[static_cast<std::size_t>(w)];
        if (std::find(around.begin(), around.end(), to) != around.end()) {
            std::erase(around, from);
        } else {
            std::replace(around.begin(), around.end(), from, to);
            m_neighbours[static_cast<std::size_t>(to)].push_back(w);
        }
    }
    m_neighbours[static_cast<std::size_t>(from)].clear();
}

void CollapsingAxis::moveTriangles(int from, int to) {
    std::vector<int>& there = m_trianglesAt[static_cast<std::size_t>(to)];
    for (const int t : m_trianglesAt[static_cast<std::size_t>(from)]) {
        Triangle& triangle = m_triangles[static_cast<std::size_t>(t)];
        if (collapsed(triangle))
            continue;
        std::replace(triangle.begin(), triangle.end(), from, to);
        if (!collapsed(triangle))
            there.push_back(t);
    }
    m_trianglesAt[static_cast<std::size_t>(from)].clear();
}

int CollapsingAxis::collapse(int u, int v, const Sphere& ball) {
    const auto load = [&](int i) {
        return neighbours(i).size() + m_trianglesAt[static_cast<std::size_t>(i)].size();
    };
    // What hangs on fewer is moved: so each thing is moved seldom.
    if (load(u) < load(v))
        std::swap(u, v);
    moveNeighbours(v, u);
    moveTriangles(v, u);
    m_spheres[static_cast<std::size_t>(u)] = ball;
    m_quadrics[static_cast<std::size_t>(u)] += m_quadrics[static_cast<std::size_t>(v)];
    m_gone[static_cast<std::size_t>(v)] = 1;
    ++m_age[static_cast<std::size_t>(u)];
    --m_ballCount;
    return u;
}

/// The different triangles at an edge.
std::vector<Triangle> CollapsingAxis::facesAt(int u, int v) const {
    std::vector<Triangle> faces;
    for (const int t : m_trianglesAt[static_cast<std::size_t>(u)]) {
        const Triangle& triangle = m_triangles[static_cast<std::size_t>(t)];
        if (!collapsed(triangle) && uses(triangle, v))
            faces.push_back(sorted(triangle));
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

bool CollapsingAxis::losesEndOrLoop(int u, int v) const {
    if (neighbours(u).size() == 1 || neighbours(v).size() == 1)
        return true;
    for (const int w : neighbours(u)) {
        if (w == v || !joined(w, v))
            continue;
        const std::vector<Triangle> faces = facesAt(u, v);
        const bool filled = std::binary_search(faces.begin(), faces.end(), sorted({u, v, w}));
        if (!filled && faces.size() <= 1 && facesAt(v, w).size() <= 1 && facesAt(w, u).size() <= 1)
            return true;
    }
    return false;
}

MedialMesh CollapsingAxis::axis() const {
    MedialMesh axis;
    std::vector<int> now(m_spheres.size(), -1);
    for (int v = 0; v < numbers(); ++v)
        if (!gone(v)) {
            now[static_cast<std::size_t>(v)] = axis.size();
            const Sphere& m = m_spheres[static_cast<std::size_t>(v)];
            axis.balls.push_back({m.head<3>(), m[3]});
        }
    const auto at = [&](int v) { return now[static_cast<std::size_t>(v)]; };
    for (int v = 0; v < numbers(); ++v)
        for (const int w : neighbours(v))
            if (v < w)
                axis.edges.push_back({at(v), at(w)});
    for (const Triangle& t : m_triangles)
        if (!collapsed(t))
            axis.triangles.push_back(sorted({at(t[0]), at(t[1]), at(t[2])}));
    std::sort(axis.edges.begin(), axis.edges.end());
    std::sort(axis.triangles.begin(), axis.triangles.end());
    axis.triangles.erase(std::unique(axis.triangles.begin(), axis.triangles.end()), axis.triangles.end());
    return axis;
}

} // namespace moldwright
