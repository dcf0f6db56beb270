// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/projected_half.h"

#include "mesh/edge_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moldwright {

namespace {

/// Numbers points with equal shadows alike, in the order of their coordinates.
void mergeShadows(const std::vector<int>& points, const std::vector<Eigen::Vector2d>& shadows,
                  ProjectedHalf& half) {
    std::vector<int> order = points;
    const auto shadow = [&](int v) -> const Eigen::Vector2d& { return shadows[static_cast<std::size_t>(v)]; };
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const Eigen::Vector2d& p = shadow(a);
        const Eigen::Vector2d& q = shadow(b);
        return std::make_tuple(p.x(), p.y(), a) < std::make_tuple(q.x(), q.y(), b);
    });
    for (const int v : order) {
        if (half.nodes.empty() || half.nodes.back() != shadow(v))
            half.nodes.push_back(shadow(v));
        half.nodeOf[static_cast<std::size_t>(v)] = static_cast<int>(half.nodes.size()) - 1;
    }
}

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
    const IndexedMesh& mesh = part.mesh;
    const auto vertices = static_cast<std::size_t>(mesh.vertexCount());
    std::vector<Eigen::Vector2d> shadows(vertices);
    std::vector<double> heights(vertices);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        shadows[static_cast<std::size_t>(v)] = grid.shadow(mesh.point(v), side);
        heights[static_cast<std::size_t>(v)] = grid.height(mesh.point(v), side);
    }

    ProjectedHalf half;
    half.nodeOf.assign(vertices, -1);
    std::vector<int> faceNumber(static_cast<std::size_t>(mesh.faceCount()), -1);
    std::vector<std::array<int, 3>> corners;
    std::vector<char> used(vertices, 0);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        // Mirroring turned side 2's faces over.
        const std::array<int, 3> c = {mesh.F(f, 0), mesh.F(f, side == 1 ? 1 : 2),
                                      mesh.F(f, side == 1 ? 2 : 1)};
        const auto at = [&](std::size_t k) { return static_cast<std::size_t>(c[k]); };
        const bool inPlane = heights[at(0)] == 0 && heights[at(1)] == 0 && heights[at(2)] == 0;
        if (part.labels[static_cast<std::size_t>(f)] != side || inPlane ||
            !(doubleArea(shadows[at(0)], shadows[at(1)], shadows[at(2)]) > 0))
            continue;
        faceNumber[static_cast<std::size_t>(f)] = static_cast<int>(corners.size());
        corners.push_back(c);
        half.faces.push_back({{}, {heights[at(0)], heights[at(1)], heights[at(2)]}, f});
        for (const int v : c)
            used[static_cast<std::size_t>(v)] = 1;
    }
    std::vector<int> points;
    for (std::size_t v = 0; v < vertices; ++v)
        if (used[v])
            points.push_back(static_cast<int>(v));
    mergeShadows(points, shadows, half);
    half.inPlane.assign(half.nodes.size(), 0);
    for (const int v : points)
        if (heights[static_cast<std::size_t>(v)] == 0)
            half.inPlane[static_cast<std::size_t>(half.nodeOf[static_cast<std::size_t>(v)])] = 1;
    for (std::size_t f = 0; f < corners.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            half.faces[f].node[k] = half.nodeOf[static_cast<std::size_t>(corners[f][k])];

    const EdgeTable table(mesh.F);
    for (int e = 0; e < table.edgeCount(); ++e) {
        ShadowEdge edge;
        std::size_t known = 0;
        for (const FaceSide& s : table.sidesAt(e)) {
            if (const int f = faceNumber[static_cast<std::size_t>(s.face)]; f >= 0 && known < 2)
                edge.face[known++] = f;
            edge.node = {half.nodeOf[static_cast<std::size_t>(s.low)],
                         half.nodeOf[static_cast<std::size_t>(s.high)]};
            edge.height = {heights[static_cast<std::size_t>(s.low)],
                           heights[static_cast<std::size_t>(s.high)]};
        }
        if (known > 0)
            half.edges.push_back(edge);
    }
    return half;
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
