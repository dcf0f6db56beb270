// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/elastic_body.h"

#include "base/parallel.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace moldwright {

namespace {

/// Blocks that scatter into arrays of their own, summed in this order: fixed, so that threads do not change
/// results.
constexpr std::size_t kBlocks = 8;

int roundUp(int count, int step) {
    return (count + step - 1) / step * step;
}

} // namespace

ElasticBody::ElasticBody(const BodyShape& shape)
    : m_points(static_cast<int>(shape.V.rows())), m_tetCount(static_cast<int>(shape.T.rows())),
      m_faceCount(shape.membrane > 0 ? static_cast<int>(shape.F.rows()) : 0),
      m_faceStart(roundUp(m_tetCount, L)), m_volumeStiffness(shape.volumeStiffness) {
    m_batches.assign(static_cast<std::size_t>((m_faceStart + roundUp(m_faceCount, L)) / L), Batch{});
    const auto point = [&](int v) -> Eigen::Vector3d { return shape.V.row(v).transpose(); };
    for (int t = 0; t < m_tetCount; ++t) {
        const Eigen::RowVector4i c = shape.T.row(t);
        Eigen::Matrix3d edges; // rows
        for (int k = 0; k < 3; ++k)
            edges.row(k) = (point(c[k + 1]) - point(c[0])).transpose();
        const double importance =
            shape.tetWeights.empty() ? 1.0 : shape.tetWeights[static_cast<std::size_t>(t)];
        addElement(t, c, edges.inverse().transpose(), importance * std::abs(edges.determinant()) / 6);
    }
    for (int f = 0; f < m_faceCount; ++f) {
        const Eigen::RowVector3i c = shape.F.row(f);
        const Eigen::Vector3d a = point(c[1]) - point(c[0]);
        const Eigen::Vector3d b = point(c[2]) - point(c[0]);
        const Eigen::Vector3d normal = a.cross(b);
        const double square = std::max(normal.squaredNorm(), 1e-300);
        Eigen::Matrix3d gradients;
        gradients.row(0) = b.cross(normal).transpose() / square;
        gradients.row(1) = normal.cross(a).transpose() / square;
        gradients.row(2).setZero();
        addElement(m_faceStart + f, {c[0], c[1], c[2], c[2]}, gradients, shape.membrane * normal.norm() / 2);
    }
}

int ElasticBody::elementAt(std::size_t batch, int lane) const {
    const int slot = static_cast<int>(batch) * L + lane;
    if (slot < m_faceStart)
        return slot < m_tetCount ? slot : -1;
    const int face = slot - m_faceStart;
    return face < m_faceCount ? m_tetCount + face : -1;
}

void ElasticBody::addElement(int index, const Eigen::Matrix<int, 1, 4>& corners,
                             const Eigen::Matrix3d& gradients, double weight) {
    Batch& batch = m_batches[static_cast<std::size_t>(index / L)];
    const int lane = index % L;
    for (int k = 0; k < 4; ++k)
        batch.corner[k][lane] = corners[k];
    for (int k = 0; k < 9; ++k)
        batch.gradient[k][lane] = gradients(k / 3, k % 3);
    batch.weight[lane] = weight;
}

void ElasticBody::deformationGradients(const Batch& batch, const Positions& X, MatrixBatch& F) const {
    double edge[9][L]; // x_k − x_0, coordinate by coordinate
    for (int i = 0; i < 3; ++i) {
        const double* x = X.col(i).data();
        for (int l = 0; l < L; ++l) {
            const double x0 = x[batch.corner[0][l]];
            edge[i][l] = x[batch.corner[1][l]] - x0;
            edge[3 + i][l] = x[batch.corner[2][l]] - x0;
            edge[6 + i][l] = x[batch.corner[3][l]] - x0;
        }
    }
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int l = 0; l < L; ++l)
                F.m[3 * i + j][l] = edge[i][l] * batch.gradient[j][l] +
                                    edge[3 + i][l] * batch.gradient[3 + j][l] +
                                    edge[6 + i][l] * batch.gradient[6 + j][l];
}

void ElasticBody::scatter(const Batch& batch, const MatrixBatch& M, double factor, Positions& out) {
    for (int i = 0; i < 3; ++i) {
        double* o = out.col(i).data();
        double push[3][L];
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < L; ++l)
                push[k][l] = factor * batch.weight[l] *
                             (M.m[3 * i][l] * batch.gradient[3 * k][l] +
                              M.m[3 * i + 1][l] * batch.gradient[3 * k + 1][l] +
                              M.m[3 * i + 2][l] * batch.gradient[3 * k + 2][l]);
        for (int l = 0; l < L; ++l) {
            o[batch.corner[0][l]] -= push[0][l] + push[1][l] + push[2][l];
            o[batch.corner[1][l]] += push[0][l];
            o[batch.corner[2][l]] += push[1][l];
            o[batch.corner[3][l]] += push[2][l];
        }
    }
}

/// Adds ν(det F − 1)² to the lanes' energies and half its derivative, ν(det F − 1)·cof F, to the residuals.
void ElasticBody::addVolumeTerm(const MatrixBatch& F, double stiffness, MatrixBatch& residual,
                                double* energies) {
    for (int l = 0; l < L; ++l) {
        double cofactor[9];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const int i1 = (i + 1) % 3;
                const int i2 = (i + 2) % 3;
                const int j1 = (j + 1) % 3;
                const int j2 = (j + 2) % 3;
                cofactor[3 * i + j] =
                    F.m[3 * i1 + j1][l] * F.m[3 * i2 + j2][l] - F.m[3 * i1 + j2][l] * F.m[3 * i2 + j1][l];
            }
        const double det = F.m[0][l] * cofactor[0] + F.m[1][l] * cofactor[1] + F.m[2][l] * cofactor[2];
        energies[l] += stiffness * (det - 1) * (det - 1);
        for (int k = 0; k < 9; ++k)
            residual.m[k][l] += stiffness * (det - 1) * cofactor[k];
    }
}

/// Runs perBatch(batch index, scatter target) over all batches in fixed blocks; adds the blocks' targets to
/// *out in order and returns the sum of what perBatch returned.
template <class PerBatch>
double ElasticBody::overBatches(Positions* out, const PerBatch& perBatch) const {
    const std::size_t grain = (m_batches.size() + kBlocks - 1) / kBlocks;
    std::vector<Positions> targets(out ? kBlocks : 0);
    std::vector<double> sums(kBlocks, 0.0);
    parallelFor(m_batches.size(), grain, [&](std::size_t begin, std::size_t end) {
        const std::size_t block = begin / grain;
        Positions none;
        if (out)
            targets[block] = Positions::Zero(m_points, 3);
        for (std::size_t b = begin; b < end; ++b)
            sums[block] += perBatch(b, out ? targets[block] : none);
    });
    if (out)
        for (const Positions& target : targets)
            if (target.rows() > 0)
                *out += target;
    double sum = 0;
    for (const double s : sums)
        sum += s;
    return sum;
}

double ElasticBody::energy(const Positions& X, double weight, Positions& gradient) const {
    return overBatches(&gradient, [&](std::size_t b, Positions& target) {
        const Batch& batch = m_batches[b];
        MatrixBatch F;
        MatrixBatch R;
        deformationGradients(batch, X, F);
        fitRotations(F, R);
        const MatrixBatch whole = F;
        const bool face = static_cast<int>(b) * L >= m_faceStart;
        double sums[L] = {};
        for (int k = 0; k < 9; ++k)
            for (int l = 0; l < L; ++l) {
                F.m[k][l] -= R.m[k][l];
                sums[l] += F.m[k][l] * F.m[k][l];
            }
        if (face) {
            // Only the part within the face counts: ‖(F−R)P‖² = ‖F−R‖² − ‖(F−R)ν‖², ν the rest normal.
            for (int l = 0; l < L; ++l) {
                const auto g = [&](int k) { return batch.gradient[k][l]; };
                Eigen::Vector3d normal(g(1) * g(5) - g(2) * g(4), g(2) * g(3) - g(0) * g(5),
                                       g(0) * g(4) - g(1) * g(3));
                normal.normalize();
                for (int i = 0; i < 3; ++i) {
                    const double along = F.m[3 * i][l] * normal[0] + F.m[3 * i + 1][l] * normal[1] +
                                         F.m[3 * i + 2][l] * normal[2];
                    sums[l] -= along * along;
                }
            }
        }
        if (!face && m_volumeStiffness > 0)
            addVolumeTerm(whole, m_volumeStiffness, F, sums);
        scatter(batch, F, 2 * weight, target);
        double sum = 0;
        for (int l = 0; l < L; ++l)
            sum += batch.weight[l] > 0 ? batch.weight[l] * sums[l] : 0.0;
        return sum;
    });
}

void ElasticBody::fit(const Positions& X, std::vector<Eigen::Matrix3d>& rotations) const {
    rotations.resize(static_cast<std::size_t>(elementCount()));
    overBatches(nullptr, [&](std::size_t b, Positions&) {
        MatrixBatch F;
        MatrixBatch R;
        deformationGradients(m_batches[b], X, F);
        fitRotations(F, R);
        for (int l = 0; l < L; ++l) {
            const int element = elementAt(b, l);
            if (element < 0)
                continue;
            for (int k = 0; k < 9; ++k)
                rotations[static_cast<std::size_t>(element)](k / 3, k % 3) = R.m[k][l];
        }
        return 0.0;
    });
}

Positions ElasticBody::rightHandSide(const std::vector<Eigen::Matrix3d>& rotations) const {
    Positions rhs = Positions::Zero(m_points, 3);
    overBatches(&rhs, [&](std::size_t b, Positions& target) {
        MatrixBatch R{};
        for (int l = 0; l < L; ++l) {
            const int element = elementAt(b, l);
            if (element < 0)
                continue;
            for (int k = 0; k < 9; ++k)
                R.m[k][l] = rotations[static_cast<std::size_t>(element)](k / 3, k % 3);
        }
        scatter(m_batches[b], R, 1, target);
        return 0.0;
    });
    return rhs;
}

namespace {

/// Adds weight · g_a·g_b for the pairs of an element's corners that lie in the lower triangle.
void addStiffness(std::vector<Eigen::Triplet<double>>& triplets, const int* corners, int count,
                  const Eigen::Matrix<double, 4, 3>& g, double weight) {
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            if (corners[a] >= corners[b])
                triplets.emplace_back(corners[a], corners[b], weight * g.row(a).dot(g.row(b)));
}

} // namespace

Eigen::SparseMatrix<double> ElasticBody::laplacian() const {
    std::vector<Eigen::Triplet<double>> triplets;
    for (std::size_t b = 0; b < m_batches.size(); ++b)
        for (int l = 0; l < L; ++l) {
            const Batch& batch = m_batches[b];
            if (!(batch.weight[l] > 0))
                continue;
            Eigen::Matrix<double, 4, 3> g;
            for (int k = 0; k < 9; ++k)
                g(1 + k / 3, k % 3) = batch.gradient[k][l];
            g.row(0) = -(g.row(1) + g.row(2) + g.row(3));
            const int corners[4] = {batch.corner[0][l], batch.corner[1][l], batch.corner[2][l],
                                    batch.corner[3][l]};
            addStiffness(triplets, corners, static_cast<int>(b) * L >= m_faceStart ? 3 : 4, g,
                         batch.weight[l]);
        }
    Eigen::SparseMatrix<double> A(m_points, m_points);
    A.setFromTriplets(triplets.begin(), triplets.end());
    return A;
}

Eigen::SparseMatrix<double> surfaceLaplacian(const Points& V, const Triangles& F) {
    BodyShape shell;
    shell.V = V;
    shell.F = F;
    shell.membrane = 1;
    return ElasticBody(shell).laplacian();
}

} // namespace moldwright
