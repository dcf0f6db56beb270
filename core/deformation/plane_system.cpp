// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/plane_system.h"

#include "base/parallel.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr double kShift = 1e-7;

} // namespace

PlaneSystem::PlaneSystem(const Eigen::SparseMatrix<double>& pattern, std::vector<char> held)
    : m_held(std::move(held)) {
    m_xy.analyze(pattern);
    if (std::any_of(m_held.begin(), m_held.end(), [](char h) { return h != 0; }))
        m_z.emplace().analyzeLike(m_xy);
}

bool PlaneSystem::factor(const Eigen::SparseMatrix<double>& A) {
    m_shift = kShift * A.diagonal().mean();
    bool done[2] = {false, !m_z};
    parallelFor(m_z ? 2 : 1, 1, [&](std::size_t i, std::size_t) {
        Eigen::SparseMatrix<double> shifted = A;
        for (int c = 0; c < shifted.outerSize(); ++c)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(shifted, c); entry; ++entry) {
                const auto row = static_cast<std::size_t>(entry.row());
                if (i == 1 && (m_held[row] || m_held[static_cast<std::size_t>(c)]))
                    entry.valueRef() = entry.row() == c ? 1.0 : 0.0;
                else if (entry.row() == c)
                    entry.valueRef() += m_shift;
            }
        done[i] = (i == 0 ? m_xy : *m_z).factor(shifted);
    });
    return done[0] && done[1];
}

Positions PlaneSystem::solve(const Positions& B) const {
    if (!m_z)
        return m_xy.solve(B);
    Positions X(B.rows(), 3);
    parallelFor(2, 1, [&](std::size_t i, std::size_t) {
        if (i == 0) {
            X.leftCols<2>() = m_xy.solve(B.leftCols<2>());
            return;
        }
        Eigen::VectorXd z = B.col(2);
        for (std::size_t v = 0; v < m_held.size(); ++v)
            if (m_held[v])
                z[static_cast<Eigen::Index>(v)] = 0;
        X.col(2) = m_z->solve(z);
    });
    return X;
}

} // namespace moldwright
