// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace moldwright {

/// Solves with a symmetric positive definite matrix whose pattern stays and whose numbers change: analysed
/// once (METIS), factored often (CHOLMOD, supernodal, one BLAS thread: the same bits on any number of
/// threads), solved oftener, in vector code and on all threads by code of our own. The first factorisation is
/// tried on one right-hand side; if its residual is poor (some OpenBLAS kernels miscompute), or CHOLMOD
/// fails, Eigen's factorisation takes over for good. Not thread-safe; different solvers may work in different
/// threads.
class SparseSolver {
public:
    SparseSolver();
    ~SparseSolver();
    SparseSolver(SparseSolver&&) noexcept;
    SparseSolver& operator=(SparseSolver&&) noexcept;

    /// Takes the pattern of the lower triangle of A (compressed columns, rows ascending).
    void analyze(const Eigen::SparseMatrix<double>& A);

    /// Takes over the analysis of another solver for the same pattern.
    void analyzeLike(const SparseSolver& other);

    /// Factors A, which has the analysed pattern. False when A is not positive definite.
    [[nodiscard]] bool factor(const Eigen::SparseMatrix<double>& A);

    /// X with A X = B; B: n×k, column-major.
    [[nodiscard]] Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const;

    /// Whether Eigen had to take over.
    [[nodiscard]] bool fellBack() const;

    /// Bytes of the factor: what a solve streams through memory twice.
    [[nodiscard]] double factorBytes() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace moldwright
