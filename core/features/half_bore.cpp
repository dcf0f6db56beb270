// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/half_bore.h"

#include "castability/mold_state.h"
#include "features/drafted_prism.h"

#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

using Eigen::Vector3d;

constexpr int corners = 32;

} // namespace

Vector3d HalfBore::at(double height, const Vector3d& d) const {
    const double z = side == 1 ? height : -height;
    return Vector3d(axis.x(), axis.y(), 0) + d * (z / d.z());
}

IndexedMesh HalfBore::solid(const Vector3d& d, double grid) const {
    const auto [across1, across2] = planeAxes(d);
    const int rings = static_cast<int>(stations.size());
    IndexedMesh mesh{Points(rings * corners, 3), Triangles(2 * (rings - 1) * corners + 2 * (corners - 2), 3)};
    for (int ring = 0; ring < rings; ++ring) {
        const Station& station = stations[static_cast<std::size_t>(ring)];
        const double reach = station.radius / std::cos(std::numbers::pi / corners);
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / corners;
            const Vector3d way = reach * (std::cos(angle) * across1 + std::sin(angle) * across2);
            // The circle across d, seen along d in the section's plane.
            const Vector3d p = at(station.height, d) + way - d * (way.z() / d.z());
            mesh.V.row(ring * corners + k) << onGrid(p.x(), grid), onGrid(p.y(), grid), onGrid(p.z(), grid);
        }
    }
    // Counter-clockwise seen against d, which looks out of both halves.
    Eigen::Index f = 0;
    for (int ring = 0; ring + 1 < rings; ++ring)
        for (int k = 0; k < corners; ++k) {
            const int a = ring * corners + k;
            const int b = ring * corners + (k + 1) % corners;
            mesh.F.row(f++) << a, b, b + corners;
            mesh.F.row(f++) << a, b + corners, a + corners;
        }
    const int last = (rings - 1) * corners;
    for (int k = 0; k < corners - 2; ++k) {
        mesh.F.row(f++) << 0, k + 2, k + 1;
        mesh.F.row(f++) << last, last + k + 1, last + k + 2;
    }
    return mesh;
}

} // namespace moldwright
