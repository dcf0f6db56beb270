// SPDX-License-Identifier: AGPL-3.0-or-later
#include "contour.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace moldwright::samples {

namespace {

using Eigen::Vector3i;

/// Values of the field at the nodes of a regular grid; nodes far from the surface hold only the right sign.
class Grid {
public:
    Grid(const Solid& solid, double cell) : m_cell(cell), m_origin(solid.box.min()) {
        if (solid.flatBack)
            m_origin.z() = 0;
        const Vector3d extent = (solid.box.max() - m_origin) / cell;
        m_blocks = (extent / blockSize).array().ceil().cast<int>() + 1;
        m_values.resize(std::size_t(nodes().prod()));
        parallelFor(std::size_t(m_blocks.prod()), 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b)
                fillBlock(solid.field, int(b));
        });
    }

    [[nodiscard]] Vector3i cells() const { return nodes().array() - 1; }
    [[nodiscard]] Vector3d position(const Vector3i& n) const { return m_origin + m_cell * n.cast<double>(); }
    [[nodiscard]] int index(const Vector3i& n) const {
        return (n.z() * nodes().y() + n.y()) * nodes().x() + n.x();
    }
    [[nodiscard]] double value(const Vector3i& n) const { return m_values[std::size_t(index(n))]; }

private:
    static constexpr int blockSize = 6;
    /// Fields grow at most this much per mm: far from a flat ellipsoid the formula overestimates.
    static constexpr double steepest = 1.7;

    [[nodiscard]] Vector3i nodes() const { return m_blocks * blockSize; }

    void fillBlock(const Field& field, int b) {
        const Vector3i block(b % m_blocks.x(), b / m_blocks.x() % m_blocks.y(),
                             b / m_blocks.x() / m_blocks.y());
        const Vector3d middle =
            position(block * blockSize) + Vector3d::Constant(m_cell * (blockSize - 1) / 2.0);
        const double there = field(middle);
        const bool far = std::abs(there) > steepest * m_cell * blockSize * std::sqrt(0.75);
        for (int k = 0; k < blockSize * blockSize * blockSize; ++k) {
            const Vector3i n = block * blockSize +
                               Vector3i(k % blockSize, k / blockSize % blockSize, k / blockSize / blockSize);
            m_values[std::size_t(index(n))] = far ? there : field(position(n));
        }
    }

    double m_cell;
    Vector3d m_origin;
    Vector3i m_blocks;
    std::vector<double> m_values;
};

/// Corner i of the cube is the sum of the axes in its bits; each tetrahedron walks from 0 to 7 by one
/// permutation of the axes. The sign of the permutation is the tetrahedron's orientation.
constexpr std::array<std::array<int, 4>, 6> tetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// The two triangles of the cube's lower face that bound those tetrahedra, clockwise from above: outward.
constexpr std::array<std::array<int, 3>, 2> lowerFace = {{{0, 3, 1}, {0, 2, 3}}};

class Marcher {
public:
    Marcher(const Solid& solid, double cell) : m_grid(solid, cell) {
        const Vector3i cells = m_grid.cells();
        for (int z = 0; z < cells.z(); ++z)
            for (int y = 0; y < cells.y(); ++y)
                for (int x = 0; x < cells.x(); ++x) {
                    load({x, y, z});
                    if (m_inside == 0 || (m_inside == 255 && (z > 0 || !solid.flatBack)))
                        continue;
                    for (const auto& tet : tetrahedra)
                        march(tet);
                    for (const auto& triangle : lowerFace)
                        if (z == 0 && solid.flatBack)
                            cap(triangle);
                }
    }

    [[nodiscard]] IndexedMesh mesh() const {
        IndexedMesh result;
        result.V.resize(Eigen::Index(m_points.size()), 3);
        result.F.resize(Eigen::Index(m_faces.size()), 3);
        for (std::size_t v = 0; v < m_points.size(); ++v)
            result.V.row(Eigen::Index(v)) = m_points[v].transpose();
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            result.F.row(Eigen::Index(f)) << m_faces[f][0], m_faces[f][1], m_faces[f][2];
        return result;
    }

private:
    void load(const Vector3i& cube) {
        m_inside = 0;
        for (int c = 0; c < 8; ++c) {
            m_corner[c] = cube + Vector3i(c & 1, c >> 1 & 1, c >> 2 & 1);
            m_value[c] = m_grid.value(m_corner[c]);
            m_inside |= (m_value[c] < 0) << c;
        }
    }

    [[nodiscard]] bool inside(int corner) const { return (m_inside >> corner & 1) != 0; }

    /// The mesh's point on the edge between two corners, or at a corner (a == b).
    int point(int a, int b) {
        std::pair<int, int> key(m_grid.index(m_corner[a]), m_grid.index(m_corner[b]));
        if (key.first > key.second) {
            std::swap(key.first, key.second);
            std::swap(a, b);
        }
        const auto [entry, isNew] = m_index.try_emplace(key, static_cast<int>(m_points.size()));
        if (isNew) {
            // Not quite to the ends, so that no two points coincide.
            const double t = a == b ? 0 : std::clamp(m_value[a] / (m_value[a] - m_value[b]), 0.05, 0.95);
            const Vector3d from = m_grid.position(m_corner[a]);
            m_points.push_back(from + t * (m_grid.position(m_corner[b]) - from));
        }
        return entry->second;
    }

    /// The surface inside one tetrahedron, facing from inside to outside.
    void march(const std::array<int, 4>& tet) {
        std::array<int, 4> order{};
        int in = 0;
        for (const int c : tet)
            if (inside(c))
                order[in++] = c;
        int at = in;
        for (const int c : tet)
            if (!inside(c))
                order[at++] = c;
        if (in == 0 || in == 4)
            return;
        const auto [a, b, c, d] = order;
        const bool positive = orientation(order) > 0;
        if (in == 1)
            addFace(point(a, b), point(a, c), point(a, d), positive);
        else if (in == 3)
            addFace(point(a, d), point(b, d), point(c, d), positive);
        else {
            addFace(point(a, c), point(a, d), point(b, d), positive);
            addFace(point(a, c), point(b, d), point(b, c), positive);
        }
    }

    [[nodiscard]] int orientation(const std::array<int, 4>& t) const {
        Eigen::Matrix3i edges;
        for (int k = 0; k < 3; ++k)
            edges.col(k) = m_corner[t[k + 1]] - m_corner[t[0]];
        return edges.col(0).dot(edges.col(1).cross(edges.col(2)));
    }

    /// The part of one triangle of the lower face that lies inside.
    void cap(const std::array<int, 3>& triangle) {
        std::vector<int> loop;
        for (int k = 0; k < 3; ++k) {
            const int a = triangle[k];
            const int b = triangle[(k + 1) % 3];
            if (inside(a))
                loop.push_back(point(a, a));
            if (inside(a) != inside(b))
                loop.push_back(point(a, b));
        }
        for (std::size_t k = 2; k < loop.size(); ++k)
            addFace(loop[0], loop[k - 1], loop[k], true);
    }

    void addFace(int a, int b, int c, bool positive) {
        m_faces.push_back(positive ? std::array{a, b, c} : std::array{a, c, b});
    }

    Grid m_grid;
    std::array<Vector3i, 8> m_corner;
    std::array<double, 8> m_value{};
    int m_inside = 0; ///< bit c: corner c lies inside
    std::map<std::pair<int, int>, int> m_index;
    std::vector<Vector3d> m_points;
    std::vector<std::array<int, 3>> m_faces;
};

} // namespace

IndexedMesh contour(const Solid& solid, double cell) {
    return Marcher(solid, cell).mesh();
}

} // namespace moldwright::samples
