// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace moldwright {

/// A Cholesky factor P A Pᵀ = L Lᵀ in supernodes: neighbouring columns with one pattern, stored as a dense
/// block of columns. Views what CHOLMOD holds.
struct SupernodalFactor {
    int size = 0;
    int supernodes = 0;
    const int* firstColumn = nullptr; ///< of each supernode, and the end
    const int* firstRow = nullptr;   ///< of each supernode in `rows`, and the end; its own columns come first
    const int* firstValue = nullptr; ///< of each supernode in `values`: a dense block, column by column
    const int* rows = nullptr;
    const double* values = nullptr;
    const int* order = nullptr; ///< P: row i of L is row order[i] of A
};

/// X with A X = B for up to three right-hand sides at once (columns `stride` numbers apart), so that the
/// factor passes through memory only twice. In vector code; the same bits for any vector width.
void solveSupernodal(const SupernodalFactor& L, const double* B, double* X, int columns, int stride);

} // namespace moldwright
