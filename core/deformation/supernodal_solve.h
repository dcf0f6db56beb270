// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

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

/// The way of a solve through the supernodes of a pattern: subtrees of the elimination tree that have nothing
/// to do with each other and are solved side by side, and the supernodes that join them, solved between their
/// forward and backward passes. A small factor has no subtrees. The same for any number of threads.
///
/// The rows of the right-hand sides lie in a working array: for each subtree its own rows and what it adds to
/// the joining rows, at last the joining rows themselves.
struct SolvePlan {
    struct Subtree {
        int firstSupernode, endSupernode;
        int ownPlace;     ///< of its first row; its rows follow each other as in the factor
        int joiningPlace; ///< of its share of the first joining row
    };
    std::vector<Subtree> subtrees;
    std::vector<int> joining;     ///< supernodes, ascending
    std::vector<int> joiningRows; ///< of the factor, ascending
    int joiningPlace = 0;         ///< of the first joining row itself
    std::vector<int> place;       ///< of each entry of the factor's `rows`, as its supernode sees it
    int places = 0;               ///< in the working array

    SolvePlan() = default;
    /// Reads the pattern only.
    explicit SolvePlan(const SupernodalFactor& L);
};

/// X with A X = B for up to three right-hand sides at once (columns `stride` numbers apart), so that the
/// factor passes through memory only twice; `plan` of its pattern. In vector code; the same bits for any
/// vector width and any number of threads.
void solveSupernodal(const SupernodalFactor& L, const SolvePlan& plan, const double* B, double* X,
                     int columns, int stride);

} // namespace moldwright
