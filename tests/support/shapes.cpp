// SPDX-License-Identifier: AGPL-3.0-or-later
#include "support/shapes.h"

#include <Eigen/Geometry>

#include <map>
#include <numbers>

namespace moldwright::test {

IndexedMesh box(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) {
    IndexedMesh mesh;
    mesh.V.resize(8, 3);
    for (int v = 0; v < 8; ++v)
        mesh.V.row(v) << (v & 1 ? hi : lo).x(), (v & 2 ? hi : lo).y(), (v & 4 ? hi : lo).z();
    mesh.F.resize(12, 3);
    mesh.F << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3,
        7, 1, 7, 5;
    return mesh;
}

IndexedMesh splitInFour(const IndexedMesh& mesh) {
    IndexedMesh fine;
    std::map<std::pair<int, int>, int> middle;
    std::vector<Eigen::Vector3d> points;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        points.push_back(mesh.point(v));
    const auto middleOf = [&](int a, int b) {
        const auto [entry, added] = middle.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
        if (added)
            points.push_back((mesh.point(a) + mesh.point(b)) / 2);
        return entry->second;
    };
    fine.F.resize(mesh.faceCount() * 4, 3);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const Eigen::RowVector3i c = mesh.F.row(f);
        const int ab = middleOf(c[0], c[1]);
        const int bc = middleOf(c[1], c[2]);
        const int ca = middleOf(c[2], c[0]);
        fine.F.row(4 * f) << c[0], ab, ca;
        fine.F.row(4 * f + 1) << ab, c[1], bc;
        fine.F.row(4 * f + 2) << ca, bc, c[2];
        fine.F.row(4 * f + 3) << ab, bc, ca;
    }
    fine.V.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        fine.V.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
    return fine;
}

IndexedMesh sphere(const Eigen::Vector3d& c, double radius, int rounds) {
    IndexedMesh mesh;
    mesh.V.resize(6, 3);
    mesh.V << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
    mesh.F.resize(8, 3);
    mesh.F << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
    for (int i = 0; i < rounds; ++i)
        mesh = splitInFour(mesh);
    mesh.V.rowwise().normalize();
    mesh.V = (mesh.V * radius).rowwise() + c.transpose();
    return mesh;
}

IndexedMesh torus(double ringRadius, double tubeRadius, int around, int across) {
    IndexedMesh mesh;
    mesh.V.resize(around * across, 3);
    mesh.F.resize(2 * around * across, 3);
    const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = 2 * std::numbers::pi * i / around;
            const double b = 2 * std::numbers::pi * j / across;
            const double r = ringRadius + tubeRadius * std::cos(b);
            mesh.V.row(at(i, j)) << r * std::cos(a), r * std::sin(a), tubeRadius * std::sin(b);
            mesh.F.row(2 * at(i, j)) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
            mesh.F.row(2 * at(i, j) + 1) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
        }
    return mesh;
}

IndexedMesh together(const IndexedMesh& a, const IndexedMesh& b) {
    IndexedMesh both;
    both.V.resize(a.V.rows() + b.V.rows(), 3);
    both.V << a.V, b.V;
    both.F.resize(a.F.rows() + b.F.rows(), 3);
    both.F << a.F, (b.F.array() + a.vertexCount()).matrix();
    return both;
}

IndexedMesh rotated(const IndexedMesh& mesh, const Eigen::Vector3d& axis, double angle) {
    IndexedMesh result = mesh;
    result.V = mesh.V * Eigen::AngleAxisd(angle, axis).toRotationMatrix().transpose();
    return result;
}

} // namespace moldwright::test
