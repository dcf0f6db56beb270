// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/skirts.h"

#include "fill/projected_half.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kSquaresPerRim = 2; ///< along one side, per root of the number of rims
constexpr double kMostSquares = 512; ///< along one side

} // namespace

Eigen::Vector2d gradientOf(const HeightField& field, HeightField::Face f) {
    std::array<Eigen::Vector2d, 3> x;
    Eigen::Vector3d heights;
    std::size_t k = 0;
    for (const auto h : field.mesh().fh_range(f)) {
        x[k] = field.point(field.mesh().to_vertex_handle(h));
        heights[static_cast<Eigen::Index>(k++)] = field.height(h);
    }
    return gradientOf(x[0], x[1], x[2], heights);
}

bool tooSteep(const HeightField& field, HeightField::Face f, const DraftCone& cone) {
    return field.solid(f) && cone.steepness(gradientOf(field, f)) > 1;
}

Skirts::Skirts(const HeightField& field, const DraftCone& cone, const DraftCone& limit) : m_cone(cone) {
    const TriangleMesh& mesh = field.mesh();
    m_starts.assign(mesh.n_vertices(), 0);
    std::vector<char> steep;
    steep.reserve(mesh.n_faces());
    for (const auto f : mesh.faces())
        steep.push_back(tooSteep(field, f, limit) ? 1 : 0);
    const auto isSteep = [&](auto h) {
        const auto f = mesh.face_handle(h);
        return f.is_valid() && steep[static_cast<std::size_t>(f.idx())] != 0;
    };
    for (const auto e : mesh.edges()) {
        if (mesh.is_boundary(e))
            continue;
        const auto left = mesh.halfedge_handle(e, 0);
        const auto right = mesh.halfedge_handle(e, 1);
        const double atTo = std::max(field.height(left), field.height(mesh.prev_halfedge_handle(right)));
        const double atFrom = std::max(field.height(right), field.height(mesh.prev_halfedge_handle(left)));
        if (std::max(atTo, atFrom) > 0 && (isSteep(left) || isSteep(right) || field.wall(e)))
            addRim(field, mesh.from_vertex_handle(left), mesh.to_vertex_handle(left), atFrom, atTo);
    }
    makeGrid();
}

void Skirts::addRim(const HeightField& field, HeightField::Vertex a, HeightField::Vertex b, double heightA,
                    double heightB) {
    m_rims.push_back({field.point(a), field.point(b) - field.point(a), {heightA, heightB}});
    m_starts[static_cast<std::size_t>(a.idx())] = m_starts[static_cast<std::size_t>(b.idx())] = 1;
}

void Skirts::makeGrid() {
    m_side = static_cast<int>(
        std::clamp(kSquaresPerRim * std::sqrt(static_cast<double>(m_rims.size())), 1.0, kMostSquares));
    m_first.assign(static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side) + 1, 0);
    for (const Rim& rim : m_rims)
        visitSquares(rim, [&](std::size_t square) { ++m_first[square + 1]; });
    for (std::size_t s = 1; s < m_first.size(); ++s)
        m_first[s] += m_first[s - 1];
    m_inSquare.resize(static_cast<std::size_t>(m_first.back()));
    std::vector<int> next = m_first;
    for (std::size_t r = 0; r < m_rims.size(); ++r)
        visitSquares(m_rims[r], [&](std::size_t square) {
            m_inSquare[static_cast<std::size_t>(next[square]++)] = static_cast<int>(r);
        });
}

int Skirts::indexOf(double coordinate) const {
    const double width = 2 * ShadowGrid::reach / m_side;
    return std::clamp(static_cast<int>(std::floor((coordinate + ShadowGrid::reach) / width)), 0, m_side - 1);
}

template <class Visit>
void Skirts::visitSquares(const Rim& rim, Visit visit) const {
    const double reach = m_cone.reach(rim.height.maxCoeff());
    const Eigen::Vector2d to = rim.from + rim.along;
    const Eigen::Vector2d low = rim.from.cwiseMin(to).array() - reach;
    const Eigen::Vector2d high = rim.from.cwiseMax(to).array() + reach;
    for (int row = indexOf(low.y()); row <= indexOf(high.y()); ++row)
        for (int column = indexOf(low.x()); column <= indexOf(high.x()); ++column)
            visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(m_side) +
                  static_cast<std::size_t>(column));
}

double Skirts::heightAt(const Eigen::Vector2d& p) const {
    const std::size_t square = static_cast<std::size_t>(indexOf(p.y())) * static_cast<std::size_t>(m_side) +
                               static_cast<std::size_t>(indexOf(p.x()));
    double highest = -1;
    for (auto i = static_cast<std::size_t>(m_first[square]);
         i < static_cast<std::size_t>(m_first[square + 1]); ++i) {
        const Rim& rim = m_rims[static_cast<std::size_t>(m_inSquare[i])];
        highest = std::max(highest, m_cone.ridge(rim.along, rim.height, p - rim.from));
    }
    return highest;
}

} // namespace moldwright
