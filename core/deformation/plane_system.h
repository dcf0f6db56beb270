// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/elastic_body.h"
#include "deformation/sparse_solver.h"

#include <vector>

namespace moldwright {

/// A linear system for positions in the plane's frame, some points held in the plane: x and y solve with A, z
/// with A where the rows and columns of held points are the identity's (a pin, or a point of the parting
/// line, is the row z = 0). Both matrices share their pattern, so each is analysed once.
class PlaneSystem {
public:
    /// `pattern`: lower triangle; `held`: 1 for points held at z = 0.
    PlaneSystem(const Eigen::SparseMatrix<double>& pattern, std::vector<char> held);

    /// Factors A + ε·mean(diag A)·I. A has the pattern given first. False when it is not positive definite.
    [[nodiscard]] bool factor(const Eigen::SparseMatrix<double>& A);

    /// Positions with A·X = B, z of held points 0.
    [[nodiscard]] Positions solve(const Positions& B) const;

    /// The ε·mean(diag A) of the last factor(): add shift·X₀ to B and the solution stays near X₀ where A is
    /// singular.
    [[nodiscard]] double shift() const { return m_shift; }

    [[nodiscard]] const std::vector<char>& held() const { return m_held; }
    [[nodiscard]] double factorBytes() const { return m_xy.factorBytes() + m_z.factorBytes(); }

private:
    std::vector<char> m_held;
    SparseSolver m_xy;
    SparseSolver m_z;
    double m_shift = 0;
};

} // namespace moldwright
