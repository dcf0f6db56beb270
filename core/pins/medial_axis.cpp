// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/medial_axis.h"

#include "base/parallel.h"
#include "mesh/union_find.h"
#include "pins/cgal/delaunay.h"
#include "pins/cgal/inside_test.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace moldwright {

namespace {

constexpr double kSpread = 1e-4; ///< of a centre's distances to its corners: above, it is rounding alone
constexpr double kSmallestPiece = 0.01; ///< of the largest one's balls
constexpr std::size_t kGrain = 512;
constexpr int kOutside = -1;

/// The ball through the corners of a cell; its radius is not finite or wrong where they lie in a plane.
MedialBall throughCorners(const Points& points, const std::array<int, 4>& corners) {
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d { return points.row(corners[k]).transpose(); };
    const Eigen::Vector3d a = corner(1) - corner(0);
    const Eigen::Vector3d b = corner(2) - corner(0);
    const Eigen::Vector3d c = corner(3) - corner(0);
    const Eigen::Vector3d bc = b.cross(c);
    const Eigen::Vector3d toCentre =
        (a.squaredNorm() * bc + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b)) /
        (2 * a.dot(bc));
    return {corner(0) + toCentre, toCentre.norm()};
}

bool touchesAll(const MedialBall& ball, const Points& points, const std::array<int, 4>& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](int v) {
        const double distance = (points.row(v).transpose() - ball.centre).norm();
        return std::abs(distance - ball.radius) < kSpread; // false too where it is not a number
    });
}

/// The balls of the cells inside the solid, and the number of each cell's.
struct InnerBalls {
    std::vector<MedialBall> balls;
    std::vector<int> ofCell; ///< kOutside where the cell has none
};

InnerBalls innerBalls(const DelaunayCells& cells, const Points& samples, const InsideTest& solid,
                      const Task& task) {
    std::vector<MedialBall> all(cells.corners.size());
    std::vector<char> inner(all.size(), 0);
    parallelFor(all.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !task.stopped(); ++i) {
            all[i] = throughCorners(samples, cells.corners[i]);
            inner[i] = touchesAll(all[i], samples, cells.corners[i]) && solid.inside(all[i].centre) ? 1 : 0;
        }
    });
    InnerBalls result;
    result.ofCell.assign(all.size(), kOutside);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (inner[i]) {
            result.ofCell[i] = static_cast<int>(result.balls.size());
            result.balls.push_back(all[i]);
        }
    return result;
}

/// Walks round an edge of the triangulation from cell to cell.
class Ring {
public:
    Ring(const DelaunayCells& cells, const std::vector<int>& ballOfCell)
        : m_cells(cells), m_ballOfCell(ballOfCell) {}

    /// The balls about the edge between corners i and j of a cell, that cell's first; empty where a cell has
    /// none, or a smaller number than the first, which then sees the same ring.
    const std::vector<int>& about(int first, std::size_t i, std::size_t j) {
        const std::array<int, 4>& corners = m_cells.corners[static_cast<std::size_t>(first)];
        const int a = corners[i];
        const int b = corners[j];
        int ahead = kOutside;
        int behind = kOutside;
        for (const int v : corners)
            if (v != a && v != b)
                (ahead < 0 ? ahead : behind) = v;
        m_balls.clear();
        int cell = first;
        do {
            m_balls.push_back(m_ballOfCell[static_cast<std::size_t>(cell)]);
            cell = across(cell, behind);
            if (cell < first || m_ballOfCell[static_cast<std::size_t>(cell)] < 0) {
                m_balls.clear();
                break;
            }
            behind = std::exchange(ahead, newCorner(cell, a, b, ahead));
        } while (cell != first);
        return m_balls;
    }

private:
    [[nodiscard]] int across(int cell, int corner) const {
        const auto c = static_cast<std::size_t>(cell);
        for (std::size_t k = 0; k < 4; ++k)
            if (m_cells.corners[c][k] == corner)
                return m_cells.neighbours[c][k];
        return kOutside;
    }
    [[nodiscard]] int newCorner(int cell, int a, int b, int c) const {
        for (const int v : m_cells.corners[static_cast<std::size_t>(cell)])
            if (v != a && v != b && v != c)
                return v;
        return kOutside;
    }

    const DelaunayCells& m_cells;
    const std::vector<int>& m_ballOfCell;
    std::vector<int> m_balls;
};

/// Facets with a ball on both sides are edges, edges with a whole ring of balls are fans of triangles.
void join(const DelaunayCells& cells, const std::vector<int>& ballOfCell, MedialMesh& axis) {
    Ring ring(cells, ballOfCell);
    for (std::size_t c = 0; c < cells.corners.size(); ++c) {
        const int ball = ballOfCell[c];
        if (ball < 0)
            continue;
        for (const int other : cells.neighbours[c])
            if (other > static_cast<int>(c) && ballOfCell[static_cast<std::size_t>(other)] >= 0)
                axis.edges.push_back({ball, ballOfCell[static_cast<std::size_t>(other)]});
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j) {
                const std::vector<int>& balls = ring.about(static_cast<int>(c), i, j);
                for (std::size_t k = 2; k < balls.size(); ++k) {
                    axis.triangles.push_back({balls[0], balls[k - 1], balls[k]});
                    if (k + 1 < balls.size())
                        axis.edges.push_back({balls[0], balls[k]});
                }
            }
    }
    std::sort(axis.edges.begin(), axis.edges.end());
    axis.edges.erase(std::unique(axis.edges.begin(), axis.edges.end()), axis.edges.end());
}

/// `axis` without its pieces of few balls.
MedialMesh largePieces(const MedialMesh& axis) {
    UnionFind pieces(axis.size());
    for (const auto& [a, b] : axis.edges)
        pieces.unite(a, b);
    std::vector<int> count(axis.balls.size(), 0);
    for (int i = 0; i < axis.size(); ++i)
        ++count[static_cast<std::size_t>(pieces.rootOf(i))];
    const double least = kSmallestPiece * *std::max_element(count.begin(), count.end());
    MedialMesh large;
    std::vector<int> now(axis.balls.size(), kOutside);
    for (int i = 0; i < axis.size(); ++i)
        if (count[static_cast<std::size_t>(pieces.rootOf(i))] >= least) {
            now[static_cast<std::size_t>(i)] = large.size();
            large.balls.push_back(axis.balls[static_cast<std::size_t>(i)]);
        }
    const auto at = [&](int i) { return now[static_cast<std::size_t>(i)]; };
    for (const auto& [a, b] : axis.edges)
        if (at(a) >= 0)
            large.edges.push_back({at(a), at(b)});
    for (const auto& [a, b, c] : axis.triangles)
        if (at(a) >= 0)
            large.triangles.push_back({at(a), at(b), at(c)});
    return large;
}

} // namespace

MedialMesh medialAxis(const Points& samples, const InsideTest& solid, const Task& task) {
    const DelaunayCells cells = delaunay(samples);
    InnerBalls inner = innerBalls(cells, samples, solid, task);
    if (task.stopped() || inner.balls.empty())
        return {};
    MedialMesh axis;
    axis.balls = std::move(inner.balls);
    join(cells, inner.ofCell, axis);
    return largePieces(axis);
}

} // namespace moldwright
