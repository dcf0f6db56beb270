// SPDX-License-Identifier: AGPL-3.0-or-later
#include "support/casts.h"

#include "support/shapes.h"

namespace moldwright::test {

namespace {

/// Rows of four points each, joined by walls; first and last row closed by a lid.
IndexedMesh stack(const Points& rows) {
    IndexedMesh mesh;
    mesh.V = rows;
    const int n = mesh.vertexCount();
    mesh.F.resize(2 * n - 4, 3);
    mesh.F.row(0) << 0, 2, 1;
    mesh.F.row(1) << 0, 3, 2;
    int f = 2;
    for (int row = 0; row + 4 < n; row += 4)
        for (int k = 0; k < 4; ++k) {
            const int next = (k + 1) % 4;
            mesh.F.row(f++) << row + k, row + next, row + 4 + next;
            mesh.F.row(f++) << row + k, row + 4 + next, row + 4 + k;
        }
    mesh.F.row(f++) << n - 4, n - 3, n - 2;
    mesh.F.row(f++) << n - 4, n - 2, n - 1;
    return mesh;
}

} // namespace

KnownCast frusta(double a, double b, double up, double down, double lean) {
    std::vector<double> heights = {0, up};
    if (down > 0)
        heights.insert(heights.begin(), -down);
    Points rows(static_cast<Eigen::Index>(4 * heights.size()), 3);
    Eigen::Index v = 0;
    for (const double z : heights) {
        const double x = a / 2 - lean * std::abs(z);
        const double y = b / 2 - lean * std::abs(z);
        rows.row(v++) << -x, -y, z;
        rows.row(v++) << x, -y, z;
        rows.row(v++) << x, y, z;
        rows.row(v++) << -x, y, z;
    }
    return {stack(rows), {}};
}

KnownCast ball(double r, int rounds) {
    return {sphere(Eigen::Vector3d::Zero(), r, rounds), {}};
}

KnownCast ring(double ringRadius, double tubeRadius, int around, int across) {
    return {torus(ringRadius, tubeRadius, around, across), {}};
}

KnownCast sheared(KnownCast cast, double s1, double s2) {
    for (int v = 0; v < cast.mesh.vertexCount(); ++v) {
        const double z = cast.mesh.V(v, 2);
        cast.mesh.V(v, 0) += (z > 0 ? s1 : s2) * z;
    }
    cast.state.directions.d1 = Eigen::Vector3d(s1, 0, 1).normalized();
    cast.state.directions.d2 = Eigen::Vector3d(-s2, 0, -1).normalized();
    return cast;
}

KnownCast moved(KnownCast cast, const Eigen::Vector3d& axis, double angle, const Eigen::Vector3d& shift) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    for (int v = 0; v < cast.mesh.vertexCount(); ++v)
        cast.mesh.V.row(v) = (R * cast.mesh.point(v) + shift).transpose().cast<float>().cast<double>();
    PartingPlane& plane = cast.state.plane;
    plane.normal = (R * plane.normal).normalized();
    plane.offset += plane.normal.dot(shift);
    cast.state.directions.d1 = (R * cast.state.directions.d1).normalized();
    cast.state.directions.d2 = (R * cast.state.directions.d2).normalized();
    return cast;
}

} // namespace moldwright::test
