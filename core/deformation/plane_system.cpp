// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/plane_system.h"

#include "base/parallel.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr double kShift = 1e-7;

} // namespace

PlaneSystem::PlaneSystem(const Eigen::SparseMatrix<double>& pattern, std::vector<char> held,
                         std::vector<char> fixed)
    : m_held(std::move(held)), m_fixed(std::move(fixed)) {
    m_fixed.resize(m_held.size(), 0);
    for (std::size_t v = 0; v < m_held.size(); ++v)
        m_held[v] = m_held[v] || m_fixed[v];
    m_xy.analyze(pattern);
    if (std::any_of(m_held.begin(), m_held.end(), [](char h) { return h != 0; }))
        m_z.emplace().analyzeLike(m_xy);
}

bool PlaneSystem::factor(const Eigen::SparseMatrix<double>& A) {
    m_shift = kShift * A.diagonal().mean();
    bool done[2] = {false, !m_z};
    parallelFor(m_z ? 2 : 1, 1, [&](std::size_t i, std::size_t) {
        const std::vector<char>& still = i == 1 ? m_held : m_fixed;
        Eigen::SparseMatrix<double> shifted = A;
        for (int c = 0; c < shifted.outerSize(); ++c)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(shifted, c); entry; ++entry) {
                const auto row = static_cast<std::size_t>(entry.row());
                if (still[row] || still[static_cast<std::size_t>(c)])
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
    Positions right = B;
    for (Eigen::Index v = 0; v < B.rows(); ++v) {
        if (m_fixed[static_cast<std::size_t>(v)])
            right.row(v).setZero();
        if (m_held[static_cast<std::size_t>(v)])
            right(v, 2) = 0;
    }
    Positions X(B.rows(), 3);
    parallelFor(2, 1, [&](std::size_t i, std::size_t) {
        if (i == 0)
            X.leftCols<2>() = m_xy.solve(right.leftCols<2>());
        else
            X.col(2) = m_z->solve(Eigen::VectorXd(right.col(2)));
    });
    return X;
}

} // namespace moldwright
