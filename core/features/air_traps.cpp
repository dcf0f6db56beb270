// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/air_traps.h"

#include "base/stop_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace moldwright {

namespace {

using Eigen::Vector3d;

/// Neighbours and faces of each point.
struct Surroundings {
    std::vector<std::vector<int>> points;
    std::vector<std::vector<int>> faces;

    explicit Surroundings(const IndexedMesh& mesh)
        : points(static_cast<std::size_t>(mesh.vertexCount())),
          faces(static_cast<std::size_t>(mesh.vertexCount())) {
        for (int f = 0; f < mesh.faceCount(); ++f)
            for (int k = 0; k < 3; ++k) {
                const auto v = static_cast<std::size_t>(mesh.F(f, k));
                points[v].push_back(mesh.F(f, (k + 1) % 3));
                faces[v].push_back(f);
            }
    }
};

/// Six times the volume between the plane at `level` and the part of face f above it, seen along `up`.
double sixfoldAbove(const std::array<Vector3d, 3>& corners, const Vector3d& up, double level) {
    std::vector<Vector3d> above;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3d& a = corners[k];
        const Vector3d& b = corners[(k + 1) % 3];
        const double ha = a.dot(up) - level;
        const double hb = b.dot(up) - level;
        if (ha > 0)
            above.push_back(a);
        if ((ha > 0) != (hb > 0))
            above.push_back(a + ha / (ha - hb) * (b - a));
    }
    double sum = 0;
    for (std::size_t k = 1; k + 1 < above.size(); ++k) {
        const Vector3d area = (above[k] - above[0]).cross(above[k + 1] - above[0]);
        const double heights = (above[0] + above[k] + above[k + 1]).dot(up) - 3 * level;
        sum += area.dot(up) * heights; // area/2 · mean height · 6
    }
    return sum;
}

double volumeAbove(const IndexedMesh& cast, const std::vector<int>& faces, const Vector3d& up, double level) {
    double sixfold = 0;
    for (const int f : faces)
        sixfold += sixfoldAbove({cast.corner(f, 0), cast.corner(f, 1), cast.corner(f, 2)}, up, level);
    return sixfold / 6;
}

/// Joins the points from the highest down and notes what meets where.
class Flooding {
public:
    Flooding(const IndexedMesh& cast, const Vector3d& up, int drain)
        : m_cast(cast), m_up(up), m_drain(drain), m_around(cast), m_height(cast.V * up),
          m_root(static_cast<std::size_t>(cast.vertexCount()), -1), m_drained(m_root.size(), false) {}

    std::vector<AirTrap> traps() {
        stopPoint();
        std::vector<int> order(m_root.size());
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](int a, int b) { return higher(a, b); });
        for (const int v : order) {
            stopPointAt(v);
            reach(v);
        }
        return std::move(m_traps);
    }

private:
    [[nodiscard]] bool higher(int a, int b) const {
        return m_height[a] != m_height[b] ? m_height[a] > m_height[b] : a < b;
    }
    int rootOf(int v) {
        while (m_root[static_cast<std::size_t>(v)] != v)
            v = m_root[static_cast<std::size_t>(v)] =
                m_root[static_cast<std::size_t>(m_root[static_cast<std::size_t>(v)])];
        return v;
    }
    void reach(int v) {
        m_root[static_cast<std::size_t>(v)] = v;
        for (const int w : m_around.points[static_cast<std::size_t>(v)])
            if (m_root[static_cast<std::size_t>(w)] >= 0)
                join(rootOf(v), rootOf(w), v);
        if (v == m_drain) {
            const int top = rootOf(v);
            if (top != v)
                note(top, v);
            m_drained[static_cast<std::size_t>(top)] = true;
        }
    }
    /// The root of a region is its highest point. Of two that meet, the lower one without a drain is trapped.
    void join(int a, int b, int at) {
        if (a == b)
            return;
        if (higher(b, a))
            std::swap(a, b);
        const auto high = static_cast<std::size_t>(a);
        const auto low = static_cast<std::size_t>(b);
        if (b != at && (!m_drained[low] || !m_drained[high]))
            note(m_drained[low] ? a : b, at);
        m_drained[high] = m_drained[high] || m_drained[low];
        m_root[low] = a;
    }
    void note(int top, int at) {
        stopPoint();
        AirTrap trap{top, m_height[at], 0, above(top, m_height[at])};
        std::vector<int> faces;
        for (const int v : trap.points)
            faces.insert(faces.end(), m_around.faces[static_cast<std::size_t>(v)].begin(),
                         m_around.faces[static_cast<std::size_t>(v)].end());
        std::sort(faces.begin(), faces.end());
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        trap.volume = volumeAbove(m_cast, faces, m_up, trap.level);
        m_traps.push_back(std::move(trap));
    }
    /// Points above the level that hang together with the top.
    std::vector<int> above(int top, double level) {
        std::vector<int> found{top};
        m_stamp.resize(m_root.size(), 0);
        m_stamp[static_cast<std::size_t>(top)] = ++m_round;
        for (std::size_t next = 0; next < found.size(); ++next)
            for (const int w : m_around.points[static_cast<std::size_t>(found[next])])
                if (m_stamp[static_cast<std::size_t>(w)] != m_round && m_height[w] > level) {
                    m_stamp[static_cast<std::size_t>(w)] = m_round;
                    found.push_back(w);
                }
        return found;
    }

    const IndexedMesh& m_cast;
    Vector3d m_up;
    int m_drain;
    Surroundings m_around;
    Eigen::VectorXd m_height;
    std::vector<int> m_root;
    std::vector<bool> m_drained;
    std::vector<int> m_stamp;
    int m_round = 0;
    std::vector<AirTrap> m_traps;
};

} // namespace

double airAbove(const IndexedMesh& cast, const Vector3d& up, const AirTrap& trap, double level) {
    std::vector<bool> isAbove(static_cast<std::size_t>(cast.vertexCount()), false);
    for (const int v : trap.points)
        isAbove[static_cast<std::size_t>(v)] = true;
    std::vector<int> faces;
    for (int f = 0; f < cast.faceCount(); ++f)
        if (isAbove[static_cast<std::size_t>(cast.F(f, 0))] ||
            isAbove[static_cast<std::size_t>(cast.F(f, 1))] ||
            isAbove[static_cast<std::size_t>(cast.F(f, 2))])
            faces.push_back(f);
    return volumeAbove(cast, faces, up, level);
}

std::vector<AirTrap> airTraps(const IndexedMesh& cast, const Vector3d& up, int drain, double smallest) {
    std::vector<AirTrap> traps = Flooding(cast, up, drain).traps();
    std::erase_if(traps, [&](const AirTrap& trap) { return trap.volume < smallest; });
    std::stable_sort(traps.begin(), traps.end(),
                     [](const AirTrap& a, const AirTrap& b) { return a.volume > b.volume; });
    return traps;
}

} // namespace moldwright
