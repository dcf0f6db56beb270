// SPDX-License-Identifier: AGPL-3.0-or-later
#include "support/solids.h"

#include <algorithm>
#include <map>
#include <vector>

namespace moldwright::test {

namespace {

using Corners = std::array<int, 4>;

/// The six tetrahedra along the diagonal of every cell: one for each order in which the axes are walked.
std::vector<Corners> cellTets(const std::array<int, 3>& cells, const std::array<int, 3>& stride) {
    std::vector<Corners> tets;
    for (int i = 0; i < cells[0]; ++i)
        for (int j = 0; j < cells[1]; ++j)
            for (int k = 0; k < cells[2]; ++k) {
                std::array<std::size_t, 3> axes = {0, 1, 2};
                do {
                    Corners tet{};
                    tet[0] = i * stride[0] + j * stride[1] + k * stride[2];
                    for (std::size_t s = 0; s < 3; ++s)
                        tet[s + 1] = tet[s] + stride[axes[s]];
                    const bool even = (axes[0] + 1) % 3 == axes[1];
                    if (!even)
                        std::swap(tet[2], tet[3]);
                    tets.push_back(tet);
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
    return tets;
}

/// Faces that one tetrahedron alone has; outward because the tetrahedra have positive volume.
std::vector<std::array<int, 3>> outerFaces(const std::vector<Corners>& tets) {
    std::map<std::array<int, 3>, std::vector<std::array<int, 3>>> byCorners;
    for (const auto& [a, b, c, d] : tets)
        for (const std::array<int, 3>& face : {std::array{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}}) {
            std::array<int, 3> key = face;
            std::sort(key.begin(), key.end());
            byCorners[key].push_back(face);
        }
    std::vector<std::array<int, 3>> outer;
    for (const auto& [key, faces] : byCorners)
        if (faces.size() == 1)
            outer.push_back(faces.front());
    return outer;
}

} // namespace

Solid solidBox(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi, const std::array<int, 3>& cells) {
    const std::array<int, 3> stride = {(cells[1] + 1) * (cells[2] + 1), cells[2] + 1, 1};
    const int points = (cells[0] + 1) * stride[0];
    const std::vector<Corners> tets = cellTets(cells, stride);
    const std::vector<std::array<int, 3>> faces = outerFaces(tets);

    std::vector<int> newIndex(static_cast<std::size_t>(points), -1);
    int next = 0;
    for (const auto& face : faces)
        for (const int v : face)
            if (int& index = newIndex[static_cast<std::size_t>(v)]; index < 0)
                index = next++;
    for (int& index : newIndex)
        if (index < 0)
            index = next++;

    Solid solid;
    solid.tets.V.resize(points, 3);
    for (int v = 0; v < points; ++v) {
        const Eigen::Array3d cell(v / stride[0], v / stride[1] % (cells[1] + 1), v % stride[1]);
        const Eigen::Array3d share = cell / Eigen::Array3d(cells[0], cells[1], cells[2]);
        solid.tets.V.row(newIndex[static_cast<std::size_t>(v)]) =
            (lo.array() + share * (hi - lo).array()).matrix().transpose();
    }
    solid.tets.T.resize(static_cast<Eigen::Index>(tets.size()), 4);
    for (std::size_t t = 0; t < tets.size(); ++t)
        for (std::size_t k = 0; k < 4; ++k)
            solid.tets.T(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) =
                newIndex[static_cast<std::size_t>(tets[t][k])];
    solid.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            solid.F(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)) =
                newIndex[static_cast<std::size_t>(faces[f][k])];
    return solid;
}

} // namespace moldwright::test
