// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "deformation/curve_barrier.h"
#include "deformation/elastic_body.h"
#include "deformation/plane_system.h"
#include "deformation/side_heights.h"

#include <array>
#include <functional>
#include <vector>

namespace moldwright {

/// A body with an inserted parting line, in the plane's frame: what the stages with fixed sides work on.
struct LabelledBody {
    BodyShape shape;        ///< rest shape
    SideLabels labels;      ///< of shape.F
    std::vector<char> held; ///< per point: on the parting line, or pinned
    Directions directions;
    std::vector<char> fixed;              ///< per point: does not move at all; empty: none
    std::vector<std::array<int, 2>> line; ///< the parting line; empty: the edges between the labels
};

/// What one minimisation weighs.
struct StageWeights {
    double elastic = 1; ///< λ
    double hinge = 1;   ///< κ
    double barrier = 0; ///< w
    double tau = 0;
    int iterations = 40;
    double relativeDecrease = 1e-4; ///< stop when ten iterations gain less than this share
};

/// Minimises   λ·ARAP(X) + κ·E_τ(X) + w·barrier(X)   over the positions of a labelled body, by L-BFGS
/// preconditioned with (2λL + κL_surface)⁻¹. No step is so long that the parting curve could cross itself, or
/// that a surface point off the plane could reach it: topology and labels stay true.
class LabelledProblem {
public:
    explicit LabelledProblem(LabelledBody body);

    /// One minimisation from X on. `faceWeights`: the hinge's a_f. `watch` sees the positions after each
    /// iteration and may stop by returning false.
    [[nodiscard]] Positions minimize(const StageWeights& weights, const std::vector<double>& faceWeights,
                                     Positions X, const std::function<bool(const Positions&)>& watch);

    /// The objective itself, for the gradient's test: value at X, gradient into `gradient`.
    [[nodiscard]] double value(const StageWeights& weights, const std::vector<double>& faceWeights,
                               const Positions& X, Positions& gradient) const;

    /// Other removal directions, from the next minimisation on.
    void setDirections(const Directions& directions) { m_body.directions = directions; }

    [[nodiscard]] const LabelledBody& body() const { return m_body; }
    [[nodiscard]] const CurveBarrier& barrier() const { return m_barrier; }
    [[nodiscard]] int iterations() const { return m_iterations; }

    /// Longest step ≤ 1 from X along D that keeps the parting curves simple.
    [[nodiscard]] double largestStep(const Positions& X, const Positions& D) const;

private:
    LabelledBody m_body;
    ElasticBody m_elastic;
    CurveBarrier m_barrier;
    SideHeights m_heights;
    Eigen::SparseMatrix<double> m_bodyLaplacian;
    Eigen::SparseMatrix<double> m_surfaceLaplacian; ///< in the body's pattern
    PlaneSystem m_system;
    int m_iterations = 0;
};

} // namespace moldwright
