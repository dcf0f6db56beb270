// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/faces_along.h"

#include "base/stop_point.h"
#include "castability/mold_state.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moldwright {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

FacesAlong::FacesAlong(const IndexedMesh& mesh, const std::vector<int>& faces, const Eigen::Vector3d& d)
    : m_mesh(mesh), m_d(d) {
    const auto [x, y] = planeAxes(d);
    m_axes.row(0) = x.transpose();
    m_axes.row(1) = y.transpose();

    std::vector<int> seen;
    Eigen::AlignedBox2d box;
    for (const int f : faces) {
        stopPointAt(f);
        if (doubleAreaVector(mesh, f).dot(d) == 0)
            continue;
        seen.push_back(f);
        for (int k = 0; k < 3; ++k)
            box.extend(Eigen::Vector2d(m_axes * mesh.corner(f, k)));
    }
    if (box.isEmpty())
        box.extend(Eigen::Vector2d::Zero());
    m_low = box.min();
    const Eigen::Vector2d size = box.sizes();
    const double perFace = size.prod() / std::max<double>(1, static_cast<double>(seen.size()));
    m_cell = std::max({std::sqrt(perFace), size.maxCoeff() / 1000, 1e-300});
    m_columns = static_cast<int>(size.x() / m_cell) + 1;
    m_rows = static_cast<int>(size.y() / m_cell) + 1;
    sortIntoCells(seen);
}

/// Counted first, then filled: one list for all cells is made and given back at once.
void FacesAlong::sortIntoCells(const std::vector<int>& seen) {
    const auto forCellsOf = [&](int f, const auto& found) {
        stopPointAt(f);
        Eigen::AlignedBox2d reach;
        for (int k = 0; k < 3; ++k)
            reach.extend(Eigen::Vector2d(m_axes * m_mesh.corner(f, k)));
        const auto [i0, j0] = cellOf(reach.min());
        const auto [i1, j1] = cellOf(reach.max());
        for (int j = j0; j <= j1; ++j)
            for (int i = i0; i <= i1; ++i)
                found(static_cast<std::size_t>(j * m_columns + i));
    };
    m_first.assign(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows) + 1, 0);
    for (const int f : seen)
        forCellsOf(f, [&](std::size_t cell) { ++m_first[cell + 1]; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_faces.resize(m_first.back());
    std::vector<std::size_t> next = m_first;
    for (const int f : seen)
        forCellsOf(f, [&](std::size_t cell) { m_faces[next[cell]++] = f; });
}

std::array<int, 2> FacesAlong::cellOf(const Eigen::Vector2d& q) const {
    const Eigen::Vector2d c = (q - m_low) / m_cell;
    return {std::clamp(static_cast<int>(std::floor(c.x())), 0, m_columns - 1),
            std::clamp(static_cast<int>(std::floor(c.y())), 0, m_rows - 1)};
}

void FacesAlong::crossings(const Eigen::Vector3d& p, std::vector<Crossing>& found) const {
    found.clear();
    const Eigen::Vector2d q = m_axes * p;
    const auto [i, j] = cellOf(q);
    const auto cell = static_cast<std::size_t>(j * m_columns + i);
    for (std::size_t at = m_first[cell]; at < m_first[cell + 1]; ++at) {
        const int f = m_faces[at];
        std::array<Eigen::Vector2d, 3> c;
        for (int k = 0; k < 3; ++k)
            c[static_cast<std::size_t>(k)] = m_axes * m_mesh.corner(f, k) - q;
        // The same bits but for the sign in both faces of an edge: no line slips through between them.
        const Eigen::Vector3d w(cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1]));
        if (w.isZero(0) || (w.minCoeff() < 0 && w.maxCoeff() > 0))
            continue;
        const Eigen::Vector3d hit =
            (w[0] * m_mesh.corner(f, 0) + w[1] * m_mesh.corner(f, 1) + w[2] * m_mesh.corner(f, 2)) / w.sum();
        found.push_back({f, (hit - p).dot(m_d), w.sum() > 0});
    }
}

} // namespace moldwright
