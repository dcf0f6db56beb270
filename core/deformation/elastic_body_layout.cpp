// SPDX-License-Identifier: AGPL-3.0-or-later
// How an elastic body is laid out, and its Laplacian: what changes with the rest shape only.
#include "deformation/elastic_body.h"

#include "base/parallel.h"

#include <Eigen/LU>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 256;
constexpr std::size_t kEntryGrain = 8192;

/// Corner pairs (a ≥ b) of an element in the order of their entries: those of a face come first.
constexpr int kPairs[10][2] = {{0, 0}, {1, 0}, {1, 1}, {2, 0}, {2, 1},
                               {2, 2}, {3, 0}, {3, 1}, {3, 2}, {3, 3}};
constexpr std::size_t kPairCount = 10;

constexpr std::size_t pairsOf(bool face) {
    return face ? 6 : kPairCount;
}

/// The bits of a number below 2¹⁰ spread to every third place.
std::uint64_t spread(std::uint64_t x) {
    x = (x | (x << 16)) & 0x030000FF;
    x = (x | (x << 8)) & 0x0300F00F;
    x = (x | (x << 4)) & 0x030C30C3;
    return (x | (x << 2)) & 0x09249249;
}

/// Elements (a row of point indices each) in the order of a curve through space. [Morton 1966]
template <class Corners>
std::vector<int> orderInSpace(const Points& V, const Corners& elements) {
    const Eigen::RowVector3d low = V.colwise().minCoeff();
    const double size = std::max((V.colwise().maxCoeff() - low).maxCoeff(), 1e-300);
    std::vector<std::uint64_t> keys(static_cast<std::size_t>(elements.rows()));
    for (Eigen::Index e = 0; e < elements.rows(); ++e) {
        Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
        for (Eigen::Index k = 0; k < elements.cols(); ++k)
            centre += V.row(elements(e, k)) / static_cast<double>(elements.cols());
        const Eigen::RowVector3d at = (centre - low) / size * 1023;
        std::uint64_t code = 0;
        for (int i = 0; i < 3; ++i)
            code |= spread(static_cast<std::uint64_t>(std::clamp(at[i], 0.0, 1023.0))) << i;
        keys[static_cast<std::size_t>(e)] = (code << 32) | static_cast<std::uint64_t>(e);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> order;
    order.reserve(keys.size());
    for (const std::uint64_t key : keys)
        order.push_back(static_cast<int>(key & 0xFFFFFFFF));
    return order;
}

/// Gradients of the shape functions of corners 1, 2, 3 (rows), and the element's measure.
struct Element {
    Eigen::Matrix3d gradients;
    double measure;
};

Element tetrahedron(const Eigen::Vector3d (&x)[4]) {
    Eigen::Matrix3d edges; // rows
    for (int k = 0; k < 3; ++k)
        edges.row(k) = (x[k + 1] - x[0]).transpose();
    return {edges.inverse().transpose(), std::abs(edges.determinant()) / 6};
}

Element triangle(const Eigen::Vector3d (&x)[4]) {
    const Eigen::Vector3d a = x[1] - x[0];
    const Eigen::Vector3d b = x[2] - x[0];
    const Eigen::Vector3d normal = a.cross(b);
    const double square = std::max(normal.squaredNorm(), 1e-300);
    Element element{Eigen::Matrix3d::Zero(), normal.norm() / 2};
    element.gradients.row(0) = b.cross(normal).transpose() / square;
    element.gradients.row(1) = normal.cross(a).transpose() / square;
    return element;
}

} // namespace

ElasticBody::ElasticBody(const BodyShape& shape)
    : m_points(static_cast<int>(shape.V.rows())), m_tetCount(static_cast<int>(shape.T.rows())),
      m_faceCount(shape.membrane > 0 ? static_cast<int>(shape.F.rows()) : 0), m_membrane(shape.membrane),
      m_faceWeights(shape.faceWeights), m_volumeStiffness(shape.volumeStiffness),
      m_laneOf(static_cast<std::size_t>(m_tetCount) + static_cast<std::size_t>(m_faceCount)) {
    const std::vector<int> tets = orderInSpace(shape.V, shape.T);
    for (std::size_t i = 0; i < tets.size(); i += kBlockElements)
        addBlock(shape, false, std::span(tets).subspan(i, std::min(kBlockElements, tets.size() - i)));
    if (m_faceCount > 0) {
        const std::vector<int> faces = orderInSpace(shape.V, shape.F);
        for (std::size_t i = 0; i < faces.size(); i += kBlockElements)
            addBlock(shape, true, std::span(faces).subspan(i, std::min(kBlockElements, faces.size() - i)));
    }
    m_places = grouped(m_pointOfPlace, static_cast<std::size_t>(m_points));
    makePattern();
    setRest(shape.V, shape.tetWeights);
}

void ElasticBody::addBlock(const BodyShape& shape, bool faces, std::span<const int> elements) {
    Block block{m_batches.size(), (elements.size() + L - 1) / L, m_pointOfPlace.size(), 0, faces};
    const auto cornerOf = [&](int element, int k) {
        // A face repeats its last corner, whose gradient there is zero.
        return faces ? shape.F(element, std::min(k, 2)) : shape.T(element, k);
    };
    std::vector<int> points;
    for (const int element : elements)
        for (int k = 0; k < 4; ++k)
            points.push_back(cornerOf(element, k));
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    block.places = points.size();
    m_pointOfPlace.insert(m_pointOfPlace.end(), points.begin(), points.end());
    m_batches.resize(m_batches.size() + block.batches, Batch{});
    m_elementOfLane.resize(m_batches.size() * L, -1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const std::size_t lane = block.firstBatch * L + i;
        const int element = elements[i];
        m_elementOfLane[lane] = faces ? m_tetCount + element : element;
        m_laneOf[static_cast<std::size_t>(m_elementOfLane[lane])] = static_cast<int>(lane);
        for (int k = 0; k < 4; ++k)
            m_batches[lane / L].corner[k][lane % L] = static_cast<int>(
                std::lower_bound(points.begin(), points.end(), cornerOf(element, k)) - points.begin());
    }
    m_blocks.push_back(block);
}

/// Sorts numbers by group: the groups of 0 … n−1 are `groupOf`, −1 for numbers that belong to none.
ElasticBody::Groups ElasticBody::grouped(const std::vector<int>& groupOf, std::size_t groups) {
    Groups result;
    result.start.assign(groups + 1, 0);
    for (const int group : groupOf)
        if (group >= 0)
            ++result.start[static_cast<std::size_t>(group) + 1];
    std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
    std::vector<int> next(result.start.begin(), result.start.end() - 1);
    result.members.resize(static_cast<std::size_t>(result.start.back()));
    for (std::size_t i = 0; i < groupOf.size(); ++i)
        if (const int group = groupOf[i]; group >= 0)
            result.members[static_cast<std::size_t>(next[static_cast<std::size_t>(group)]++)] =
                static_cast<int>(i);
    return result;
}

template <class PerLane>
void ElasticBody::overLanes(const PerLane& perLane) const {
    parallelFor(m_blocks.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            for (std::size_t i = 0; i < m_blocks[b].batches * L; ++i) {
                const std::size_t lane = m_blocks[b].firstBatch * L + i;
                if (m_elementOfLane[lane] < 0)
                    continue;
                std::array<int, 4> corners;
                for (std::size_t k = 0; k < 4; ++k)
                    corners[k] =
                        m_pointOfPlace[m_blocks[b].firstPlace +
                                       static_cast<std::size_t>(m_batches[lane / L].corner[k][lane % L])];
                perLane(lane, m_blocks[b].faces, corners);
            }
    });
}

void ElasticBody::setRest(const Points& V, const std::vector<double>& tetWeights) {
    overLanes([&](std::size_t lane, bool face, const std::array<int, 4>& corners) {
        Eigen::Vector3d x[4];
        for (std::size_t k = 0; k < 4; ++k)
            x[k] = V.row(corners[k]).transpose();
        const Element element = face ? triangle(x) : tetrahedron(x);
        const auto index = static_cast<std::size_t>(m_elementOfLane[lane] - (face ? m_tetCount : 0));
        const std::vector<double>& weights = face ? m_faceWeights : tetWeights;
        const double importance = (face ? m_membrane : 1.0) * (weights.empty() ? 1.0 : weights[index]);
        Batch& batch = m_batches[lane / L];
        for (int k = 0; k < 9; ++k)
            batch.gradient[k][lane % L] = element.gradients(k / 3, k % 3);
        batch.weight[lane % L] = importance * element.measure;
    });
    fillLaplacian();
}

void ElasticBody::makePattern() {
    // Which lanes meet in a column: those whose pairs have it as the lower corner.
    std::vector<std::vector<int>> rows(static_cast<std::size_t>(m_points));
    for (std::size_t v = 0; v < rows.size(); ++v)
        rows[v].push_back(static_cast<int>(v));
    for (const Block& block : m_blocks)
        for (std::size_t lane = block.firstBatch * L; lane < (block.firstBatch + block.batches) * L; ++lane) {
            if (m_elementOfLane[lane] < 0)
                continue;
            for (std::size_t pair = 0; pair < pairsOf(block.faces); ++pair) {
                const auto point = [&](int k) {
                    return m_pointOfPlace[block.firstPlace +
                                          static_cast<std::size_t>(m_batches[lane / L].corner[k][lane % L])];
                };
                const auto [low, high] = std::minmax({point(kPairs[pair][0]), point(kPairs[pair][1])});
                if (low != high)
                    rows[static_cast<std::size_t>(low)].push_back(high);
            }
        }
    parallelFor(rows.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            std::sort(rows[v].begin(), rows[v].end());
            rows[v].erase(std::unique(rows[v].begin(), rows[v].end()), rows[v].end());
        }
    });
    Eigen::Index count = 0;
    for (const std::vector<int>& column : rows)
        count += static_cast<Eigen::Index>(column.size());
    m_laplacian.resize(m_points, m_points);
    m_laplacian.resizeNonZeros(count);
    int* start = m_laplacian.outerIndexPtr();
    int* row = m_laplacian.innerIndexPtr();
    start[0] = 0;
    for (std::size_t v = 0; v < rows.size(); ++v) {
        std::copy(rows[v].begin(), rows[v].end(), row + start[v]);
        start[v + 1] = start[v] + static_cast<int>(rows[v].size());
    }
    indexTerms();
}

/// The entry of the Laplacian that each lane's pairs of corners add to, turned round.
void ElasticBody::indexTerms() {
    const int* start = m_laplacian.outerIndexPtr();
    const int* row = m_laplacian.innerIndexPtr();
    std::vector<int> entryOfTerm(m_elementOfLane.size() * kPairCount, -1);
    overLanes([&](std::size_t lane, bool face, const std::array<int, 4>& corners) {
        for (std::size_t pair = 0; pair < pairsOf(face); ++pair) {
            const auto [low, high] = std::minmax({corners[static_cast<std::size_t>(kPairs[pair][0])],
                                                  corners[static_cast<std::size_t>(kPairs[pair][1])]});
            entryOfTerm[lane * kPairCount + pair] =
                static_cast<int>(std::lower_bound(row + start[low], row + start[low + 1], high) - row);
        }
    });
    m_terms = grouped(entryOfTerm, static_cast<std::size_t>(m_laplacian.nonZeros()));
}

void ElasticBody::fillLaplacian() {
    std::vector<double> terms(m_elementOfLane.size() * kPairCount);
    overLanes([&](std::size_t lane, bool face, const std::array<int, 4>&) {
        const Batch& batch = m_batches[lane / L];
        Eigen::Matrix<double, 4, 3> g;
        for (int k = 0; k < 9; ++k)
            g(1 + k / 3, k % 3) = batch.gradient[k][lane % L];
        g.row(0) = -(g.row(1) + g.row(2) + g.row(3));
        for (std::size_t pair = 0; pair < pairsOf(face); ++pair)
            terms[lane * kPairCount + pair] =
                batch.weight[lane % L] * g.row(kPairs[pair][0]).dot(g.row(kPairs[pair][1]));
    });
    double* value = m_laplacian.valuePtr();
    parallelFor(m_terms.start.size() - 1, kEntryGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t entry = begin; entry < end; ++entry) {
            value[entry] = 0;
            for (int i = m_terms.start[entry]; i < m_terms.start[entry + 1]; ++i)
                value[entry] += terms[static_cast<std::size_t>(m_terms.members[static_cast<std::size_t>(i)])];
        }
    });
}

Eigen::SparseMatrix<double> surfaceLaplacian(const Points& V, const Triangles& F) {
    BodyShape shell;
    shell.V = V;
    shell.F = F;
    shell.membrane = 1;
    return ElasticBody(shell).laplacian();
}

} // namespace moldwright
