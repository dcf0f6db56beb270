// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/projected_half.h"

#include "mesh/edge_table.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace moldwright {

namespace {

/// The half under construction: its points' shadows and heights, and which faces were taken in.
class Projection {
public:
    Projection(const PartedMesh& part, int side, const ShadowGrid& grid) : m_part(part), m_side(side) {
        m_shadows.reserve(static_cast<std::size_t>(part.mesh.vertexCount()));
        m_heights.reserve(m_shadows.capacity());
        for (int v = 0; v < part.mesh.vertexCount(); ++v) {
            m_shadows.push_back(grid.shadow(part.mesh.point(v), side));
            m_heights.push_back(grid.height(part.mesh.point(v), side));
        }
        m_half.nodeOf.assign(m_shadows.size(), -1);
        m_faceNumber.assign(static_cast<std::size_t>(part.mesh.faceCount()), -1);
    }

    ProjectedHalf make() {
        takeFaces();
        mergeShadows();
        for (std::size_t f = 0; f < m_corners.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                m_half.faces[f].node[k] = m_half.nodeOf[static_cast<std::size_t>(m_corners[f][k])];
        takeEdges();
        return std::move(m_half);
    }

private:
    [[nodiscard]] const Eigen::Vector2d& shadow(int v) const {
        return m_shadows[static_cast<std::size_t>(v)];
    }
    [[nodiscard]] double height(int v) const { return m_heights[static_cast<std::size_t>(v)]; }
    [[nodiscard]] int& node(int v) { return m_half.nodeOf[static_cast<std::size_t>(v)]; }

    void takeFaces() {
        const Triangles& F = m_part.mesh.F;
        for (int f = 0; f < m_part.mesh.faceCount(); ++f) {
            // Mirroring turned side 2's faces over.
            const std::array<int, 3> c = {F(f, 0), F(f, m_side == 1 ? 1 : 2), F(f, m_side == 1 ? 2 : 1)};
            const bool inPlane = height(c[0]) == 0 && height(c[1]) == 0 && height(c[2]) == 0;
            if (m_part.labels[static_cast<std::size_t>(f)] != m_side || inPlane ||
                !(doubleArea(shadow(c[0]), shadow(c[1]), shadow(c[2])) > 0))
                continue;
            m_faceNumber[static_cast<std::size_t>(f)] = static_cast<int>(m_corners.size());
            m_corners.push_back(c);
            m_half.faces.push_back({{}, {height(c[0]), height(c[1]), height(c[2])}, f});
        }
    }

    /// Numbers the taken faces' points; those with equal shadows alike, in the order of their coordinates.
    void mergeShadows() {
        std::vector<int> order;
        for (const auto& corners : m_corners)
            order.insert(order.end(), corners.begin(), corners.end());
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            const Eigen::Vector2d& p = shadow(a);
            const Eigen::Vector2d& q = shadow(b);
            return std::tuple(p.x(), p.y(), a) < std::tuple(q.x(), q.y(), b);
        });
        for (const int v : order) {
            if (m_half.nodes.empty() || m_half.nodes.back() != shadow(v)) {
                m_half.nodes.push_back(shadow(v));
                m_half.inPlane.push_back(0);
            }
            node(v) = static_cast<int>(m_half.nodes.size()) - 1;
            if (height(v) == 0)
                m_half.inPlane.back() = 1;
        }
    }

    void takeEdges() {
        const EdgeTable table(m_part.mesh.F);
        for (int e = 0; e < table.edgeCount(); ++e) {
            ShadowEdge edge;
            std::size_t known = 0;
            for (const FaceSide& s : table.sidesAt(e)) {
                if (const int f = m_faceNumber[static_cast<std::size_t>(s.face)]; f >= 0 && known < 2)
                    edge.face[known++] = f;
                edge.node = {node(s.low), node(s.high)};
                edge.height = {height(s.low), height(s.high)};
            }
            if (known > 0)
                m_half.edges.push_back(edge);
        }
    }

    const PartedMesh& m_part;
    int m_side;
    std::vector<Eigen::Vector2d> m_shadows;
    std::vector<double> m_heights;
    std::vector<int> m_faceNumber;             ///< per face of the part, −1: not taken
    std::vector<std::array<int, 3>> m_corners; ///< of the faces taken
    ProjectedHalf m_half;
};

} // namespace

ShadowGrid::ShadowGrid(const IndexedMesh& mesh, const Directions& directions) {
    for (int side = 1; side <= 2; ++side) {
        const Eigen::Vector3d& d = directions.of(side);
        m_slope[static_cast<std::size_t>(side - 1)] = d.head<2>() / d.z();
    }
    Eigen::AlignedBox2d box;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        box.extend(sheared(mesh.point(v), mesh.V(v, 2) >= 0 ? 1 : 2));
    m_centre = box.center();
    m_step = box.sizes().maxCoeff() / 2 / (reach - 1);
}

Eigen::Vector2d ShadowGrid::sheared(const Eigen::Vector3d& x, int side) const {
    return x.head<2>() - x.z() * m_slope[static_cast<std::size_t>(side - 1)];
}

Eigen::Vector2d ShadowGrid::shadow(const Eigen::Vector3d& x, int side) const {
    return ((sheared(x, side) - m_centre) / m_step).array().round();
}

double ShadowGrid::height(const Eigen::Vector3d& x, int side) const {
    return std::max(side == 1 ? x.z() : -x.z(), 0.0) / m_step;
}

Eigen::Vector3d ShadowGrid::place(const Eigen::Vector2d& shadow, double height, int side) const {
    const double z = height * m_step * (side == 1 ? 1 : -1);
    const Eigen::Vector2d xy = shadow * m_step + m_centre + z * m_slope[static_cast<std::size_t>(side - 1)];
    return {xy.x(), xy.y(), height == 0 ? 0 : z};
}

ProjectedHalf projectHalf(const PartedMesh& part, int side, const ShadowGrid& grid) {
    return Projection(part, side, grid).make();
}

double heightAt(const ProjectedHalf& half, const ShadowFace& face, const Eigen::Vector2d& p) {
    const Eigen::Vector2d& a = half.corner(face, 0);
    const Eigen::Vector2d& b = half.corner(face, 1);
    const Eigen::Vector2d& c = half.corner(face, 2);
    const double height = (doubleArea(b, c, p) * face.height[0] + doubleArea(c, a, p) * face.height[1] +
                           doubleArea(a, b, p) * face.height[2]) /
                          doubleArea(a, b, c);
    const auto [low, high] = std::minmax_element(face.height.begin(), face.height.end());
    return std::clamp(height, *low, *high);
}

} // namespace moldwright
