// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/cluster.h"

#include "mesh/measures.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace moldwright {

namespace {

constexpr double kFinest = 1e-6;      ///< of the longest side
constexpr double kKeptArea = 0.7;     ///< below this share thin places were lost: smaller cells
constexpr double kTowardsMean = 1e-2; ///< of the quadric's trace: flat cells keep their points' mean

/// A cell's planes (A x = b where they meet) and the mean of its faces' corners, both weighted by area.
struct Cell {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    double weight = 0;
};

/// A surface of area A meets about 1.5 A/h² cells of size h, and there are two faces a point.
double cellSize(const IndexedMesh& mesh, int targetFaces) {
    return std::max(std::sqrt(3 * surfaceArea(mesh) / targetFaces),
                    kFinest * boundingBox(mesh).sizes().maxCoeff());
}

/// The cell of each point, numbered from 0 in order of first point.
std::vector<int> cellOfPoints(const IndexedMesh& mesh, double size, int& count) {
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    // Only occupied cells take memory: long wires have fine grids.
    std::unordered_map<std::uint64_t, int> number;
    number.reserve(static_cast<std::size_t>(mesh.vertexCount()));
    std::vector<int> cell(static_cast<std::size_t>(mesh.vertexCount()));
    count = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Eigen::Array3d place = ((mesh.point(v) - box.min()).array() / size).max(0);
        const auto at = place.cast<std::uint64_t>();
        const auto [found, isNew] = number.try_emplace((at[2] << 42) + (at[1] << 21) + at[0], count);
        count += isNew;
        cell[static_cast<std::size_t>(v)] = found->second;
    }
    return cell;
}

Eigen::Vector3d pointOf(const Cell& cell, double size) {
    if (!(cell.weight > 0))
        return Eigen::Vector3d::Zero();
    const Eigen::Vector3d mean = cell.moment / cell.weight;
    const double pull = kTowardsMean * cell.A.trace();
    const Eigen::Matrix3d A = cell.A + pull * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d offset = A.ldlt().solve(cell.b - cell.A * mean);
    const double length = offset.norm();
    return length > size ? Eigen::Vector3d(mean + size / length * offset) : Eigen::Vector3d(mean + offset);
}

/// The mesh with one point a cell; faces with two corners in a cell are gone.
IndexedMesh merged(const IndexedMesh& mesh, double size) {
    int count = 0;
    const std::vector<int> cellOf = cellOfPoints(mesh, size, count);
    std::vector<Cell> cells(static_cast<std::size_t>(count));
    std::vector<Eigen::RowVector3i> kept;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const Eigen::Vector3d areaVector = doubleAreaVector(mesh, f);
        const double area = areaVector.norm();
        Eigen::RowVector3i corners;
        for (int k = 0; k < 3; ++k) {
            corners[k] = cellOf[static_cast<std::size_t>(mesh.F(f, k))];
            Cell& cell = cells[static_cast<std::size_t>(corners[k])];
            const Eigen::Vector3d x = mesh.corner(f, k);
            if (area > 0) {
                cell.A += areaVector * areaVector.transpose() / area;
                cell.b += areaVector * (areaVector.dot(x) / area);
            }
            cell.moment += area * x;
            cell.weight += area;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            kept.push_back(corners);
    }
    IndexedMesh reduced;
    reduced.V.resize(count, 3);
    for (int c = 0; c < count; ++c)
        reduced.V.row(c) = pointOf(cells[static_cast<std::size_t>(c)], size).transpose();
    reduced.F.resize(static_cast<Eigen::Index>(kept.size()), 3);
    for (std::size_t f = 0; f < kept.size(); ++f)
        reduced.F.row(static_cast<Eigen::Index>(f)) = kept[f];
    return reduced;
}

} // namespace

IndexedMesh cluster(const IndexedMesh& mesh, int targetFaces) {
    const double area = surfaceArea(mesh);
    double size = cellSize(mesh, targetFaces);
    while (mesh.faceCount() > targetFaces) {
        IndexedMesh reduced = merged(mesh, size);
        if (surfaceArea(reduced) >= kKeptArea * area)
            return reduced;
        if (2 * reduced.faceCount() > mesh.faceCount())
            break;
        size /= 2;
    }
    return mesh;
}

} // namespace moldwright
