// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over rows become vector code.
#include "deformation/supernodal_solve.h"

#include "base/parallel.h"
#include "base/vector_code.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace moldwright {

namespace {

constexpr int kLanes = 8;

/// A supernode's dense block and its rows of the right-hand sides, C of them, brought together.
template <int C>
struct Front {
    int columns;
    int rows;
    const double* values;
    double* y; ///< right-hand side c in y + c·stride()

    [[nodiscard]] const double* column(int j) const { return values + static_cast<std::ptrdiff_t>(j) * rows; }
    /// Room for a whole vector of zeros behind the last row.
    [[nodiscard]] std::ptrdiff_t stride() const { return rows + kLanes; }
    [[nodiscard]] double* side(int c) const { return y + c * stride(); }
};

/// Solves W columns from j on and takes them out of all rows below.
template <int W, int C>
[[gnu::always_inline]] inline void forwardPanel(const Front<C>& front, int j) {
    const double* column[W];
    for (int k = 0; k < W; ++k)
        column[k] = front.column(j + k);
    double x[W][C];
    for (int c = 0; c < C; ++c) {
        double* y = front.side(c);
        for (int k = 0; k < W; ++k) {
            double value = y[j + k];
            for (int i = 0; i < k; ++i)
                value -= column[i][j + k] * x[i][c];
            x[k][c] = value / column[k][j + k];
            y[j + k] = x[k][c];
        }
    }
    double* y = front.y;
    const std::ptrdiff_t stride = front.stride();
#pragma GCC ivdep
    for (int i = j + W; i < front.rows; ++i)
        for (int c = 0; c < C; ++c) {
            double sum = column[0][i] * x[0][c];
            for (int k = 1; k < W; ++k)
                sum += column[k][i] * x[k][c];
            y[c * stride + i] -= sum;
        }
}

/// Eight numbers in registers, whatever the width of the processor's: an array of sums would go through
/// memory.
using Vector [[gnu::vector_size(8 * kLanes)]] = double;

[[gnu::always_inline]] inline void load(const double* from, Vector& to) {
    __builtin_memcpy(&to, from, sizeof to);
}

/// Takes all rows below out of W columns from j on and solves these.
template <int W, int C>
[[gnu::always_inline]] inline void backwardPanel(const Front<C>& front, int j) {
    Vector lanes[C][W] = {};
    const auto add = [&](const Vector(&column)[W], int i) __attribute__((always_inline)) {
        for (int c = 0; c < C; ++c) {
            Vector y;
            load(front.side(c) + i, y);
            for (int k = 0; k < W; ++k)
                lanes[c][k] += column[k] * y;
        }
    };
    int i = j + W;
    for (; i + kLanes <= front.rows; i += kLanes) {
        Vector column[W];
        for (int k = 0; k < W; ++k)
            load(front.column(j + k) + i, column[k]);
        add(column, i);
    }
    if (i < front.rows) {
        Vector column[W] = {};
        for (int k = 0; k < W; ++k)
            for (int l = 0; l < front.rows - i; ++l)
                column[k][l] = front.column(j + k)[i + l];
        add(column, i);
    }
    for (int c = 0; c < C; ++c) {
        double* y = front.side(c);
        double x[W];
        for (int k = W - 1; k >= 0; --k) {
            const double* column = front.column(j + k);
            const Vector& v = lanes[c][k];
            double sum = ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
            for (int n = k + 1; n < W; ++n)
                sum += column[j + n] * x[n];
            x[k] = (y[j + k] - sum) / column[j + k];
            y[j + k] = x[k];
        }
    }
}

template <int C>
[[gnu::always_inline]] inline void forward(const Front<C>& front) {
    int j = 0;
    for (; j + 4 <= front.columns; j += 4)
        forwardPanel<4>(front, j);
    for (; j < front.columns; ++j)
        forwardPanel<1>(front, j);
}

template <int C>
[[gnu::always_inline]] inline void backward(const Front<C>& front) {
    int j = front.columns;
    for (; j % 2 != 0; --j)
        backwardPanel<1>(front, j - 1);
    for (; j > 0; j -= 2)
        backwardPanel<2>(front, j - 2);
}

/// A solve of C right-hand sides along its plan.
template <int C>
class Solve {
public:
    Solve(const SupernodalFactor& L, const SolvePlan& plan, const double* B, double* X, std::ptrdiff_t stride)
        : m_factor(L), m_plan(plan), m_B(B), m_X(X), m_stride(stride),
          m_numbers(static_cast<std::size_t>(plan.places) * C) {}

    void run() {
        overSubtrees([&](const SolvePlan::Subtree& tree) { forwardIn(tree); });
        join();
        overSubtrees([&](const SolvePlan::Subtree& tree) { backwardIn(tree); });
    }

private:
    using Subtree = SolvePlan::Subtree;

    template <class Work>
    void overSubtrees(const Work& work) {
        parallelFor(m_plan.subtrees.size(), 1,
                    [&](std::size_t begin, std::size_t) { work(m_plan.subtrees[begin]); });
    }

    double* at(int place) { return m_numbers.data() + static_cast<std::ptrdiff_t>(place) * C; }

    void read(int row, int place) {
        for (int c = 0; c < C; ++c)
            at(place)[c] = m_B[m_factor.order[row] + c * m_stride];
    }
    void write(int row, int place) {
        for (int c = 0; c < C; ++c)
            m_X[m_factor.order[row] + c * m_stride] = at(place)[c];
    }

    Front<C> frontOf(int s, std::vector<double>& y) {
        const SupernodalFactor& L = m_factor;
        const int rows = L.firstRow[s + 1] - L.firstRow[s];
        y.resize(std::max(y.size(), static_cast<std::size_t>(rows + kLanes) * C));
        const Front<C> front{L.firstColumn[s + 1] - L.firstColumn[s], rows, L.values + L.firstValue[s],
                             y.data()};
        const int* place = m_plan.place.data() + L.firstRow[s];
        for (int i = 0; i < rows; ++i)
            for (int c = 0; c < C; ++c)
                front.side(c)[i] = at(place[i])[c];
        for (int c = 0; c < C; ++c)
            std::fill_n(front.side(c) + rows, kLanes, 0.0);
        return front;
    }
    void putBack(int s, const Front<C>& front, int count) {
        const int* place = m_plan.place.data() + m_factor.firstRow[s];
        for (int i = 0; i < count; ++i)
            for (int c = 0; c < C; ++c)
                at(place[i])[c] = front.side(c)[i];
    }
    void forwardAt(int s, std::vector<double>& y) {
        const Front<C> front = frontOf(s, y);
        inVectorCode([&] { forward(front); });
        putBack(s, front, front.rows);
    }
    void backwardAt(int s, std::vector<double>& y) {
        const Front<C> front = frontOf(s, y);
        inVectorCode([&] { backward(front); });
        putBack(s, front, front.columns);
    }

    void forwardIn(const Subtree& tree) {
        std::vector<double> y;
        const int firstRow = m_factor.firstColumn[tree.firstSupernode];
        for (int row = firstRow; row < m_factor.firstColumn[tree.endSupernode]; ++row)
            read(row, tree.ownPlace + row - firstRow);
        for (int s = tree.firstSupernode; s < tree.endSupernode; ++s)
            forwardAt(s, y);
    }

    void backwardIn(const Subtree& tree) {
        std::vector<double> y;
        std::copy_n(at(m_plan.joiningPlace), m_plan.joiningRows.size() * C, at(tree.joiningPlace));
        for (int s = tree.endSupernode; s-- > tree.firstSupernode;)
            backwardAt(s, y);
        const int firstRow = m_factor.firstColumn[tree.firstSupernode];
        for (int row = firstRow; row < m_factor.firstColumn[tree.endSupernode]; ++row)
            write(row, tree.ownPlace + row - firstRow);
    }

    /// Both passes over the joining supernodes, after what the subtrees add to their rows.
    void join() {
        const int count = static_cast<int>(m_plan.joiningRows.size());
        for (int i = 0; i < count; ++i) {
            read(m_plan.joiningRows[static_cast<std::size_t>(i)], m_plan.joiningPlace + i);
            for (const Subtree& tree : m_plan.subtrees)
                for (int c = 0; c < C; ++c)
                    at(m_plan.joiningPlace + i)[c] += at(tree.joiningPlace + i)[c];
        }
        std::vector<double> y;
        for (const int s : m_plan.joining)
            forwardAt(s, y);
        for (std::size_t i = m_plan.joining.size(); i-- > 0;)
            backwardAt(m_plan.joining[i], y);
        for (int i = 0; i < count; ++i)
            write(m_plan.joiningRows[static_cast<std::size_t>(i)], m_plan.joiningPlace + i);
    }

    const SupernodalFactor& m_factor;
    const SolvePlan& m_plan;
    const double* m_B;
    double* m_X;
    std::ptrdiff_t m_stride;
    std::vector<double> m_numbers; ///< the working array, C numbers a row
};

} // namespace

void solveSupernodal(const SupernodalFactor& L, const SolvePlan& plan, const double* B, double* X,
                     int columns, int stride) {
    if (columns == 3)
        Solve<3>(L, plan, B, X, stride).run();
    else if (columns == 2)
        Solve<2>(L, plan, B, X, stride).run();
    else
        Solve<1>(L, plan, B, X, stride).run();
}

} // namespace moldwright
