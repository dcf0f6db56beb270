// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/rotation_lanes.h"
#include "mesh/tet_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <array>
#include <span>
#include <vector>

namespace moldwright {

/// Positions of all points, a coordinate a column: n×3.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// What an elastic body is made of.
struct BodyShape {
    Points V;                             ///< rest positions; surface points first
    Tetrahedra T;                         ///< may be empty: a shell
    Triangles F;                          ///< surface
    std::vector<double> tetWeights;       ///< importance per tetrahedron; empty: all 1
    double membrane = 0;                  ///< weight of the surface term, per area
    double volumeStiffness = 0;           ///< ν: weight of each tetrahedron's change of volume
    std::vector<double> faceWeights = {}; ///< importance per face in the surface term; empty: all 1
};

/// A rotation for each lane of an elastic body.
using Rotations = std::vector<QuaternionBatch>;

[[nodiscard]] Eigen::Quaterniond rotationAt(const Rotations& rotations, int lane);
void setRotation(Rotations& rotations, int lane, const Eigen::Quaterniond& q);

/// The as-rigid-as-possible energy of a body and its surface:
///   E(X) = Σ_t w_t vol_t (min_R ‖F_t(X) − R‖² + ν (det F_t − 1)²) + m Σ_f area_f min_R ‖(F_f(X) − R) P_f‖²,
/// F the deformation gradient, P_f the projection to the rest face. The first sum is [Stein 2019], Eq. (4),
/// written per tetrahedron ([Chao 2010]): edge weights are the tetrahedral cotangents; the second is a
/// membrane on the surface.
///
/// Elements lie in lanes, eight side by side, in blocks of neighbours along a curve through space: a block
/// gathers its points once, works in the processor's cache and in vector code, and leaves what it adds to
/// each of its points in a place of its own; these are summed point by point. So results are the same for any
/// number of threads and any vector width.
class ElasticBody {
public:
    explicit ElasticBody(const BodyShape& shape);

    /// New rest positions and importances of the same elements.
    void setRest(const Points& V, const std::vector<double>& tetWeights);

    [[nodiscard]] int pointCount() const { return m_points; }
    [[nodiscard]] int tetCount() const { return m_tetCount; }
    [[nodiscard]] int faceCount() const { return m_faceCount; }
    /// All lanes, idle ones included.
    [[nodiscard]] int laneCount() const { return static_cast<int>(m_elementOfLane.size()); }
    /// The lane of an element: tetrahedra first, then faces.
    [[nodiscard]] int laneOf(int element) const { return m_laneOf[static_cast<std::size_t>(element)]; }

    /// Energy at X; adds `weight` times its gradient to `gradient` (n×3).
    [[nodiscard]] double energy(const Positions& X, double weight, Positions& gradient) const;

    /// The rotation nearest to each element's deformation gradient at X. [Stein 2019], Eq. (5).
    void fit(const Positions& X, Rotations& R) const;

    /// Right-hand side Σ w R ∇φ of the global step for given rotations: the X that minimises Σ w‖F(X) − R‖²
    /// solves laplacian() · X = rhs.
    [[nodiscard]] Positions rightHandSide(const Rotations& R) const;

    /// Σ w ∇φ_a·∇φ_b over all elements, lower triangle, n×n; half the Hessian of the energy at fixed
    /// rotations.
    [[nodiscard]] const Eigen::SparseMatrix<double>& laplacian() const { return m_laplacian; }

private:
    static constexpr int L = MatrixBatch::kLanes;
    static constexpr std::size_t kBlockElements = 256;
    static constexpr std::size_t kMostPlaces = 4 * kBlockElements;

    /// Eight elements: corners as places within their block, gradients of three of the four shape functions
    /// (the first is minus their sum), measure times weight. A face has its third gradient zero; idle lanes
    /// have weight 0.
    struct alignas(64) Batch {
        int corner[4][L];
        double gradient[9][L]; ///< of corners 1, 2, 3
        double weight[L];
    };

    /// Neighbouring elements of one kind and the points that they use.
    struct Block {
        std::size_t firstBatch, batches;
        std::size_t firstPlace, places; ///< into m_pointOfPlace
        bool faces;
    };
    struct BlockNumbers;

    /// Numbers in groups: those of group g are members[start[g]] … members[start[g + 1] − 1], ascending.
    struct Groups {
        std::vector<int> start;
        std::vector<int> members;
    };
    static Groups grouped(const std::vector<int>& groupOf, std::size_t groups);

    void addBlock(const BodyShape& shape, bool faces, std::span<const int> elements);
    void makePattern();
    void indexTerms();
    void fillLaplacian();
    /// Runs perLane(lane, whether a face, points of its corners) over the lanes that are not idle.
    template <class PerLane>
    void overLanes(const PerLane& perLane) const;
    void gather(const Block& block, const Positions& X, BlockNumbers& numbers) const;
    template <class PerBlock>
    double overBlocks(const Positions* X, Positions* out, const PerBlock& perBlock) const;
    static void deformationGradients(const Batch& batch, const BlockNumbers& numbers, MatrixBatch& F);
    static void scatter(const Batch& batch, const MatrixBatch& M, double factor, BlockNumbers& numbers);
    static void addVolumeTerm(const MatrixBatch& F, double stiffness, MatrixBatch& residual,
                              double* energies);
    static void removeNormalPart(const Batch& batch, const MatrixBatch& residual, double* energies);

    int m_points;
    int m_tetCount;
    int m_faceCount;
    double m_membrane;
    std::vector<double> m_faceWeights; ///< per face; empty: all 1
    double m_volumeStiffness;
    std::vector<Batch> m_batches;
    std::vector<Block> m_blocks;
    std::vector<int> m_elementOfLane; ///< −1 for an idle lane
    std::vector<int> m_laneOf;
    std::vector<int> m_pointOfPlace;
    Groups m_places; ///< of each point
    Eigen::SparseMatrix<double> m_laplacian;
    Groups m_terms; ///< of each entry of the Laplacian: pairs of corners, those of all lanes in turn
};

/// Cotangent Laplacian of a surface, lower triangle, positive semidefinite, n×n with n = V.rows(): Σ area
/// ∇φ_a·∇φ_b.
[[nodiscard]] Eigen::SparseMatrix<double> surfaceLaplacian(const Points& V, const Triangles& F);

} // namespace moldwright
