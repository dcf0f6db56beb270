// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/rotation_fit.h"
#include "mesh/tet_mesh.h"

#include <Eigen/SparseCore>

#include <vector>

namespace moldwright {

/// Positions of all points, a coordinate a column: n×3.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// What an elastic body is made of.
struct BodyShape {
    Points V;                       ///< rest positions; surface points first
    Tetrahedra T;                   ///< may be empty: a shell
    Triangles F;                    ///< surface
    std::vector<double> tetWeights; ///< importance per tetrahedron; empty: all 1
    double membrane = 0;            ///< weight of the surface term, per area
    double volumeStiffness = 0;     ///< ν: weight of each tetrahedron's change of volume
};

/// The as-rigid-as-possible energy of a body and its surface:
///   E(X) = Σ_t w_t vol_t (min_R ‖F_t(X) − R‖² + ν (det F_t − 1)²) + m Σ_f area_f min_R ‖(F_f(X) − R) P_f‖²,
/// F the deformation gradient, P_f the projection to the rest face. The first sum is [Stein 2019], Eq. (4),
/// written per tetrahedron ([Chao 2010]): edge weights are the tetrahedral cotangents; the second is a
/// membrane on the surface. Elements are stored for streaming, eight side by side. Results are the same for
/// any number of threads.
class ElasticBody {
public:
    explicit ElasticBody(const BodyShape& shape);

    [[nodiscard]] int pointCount() const { return m_points; }
    [[nodiscard]] int tetCount() const { return m_tetCount; }
    [[nodiscard]] int faceCount() const { return m_faceCount; }
    /// Tetrahedra first, then faces: the elements that rotations are given for.
    [[nodiscard]] int elementCount() const { return m_tetCount + m_faceCount; }

    /// Energy at X; adds `weight` times its gradient to `gradient` (n×3).
    [[nodiscard]] double energy(const Positions& X, double weight, Positions& gradient) const;

    /// The rotation nearest to each element's deformation gradient at X. [Stein 2019], Eq. (5).
    void fit(const Positions& X, std::vector<Eigen::Matrix3d>& R) const;

    /// Right-hand side Σ w R ∇φ of the global step for given rotations: the X that minimises Σ w‖F(X) − R‖²
    /// solves laplacian() · X = rhs.
    [[nodiscard]] Positions rightHandSide(const std::vector<Eigen::Matrix3d>& R) const;

    /// Σ w ∇φ_a·∇φ_b over all elements, lower triangle, n×n; half the Hessian of the energy at fixed
    /// rotations.
    [[nodiscard]] Eigen::SparseMatrix<double> laplacian() const;

private:
    static constexpr int L = MatrixBatch::kLanes;

    /// Eight elements: corners, gradients of three of the four shape functions (the first is minus their
    /// sum), measure times weight. A face has its third gradient zero; idle lanes have weight 0.
    struct alignas(64) Batch {
        int corner[4][L];
        double gradient[9][L]; ///< of corners 1, 2, 3
        double weight[L];
    };

    void addElement(int index, const Eigen::Matrix<int, 1, 4>& corners, const Eigen::Matrix3d& gradients,
                    double weight);
    void deformationGradients(const Batch& batch, const Positions& X, MatrixBatch& F) const;
    static void scatter(const Batch& batch, const MatrixBatch& M, double factor, Positions& out);
    template <class PerBatch>
    double overBatches(Positions* out, const PerBatch& perBatch) const;

    /// The element that a lane of a batch holds, −1 for an idle lane.
    [[nodiscard]] int elementAt(std::size_t batch, int lane) const;

    static void addVolumeTerm(const MatrixBatch& F, double stiffness, MatrixBatch& residual,
                              double* energies);

    int m_points = 0;
    int m_tetCount = 0;
    int m_faceCount = 0;
    int m_faceStart = 0; ///< first lane of the faces: batches are not mixed
    double m_volumeStiffness = 0;
    std::vector<Batch> m_batches;
};

/// Cotangent Laplacian of a surface, lower triangle, positive semidefinite, n×n with n = V.rows(): Σ area
/// ∇φ_a·∇φ_b.
[[nodiscard]] Eigen::SparseMatrix<double> surfaceLaplacian(const Points& V, const Triangles& F);

} // namespace moldwright
