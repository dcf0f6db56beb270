// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/sparse_solver.h"

#include <Eigen/SparseCholesky>
#include <cholmod.h>
#include <omp.h>

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

cholmod_dense viewOf(const Eigen::Ref<const Eigen::MatrixXd>& B) {
    cholmod_dense view{};
    view.nrow = static_cast<std::size_t>(B.rows());
    view.ncol = static_cast<std::size_t>(B.cols());
    view.d = static_cast<std::size_t>(B.outerStride());
    view.nzmax = view.d * view.ncol;
    view.x = const_cast<double*>(B.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    return view;
}

} // namespace

struct SparseSolver::State {
    cholmod_common common{};
    cholmod_factor* factor = nullptr;
    cholmod_dense* solution = nullptr; // kept between solves: CHOLMOD reuses their memory
    cholmod_dense* workY = nullptr;
    cholmod_dense* workE = nullptr;
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
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&workY, &common);
        cholmod_free_dense(&workE, &common);
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
    s.fallback.reset();
    cholmod_sparse view = viewOf(A);
    // METIS draws from the one generator of the C library: two at a time would mix their numbers.
    static std::mutex metis;
    const std::lock_guard lock(metis);
    s.factor = cholmod_analyze(&view, &s.common);
}

bool SparseSolver::factor(const Eigen::SparseMatrix<double>& A) {
    State& s = *m_state;
    holdToOneThread();
    if (!s.fallback) {
        cholmod_sparse view = viewOf(A);
        const bool done =
            s.factor && cholmod_factorize(&view, s.factor, &s.common) && s.common.status == CHOLMOD_OK;
        if (done) {
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
    State& s = *m_state;
    if (s.fallback)
        return s.fallback->solve(B);
    holdToOneThread();
    cholmod_dense view = viewOf(B);
    cholmod_solve2(CHOLMOD_A, s.factor, &view, nullptr, &s.solution, nullptr, &s.workY, &s.workE, &s.common);
    return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(s.solution->x), B.rows(), B.cols());
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
