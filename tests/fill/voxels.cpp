// SPDX-License-Identifier: AGPL-3.0-or-later
#include "voxels.h"

#include <map>
#include <set>

namespace moldwright::test {

namespace {

IndexedMesh meshOf(const std::vector<std::array<int, 3>>& points,
                   const std::vector<std::array<int, 3>>& faces) {
    IndexedMesh mesh;
    mesh.V.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        mesh.V.row(static_cast<Eigen::Index>(v)) << points[v][0], points[v][1], points[v][2];
    mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f)
        mesh.F.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
    return mesh;
}

} // namespace

IndexedMesh voxels(const std::vector<std::array<int, 3>>& cubes) {
    const std::set<std::array<int, 3>> full(cubes.begin(), cubes.end());
    std::map<std::array<int, 3>, int> number;
    std::vector<std::array<int, 3>> points;
    std::vector<std::array<int, 3>> faces;
    const auto point = [&](const std::array<int, 3>& p) {
        const auto [at, fresh] = number.emplace(p, static_cast<int>(points.size()));
        if (fresh)
            points.push_back(p);
        return at->second;
    };
    for (const auto& cube : full)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                auto next = cube;
                next[axis] += step;
                if (full.contains(next))
                    continue;
                // The square's corners, counter-clockwise seen from the side of the greater coordinate.
                std::array<int, 4> c{};
                for (std::size_t k = 0; k < 4; ++k) {
                    auto p = cube;
                    p[axis] += step > 0 ? 1 : 0;
                    p[(axis + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
                    p[(axis + 2) % 3] += k >= 2 ? 1 : 0;
                    c[k] = point(p);
                }
                if (step < 0)
                    std::swap(c[1], c[3]);
                faces.push_back({c[0], c[1], c[2]});
                faces.push_back({c[0], c[2], c[3]});
            }
    return meshOf(points, faces);
}

} // namespace moldwright::test
