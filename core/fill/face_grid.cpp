// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/face_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldwright {

namespace {

constexpr double kSameHeight = 0.5;   ///< grid steps: what is nearer counts as touching, not as above
constexpr double kMostSquares = 2000; ///< along one side

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

/// Where a triangle's part between the lines y = low and y = high lies along x.
Range rangeWithin(const std::array<Eigen::Vector2d, 3>& triangle, double low, double high) {
    Range range;
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector2d& a = triangle[k];
        const Eigen::Vector2d& b = triangle[(k + 1) % 3];
        if (a.y() >= low && a.y() <= high)
            range.add(a.x());
        for (const double y : {low, high})
            if ((a.y() < y) != (b.y() < y))
                range.add(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    return range;
}

} // namespace

FaceGrid::FaceGrid(const ProjectedHalf& half) : m_half(half) {
    m_side =
        static_cast<int>(std::clamp(std::sqrt(static_cast<double>(half.faces.size())), 1.0, kMostSquares));
    m_width = 2 * ShadowGrid::reach / m_side;
    m_first.assign(static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side) + 1, 0);
    for (const ShadowFace& face : half.faces)
        visitSquares(face, [&](std::size_t square) { ++m_first[square + 1]; });
    for (std::size_t s = 1; s < m_first.size(); ++s)
        m_first[s] += m_first[s - 1];
    m_faces.resize(static_cast<std::size_t>(m_first.back()));
    std::vector<int> next = m_first;
    for (std::size_t f = 0; f < half.faces.size(); ++f)
        visitSquares(half.faces[f], [&](std::size_t square) {
            m_faces[static_cast<std::size_t>(next[square]++)] = static_cast<int>(f);
        });
}

int FaceGrid::indexOf(double coordinate) const {
    return std::clamp(static_cast<int>((coordinate + ShadowGrid::reach) / m_width), 0, m_side - 1);
}

template <class Visit>
void FaceGrid::visitSquares(const ShadowFace& face, Visit visit) const {
    const std::array<Eigen::Vector2d, 3> triangle = {m_half.corner(face, 0), m_half.corner(face, 1),
                                                     m_half.corner(face, 2)};
    Range rows;
    for (const Eigen::Vector2d& p : triangle)
        rows.add(p.y());
    // A step of margin: rounding must not lose a square that the triangle only just reaches.
    for (int row = indexOf(rows.low - 1); row <= indexOf(rows.high + 1); ++row) {
        const double low = row * m_width - ShadowGrid::reach;
        const Range columns = rangeWithin(triangle, low - 1, low + m_width + 1);
        if (columns.low > columns.high)
            continue;
        for (int column = indexOf(columns.low - 1); column <= indexOf(columns.high + 1); ++column)
            visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(m_side) +
                  static_cast<std::size_t>(column));
    }
}

std::span<const int> FaceGrid::facesNear(const Eigen::Vector2d& p) const {
    const std::size_t square = static_cast<std::size_t>(indexOf(p.y())) * static_cast<std::size_t>(m_side) +
                               static_cast<std::size_t>(indexOf(p.x()));
    const auto from = static_cast<std::size_t>(m_first[square]);
    return std::span(m_faces).subspan(from, static_cast<std::size_t>(m_first[square + 1]) - from);
}

int FaceGrid::topAt(const Eigen::Vector2d& p) const {
    int top = -1;
    double highest = -1;
    for (const int f : facesNear(p)) {
        const ShadowFace& face = m_half.faces[static_cast<std::size_t>(f)];
        const Eigen::Vector2d& a = m_half.corner(face, 0);
        const Eigen::Vector2d& b = m_half.corner(face, 1);
        const Eigen::Vector2d& c = m_half.corner(face, 2);
        if (doubleArea(a, b, p) < 0 || doubleArea(b, c, p) < 0 || doubleArea(c, a, p) < 0)
            continue;
        if (const double height = heightAt(m_half, face, p); height > highest) {
            highest = height;
            top = f;
        }
    }
    return top;
}

bool FaceGrid::coveredAt(const Eigen::Vector2d& p, double z, const std::array<int, 2>& except) const {
    const auto near = facesNear(p);
    return std::any_of(near.begin(), near.end(), [&](int f) {
        const ShadowFace& face = m_half.faces[static_cast<std::size_t>(f)];
        const Eigen::Vector2d& a = m_half.corner(face, 0);
        const Eigen::Vector2d& b = m_half.corner(face, 1);
        const Eigen::Vector2d& c = m_half.corner(face, 2);
        return f != except[0] && f != except[1] && doubleArea(a, b, p) > 0 && doubleArea(b, c, p) > 0 &&
               doubleArea(c, a, p) > 0 && heightAt(m_half, face, p) > z + kSameHeight;
    });
}

} // namespace moldwright
