// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over rows become vector code.
#include "deformation/supernodal_solve.h"

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
    double* y; ///< right-hand side c in y + c·rows

    [[nodiscard]] const double* column(int j) const { return values + static_cast<std::ptrdiff_t>(j) * rows; }
    [[nodiscard]] double* side(int c) const { return y + static_cast<std::ptrdiff_t>(c) * rows; }
};

/// Solves W columns from j on and takes them out of all rows below.
template <int W, int C>
[[gnu::always_inline]] inline void forwardPanel(const Front<C>& front, int j) {
    const double* column[W];
    for (int k = 0; k < W; ++k)
        column[k] = front.column(j + k);
    for (int c = 0; c < C; ++c) {
        double* __restrict y = front.side(c);
        double x[W];
        for (int k = 0; k < W; ++k) {
            double value = y[j + k];
            for (int i = 0; i < k; ++i)
                value -= column[i][j + k] * x[i];
            x[k] = value / column[k][j + k];
            y[j + k] = x[k];
        }
        for (int i = j + W; i < front.rows; ++i) {
            double sum = column[0][i] * x[0];
            for (int k = 1; k < W; ++k)
                sum += column[k][i] * x[k];
            y[i] -= sum;
        }
    }
}

/// Takes all rows below out of W columns from j on and solves these.
template <int W, int C>
[[gnu::always_inline]] inline void backwardPanel(const Front<C>& front, int j) {
    double lanes[C][W][kLanes] = {};
    const int first = j + W;
    const int whole = first + (front.rows - first) / kLanes * kLanes;
    for (int i = first; i < whole; i += kLanes)
        for (int c = 0; c < C; ++c)
            for (int k = 0; k < W; ++k)
                for (int l = 0; l < kLanes; ++l)
                    lanes[c][k][l] += front.column(j + k)[i + l] * front.side(c)[i + l];
    for (int c = 0; c < C; ++c) {
        double* y = front.side(c);
        double x[W];
        for (int k = W - 1; k >= 0; --k) {
            const double* column = front.column(j + k);
            double sum = 0;
            for (const double lane : lanes[c][k])
                sum += lane;
            for (int i = whole; i < front.rows; ++i)
                sum += column[i] * y[i];
            for (int i = k + 1; i < W; ++i)
                sum += column[j + i] * x[i];
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

/// Both passes over the supernodes, on right-hand sides in the factor's order; x: row by row, C numbers each.
template <int C>
void solveInOrder(const SupernodalFactor& L, std::vector<double>& x) {
    int mostRows = 0;
    for (int s = 0; s < L.supernodes; ++s)
        mostRows = std::max(mostRows, L.firstRow[s + 1] - L.firstRow[s]);
    std::vector<double> y(static_cast<std::size_t>(mostRows) * C);
    const auto frontOf = [&](int s) {
        Front<C> front{L.firstColumn[s + 1] - L.firstColumn[s], L.firstRow[s + 1] - L.firstRow[s],
                       L.values + L.firstValue[s], y.data()};
        const int* rows = L.rows + L.firstRow[s];
        for (int i = 0; i < front.rows; ++i)
            for (int c = 0; c < C; ++c)
                front.side(c)[i] = x[static_cast<std::size_t>(rows[i]) * C + static_cast<std::size_t>(c)];
        return front;
    };
    const auto putBack = [&](int s, const Front<C>& front, int count) {
        const int* rows = L.rows + L.firstRow[s];
        for (int i = 0; i < count; ++i)
            for (int c = 0; c < C; ++c)
                x[static_cast<std::size_t>(rows[i]) * C + static_cast<std::size_t>(c)] = front.side(c)[i];
    };
    for (int s = 0; s < L.supernodes; ++s) {
        const Front<C> front = frontOf(s);
        inVectorCode([&] { forward(front); });
        putBack(s, front, front.rows);
    }
    for (int s = L.supernodes; s-- > 0;) {
        const Front<C> front = frontOf(s);
        inVectorCode([&] { backward(front); });
        putBack(s, front, front.columns);
    }
}

template <int C>
void solveColumns(const SupernodalFactor& L, const double* B, double* X, std::ptrdiff_t stride) {
    std::vector<double> x(static_cast<std::size_t>(L.size) * C);
    for (int i = 0; i < L.size; ++i)
        for (int c = 0; c < C; ++c)
            x[static_cast<std::size_t>(i) * C + static_cast<std::size_t>(c)] = B[L.order[i] + c * stride];
    solveInOrder<C>(L, x);
    for (int i = 0; i < L.size; ++i)
        for (int c = 0; c < C; ++c)
            X[L.order[i] + c * stride] = x[static_cast<std::size_t>(i) * C + static_cast<std::size_t>(c)];
}

} // namespace

void solveSupernodal(const SupernodalFactor& L, const double* B, double* X, int columns, int stride) {
    if (columns == 3)
        solveColumns<3>(L, B, X, stride);
    else if (columns == 2)
        solveColumns<2>(L, B, X, stride);
    else
        solveColumns<1>(L, B, X, stride);
}

} // namespace moldwright
