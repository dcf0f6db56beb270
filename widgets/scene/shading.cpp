// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/shading.h"

#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace moldwright::scene {

namespace {

/// The faces about each vertex, as one list with starts.
struct Fans {
    std::vector<int> start;
    std::vector<int> corner; ///< 3·face + k, by vertex
};

Fans fansOf(const IndexedMesh& mesh) {
    Fans fans;
    fans.start.assign(mesh.V.rows() + 1, 0);
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            ++fans.start[mesh.F(f, k) + 1];
    for (std::size_t v = 1; v < fans.start.size(); ++v)
        fans.start[v] += fans.start[v - 1];
    fans.corner.resize(3 * mesh.F.rows());
    std::vector<int> next(fans.start.begin(), fans.start.end() - 1);
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            fans.corner[next[mesh.F(f, k)]++] = 3 * f + k;
    return fans;
}

struct Corner {
    Eigen::Vector3f normal;
    int point = 0;
};

/// The sum over the faces about vertex v that lie within the crease angle of face f, made unit.
Eigen::Vector3f cornerNormal(const Fans& fans, int v, int f, const Points& area, const Points& unit,
                             double cosine) {
    Eigen::RowVector3d sum(0, 0, 0);
    for (int i = fans.start[v]; i < fans.start[v + 1]; ++i) {
        const int other = fans.corner[i] / 3;
        if (unit.row(f).dot(unit.row(other)) >= cosine)
            sum += area.row(other);
    }
    const double length = sum.norm();
    return (length > 0 ? (sum / length).eval() : unit.row(f).eval()).transpose().cast<float>();
}

/// `area` with unit rows; rows of faces without area stay zero.
Points unitRows(const Points& area) {
    Points unit = area;
    for (Eigen::Index f = 0; f < area.rows(); ++f)
        if (const double length = area.row(f).norm(); length > 0)
            unit.row(f) /= length;
    return unit;
}

using FloatRows = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

FloatRows rowsOf(const std::vector<Eigen::Vector3f>& vectors) {
    FloatRows rows(vectors.size(), 3);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = vectors[i].transpose();
    return rows;
}

} // namespace

ShadedMesh shade(const IndexedMesh& mesh, double creaseDegrees) {
    const double cosine = std::cos(creaseDegrees * std::numbers::pi / 180);
    Points area(mesh.faceCount(), 3);
    for (int f = 0; f < mesh.faceCount(); ++f)
        area.row(f) = doubleAreaVector(mesh, f).transpose();
    const Points unit = unitRows(area);
    const Fans fans = fansOf(mesh);

    Triangles faces(mesh.faceCount(), 3);
    std::vector<Eigen::Vector3f> points;
    std::vector<Eigen::Vector3f> normals;
    std::vector<Corner> made;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        made.clear();
        for (int i = fans.start[v]; i < fans.start[v + 1]; ++i) {
            const int f = fans.corner[i] / 3;
            const Eigen::Vector3f normal = cornerNormal(fans, v, f, area, unit, cosine);
            // The same faces are summed in the same order, so equal normals are equal to the bit.
            auto corner = std::ranges::find(made, normal, &Corner::normal);
            if (corner == made.end()) {
                corner = made.insert(made.end(), {normal, static_cast<int>(points.size())});
                points.emplace_back(mesh.point(v).cast<float>());
                normals.push_back(normal);
            }
            faces(f, fans.corner[i] % 3) = corner->point;
        }
    }
    return {rowsOf(points), rowsOf(normals), std::move(faces)};
}

} // namespace moldwright::scene
