// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/elastic_body.h"
#include "deformation/sparse_solver.h"

#include <optional>
#include <vector>

namespace moldwright {

/// A linear system for positions in the plane's frame, some points held in the plane: x and y solve with A, z
/// with A where the rows and columns of held points are the identity's (a pin, or a point of the parting
/// line, is the row z = 0). Both matrices share their pattern, which is analysed once; where no point is held
/// they are one and factored once.
class PlaneSystem {
public:
    /// `pattern`: lower triangle; `held`: 1 for points held at z = 0; `fixed`: 1 for points whose three
    /// coordinates are all 0 in what is solved, empty for none.
    PlaneSystem(const Eigen::SparseMatrix<double>& pattern, std::vector<char> held,
                std::vector<char> fixed = {});

    /// Factors A + ε·mean(diag A)·I. A has the pattern given first. False when it is not positive definite.
    [[nodiscard]] bool factor(const Eigen::SparseMatrix<double>& A);

    /// Positions with A·X = B, z of held points 0.
    [[nodiscard]] Positions solve(const Positions& B) const;

    /// The ε·mean(diag A) of the last factor(): add shift·X₀ to B and the solution stays near X₀ where A is
    /// singular.
    [[nodiscard]] double shift() const { return m_shift; }

    [[nodiscard]] const std::vector<char>& held() const { return m_held; }
    /// Bytes that a solve streams through memory twice.
    [[nodiscard]] double factorBytes() const { return m_xy.factorBytes() + (m_z ? m_z->factorBytes() : 0); }

private:
    std::vector<char> m_held;
    std::vector<char> m_fixed; ///< per point
    SparseSolver m_xy;
    std::optional<SparseSolver> m_z; ///< none: z solves with m_xy
    double m_shift = 0;
};

} // namespace moldwright
