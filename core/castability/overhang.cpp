// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/overhang.h"

#include "castability/mold_state.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

Overhang::Overhang(const IndexedMesh& mesh, const std::vector<int>& faces, const Eigen::Vector3d& d)
    : m_mesh(mesh), m_d(d) {
    const auto [x, y] = planeAxes(d);
    m_axes.row(0) = x.transpose();
    m_axes.row(1) = y.transpose();

    std::vector<int> lookingAlong;
    Eigen::AlignedBox2d box;
    for (const int f : faces) {
        if (doubleAreaVector(mesh, f).dot(d) <= 0)
            continue;
        lookingAlong.push_back(f);
        for (int k = 0; k < 3; ++k)
            box.extend(Eigen::Vector2d(m_axes * mesh.corner(f, k)));
    }
    if (box.isEmpty())
        box.extend(Eigen::Vector2d::Zero());
    m_low = box.min();
    const Eigen::Vector2d size = box.sizes();
    const double perFace = size.prod() / std::max<double>(1, static_cast<double>(lookingAlong.size()));
    m_cell = std::max({std::sqrt(perFace), size.maxCoeff() / 1000, 1e-300});
    m_columns = static_cast<int>(size.x() / m_cell) + 1;
    m_rows = static_cast<int>(size.y() / m_cell) + 1;
    m_cells.resize(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    for (const int f : lookingAlong) {
        Eigen::AlignedBox2d reach;
        for (int k = 0; k < 3; ++k)
            reach.extend(Eigen::Vector2d(m_axes * mesh.corner(f, k)));
        const auto [i0, j0] = cellOf(reach.min());
        const auto [i1, j1] = cellOf(reach.max());
        for (int j = j0; j <= j1; ++j)
            for (int i = i0; i <= i1; ++i)
                m_cells[static_cast<std::size_t>(j * m_columns + i)].push_back(f);
    }
}

std::array<int, 2> Overhang::cellOf(const Eigen::Vector2d& q) const {
    const Eigen::Vector2d c = (q - m_low) / m_cell;
    return {std::clamp(static_cast<int>(std::floor(c.x())), 0, m_columns - 1),
            std::clamp(static_cast<int>(std::floor(c.y())), 0, m_rows - 1)};
}

double Overhang::above(const Eigen::Vector3d& p) const {
    const Eigen::Vector2d q = m_axes * p;
    const auto [i, j] = cellOf(q);
    double highest = 0;
    for (const int f : m_cells[static_cast<std::size_t>(j * m_columns + i)]) {
        // Barycentric coordinates in the projection; faces here look along d, so the area is positive.
        std::array<Eigen::Vector2d, 3> c;
        for (int k = 0; k < 3; ++k)
            c[static_cast<std::size_t>(k)] = m_axes * m_mesh.corner(f, k);
        const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
            return a.x() * b.y() - a.y() * b.x();
        };
        const double whole = cross(c[1] - c[0], c[2] - c[0]);
        const double w0 = cross(c[1] - q, c[2] - q) / whole;
        const double w1 = cross(c[2] - q, c[0] - q) / whole;
        const double w2 = 1 - w0 - w1;
        if (!(w0 >= 0 && w1 >= 0 && w2 >= 0))
            continue;
        const Eigen::Vector3d hit =
            w0 * m_mesh.corner(f, 0) + w1 * m_mesh.corner(f, 1) + w2 * m_mesh.corner(f, 2);
        highest = std::max(highest, (hit - p).dot(m_d));
    }
    return highest;
}

} // namespace moldwright
