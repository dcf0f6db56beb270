// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/sparse_solver.h"

#include "deformation/supernodal_solve.h"

#include <Eigen/SparseCholesky>
#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <mutex>
#include <optional>

extern "C" void openblas_set_num_threads(int threads);

namespace moldwright {

namespace {

constexpr double kPoorResidual = 1e-6;

/// CHOLMOD asks OpenMP for four threads whatever the machine has, and OpenBLAS sums in an order that depends
/// on its threads: both are held to one. Parallel work is ours, in fixed order.
void holdToOneThread() {
    static const bool once = [] {
        openblas_set_num_threads(1);
        return true;
    }();
    (void)once;
    omp_set_max_active_levels(0);
}

cholmod_sparse viewOf(const Eigen::SparseMatrix<double>& A) {
    cholmod_sparse view{};
    view.nrow = static_cast<std::size_t>(A.rows());
    view.ncol = static_cast<std::size_t>(A.cols());
    view.nzmax = static_cast<std::size_t>(A.nonZeros());
    view.p = const_cast<int*>(A.outerIndexPtr());
    view.i = const_cast<int*>(A.innerIndexPtr());
    view.x = const_cast<double*>(A.valuePtr());
    view.stype = -1; // lower triangle
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

/// What our own solve reads of a factor; nothing when CHOLMOD chose to have no supernodes.
std::optional<SupernodalFactor> viewOf(const cholmod_factor* factor) {
    if (!factor || !factor->is_super || factor->xtype != CHOLMOD_REAL)
        return std::nullopt;
    return SupernodalFactor{static_cast<int>(factor->n),
                            static_cast<int>(factor->nsuper),
                            static_cast<const int*>(factor->super),
                            static_cast<const int*>(factor->pi),
                            static_cast<const int*>(factor->px),
                            static_cast<const int*>(factor->s),
                            static_cast<const double*>(factor->x),
                            static_cast<const int*>(factor->Perm)};
}

} // namespace

struct SparseSolver::State {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    std::optional<SolvePlan> plan; ///< of the factor's pattern
    std::optional<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>> fallback;

    State() {
        holdToOneThread();
        cholmod_start(&common);
        common.print = 0;
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_METIS;
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }
};

SparseSolver::SparseSolver() : m_state(std::make_unique<State>()) {}
SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;

void SparseSolver::analyze(const Eigen::SparseMatrix<double>& A) {
    State& s = *m_state;
    cholmod_free_factor(&s.factor, &s.common);
    s.plan.reset();
    s.fallback.reset();
    cholmod_sparse view = viewOf(A);
    // METIS draws from the one generator of the C library: two at a time would mix their numbers.
    static std::mutex metis;
    const std::lock_guard lock(metis);
    s.factor = cholmod_analyze(&view, &s.common);
}

void SparseSolver::analyzeLike(const SparseSolver& other) {
    State& s = *m_state;
    cholmod_free_factor(&s.factor, &s.common);
    s.plan.reset();
    s.fallback.reset();
    s.factor = cholmod_copy_factor(other.m_state->factor, &s.common);
}

bool SparseSolver::factor(const Eigen::SparseMatrix<double>& A) {
    State& s = *m_state;
    holdToOneThread();
    if (!s.fallback) {
        cholmod_sparse view = viewOf(A);
        const bool done = s.factor && cholmod_factorize(&view, s.factor, &s.common) &&
                          s.common.status == CHOLMOD_OK && viewOf(s.factor);
        // A kernel that miscomputes does so for the shapes of a pattern, whatever the numbers.
        if (done && s.plan)
            return true;
        if (done) {
            s.plan.emplace(*viewOf(s.factor));
            const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 1);
            const Eigen::VectorXd x = solve(b);
            const Eigen::VectorXd residual = A.selfadjointView<Eigen::Lower>() * x - b;
            if (residual.norm() <= kPoorResidual * b.norm())
                return true;
        }
        s.fallback.emplace();
        s.fallback->analyzePattern(A);
    }
    s.fallback->factorize(A);
    return s.fallback->info() == Eigen::Success && (s.fallback->vectorD().array() > 0).all();
}

Eigen::MatrixXd SparseSolver::solve(const Eigen::Ref<const Eigen::MatrixXd>& B) const {
    const State& s = *m_state;
    if (s.fallback)
        return s.fallback->solve(B);
    const std::optional<SupernodalFactor> factor = viewOf(s.factor);
    const Eigen::MatrixXd rhs = B;
    Eigen::MatrixXd X(B.rows(), B.cols());
    for (Eigen::Index c = 0; c < B.cols(); c += 3)
        solveSupernodal(*factor, *s.plan, rhs.col(c).data(), X.col(c).data(),
                        static_cast<int>(std::min<Eigen::Index>(3, B.cols() - c)),
                        static_cast<int>(B.rows()));
    return X;
}

bool SparseSolver::fellBack() const {
    return m_state->fallback.has_value();
}

double SparseSolver::factorBytes() const {
    const State& s = *m_state;
    if (s.fallback)
        return 12.0 * static_cast<double>(s.fallback->matrixL().nestedExpression().nonZeros());
    return 8.0 * static_cast<double>(s.factor->is_super ? s.factor->xsize : s.factor->nzmax);
}

} // namespace moldwright
