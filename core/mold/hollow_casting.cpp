// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/hollow_casting.h"

#include "base/parallel.h"
#include "base/stop_point.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Where upright lines through the points of a grid pass the surface.
class Columns {
public:
    Columns(const IndexedMesh& solid, double step) : m_low(boundingBox(solid).min()), m_step(step) {
        const Vector3d size = boundingBox(solid).sizes();
        m_rows = static_cast<int>(size.y() / step) + 1;
        m_crossings.resize(static_cast<std::size_t>((static_cast<int>(size.x() / step) + 1) * m_rows));
        for (int f = 0; f < solid.faceCount(); ++f)
            add({solid.corner(f, 0), solid.corner(f, 1), solid.corner(f, 2)});
        for (std::vector<double>& column : m_crossings)
            std::sort(column.begin(), column.end());
    }

    [[nodiscard]] std::size_t count() const { return m_crossings.size(); }
    [[nodiscard]] const std::vector<double>& crossings(std::size_t column) const {
        return m_crossings[column];
    }
    [[nodiscard]] Vector2d place(int i, int j) const {
        // Off the middle, so that lines do not run along edges of what was drawn on a grid.
        return m_low.head<2>() + m_step * Vector2d(i + 0.4931, j + 0.5127);
    }
    [[nodiscard]] Vector2d place(std::size_t column) const {
        return place(static_cast<int>(column) / m_rows, static_cast<int>(column) % m_rows);
    }

private:
    void add(const std::array<Vector3d, 3>& t) {
        const auto cross = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
        const Vector2d a = t[0].head<2>();
        const Vector2d b = t[1].head<2>();
        const Vector2d c = t[2].head<2>();
        const double whole = cross(b - a, c - a);
        if (whole == 0)
            return;
        const Vector2d low = (a.cwiseMin(b).cwiseMin(c) - m_low.head<2>()) / m_step;
        const Vector2d high = (a.cwiseMax(b).cwiseMax(c) - m_low.head<2>()) / m_step;
        const int columns = static_cast<int>(m_crossings.size()) / m_rows;
        for (int i = std::max(0, static_cast<int>(low.x()) - 1); i <= high.x() && i < columns; ++i)
            for (int j = std::max(0, static_cast<int>(low.y()) - 1); j <= high.y() && j < m_rows; ++j) {
                const Vector2d p = place(i, j);
                const double wa = cross(b - p, c - p) / whole;
                const double wb = cross(c - p, a - p) / whole;
                if (wa >= 0 && wb >= 0 && wa + wb <= 1)
                    m_crossings[static_cast<std::size_t>(i * m_rows + j)].push_back(
                        wa * t[0].z() + wb * t[1].z() + (1 - wa - wb) * t[2].z());
            }
    }

    Vector3d m_low;
    double m_step;
    int m_rows = 1;
    std::vector<std::vector<double>> m_crossings;
};

/// Places of a column from `low` to `high`, a step apart, that lie deeper than the wall. Distance changes no
/// faster than the place: from one that is far from the wall's inner face to either side, the next are known.
double placesWithin(const ClosestPoint& nearest, const Vector2d& p, const std::array<double, 2>& range,
                    double wall, double step) {
    const auto [low, high] = range;
    const int count = static_cast<int>(std::ceil((high - low) / step - 0.5));
    double within = 0;
    for (int i = 0; i < count;) {
        stopPoint();
        const double beyond = (nearest.distance({p.x(), p.y(), low + (i + 0.5) * step}) - wall) / step;
        const int same = std::clamp(static_cast<int>(std::abs(beyond) - 0.5), 0, count - i - 1);
        within += std::clamp(beyond + 0.5, 0.0, 1.0) * (same + 1);
        i += same + 1;
    }
    return within;
}

} // namespace

double shellVolume(const IndexedMesh& solid, double wall) {
    const double size = boundingBox(solid).sizes().maxCoeff();
    // Never coarser than the wall: then what is within it is told from what is beyond by its distance.
    const double step = std::min(size / 60, std::max(wall / 3, std::min(wall, size / 200)));
    const Columns columns(solid, step);
    const ClosestPoint nearest(solid);
    std::vector<double> inner(columns.count(), 0);
    constexpr std::size_t grain = 64;
    parallelFor(columns.count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t column = begin; column < end; ++column) {
            const std::vector<double>& crossings = columns.crossings(column);
            for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
                inner[column] += placesWithin(nearest, columns.place(column),
                                              {crossings[k], crossings[k + 1]}, wall, step);
        }
    });
    double places = 0;
    for (const double column : inner)
        places += column;
    return volume(solid) - places * step * step * step;
}

} // namespace moldwright
