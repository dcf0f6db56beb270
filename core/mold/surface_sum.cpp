// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/surface_sum.h"

#include "base/parallel.h"
#include "base/stop_point.h"
#include "mesh/edge_table.h"
#include "mesh/point_rows.h"

#include <algorithm>
#include <map>

namespace moldwright {

namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// The border of a surface, and a numbering of its points in which those inside come first.
struct Border {
    std::vector<int> points;
    std::vector<std::array<int, 2>> edges; ///< of `points`
    std::vector<int> inside;
    std::vector<int> numberOf; ///< of each point: its place in `inside`, or after all of these in `points`
};

Border borderOf(const IndexedMesh& mesh) {
    Border border;
    std::vector<char> atBorder(static_cast<std::size_t>(mesh.vertexCount()), 0);
    const EdgeTable edges(mesh.F);
    for (int e = 0; e < edges.edgeCount(); ++e)
        if (const auto sides = edges.sidesAt(e); sides.size() == 1) {
            border.edges.push_back({sides[0].low, sides[0].high});
            atBorder[static_cast<std::size_t>(sides[0].low)] = 1;
            atBorder[static_cast<std::size_t>(sides[0].high)] = 1;
        }
    for (int v = 0; v < mesh.vertexCount(); ++v)
        (atBorder[static_cast<std::size_t>(v)] != 0 ? border.points : border.inside).push_back(v);
    border.numberOf.resize(atBorder.size());
    int number = 0;
    for (const auto* points : {&border.inside, &border.points})
        for (const int v : *points)
            border.numberOf[static_cast<std::size_t>(v)] = number++;
    const auto insidePoints = static_cast<int>(border.inside.size());
    for (auto& edge : border.edges)
        for (int& v : edge)
            v = border.numberOf[static_cast<std::size_t>(v)] - insidePoints;
    return border;
}

class Adder {
public:
    explicit Adder(const std::vector<PlacedSurface>& surfaces) : m_surfaces(surfaces) {
        for (const PlacedSurface& surface : surfaces)
            if (!m_borders.contains(surface.mesh.get()))
                m_borders.emplace(surface.mesh.get(), borderOf(*surface.mesh));
    }

    SurfaceSum sum() {
        numberPoints();
        SurfaceSum sum;
        const auto borderPoints = static_cast<Index>(m_borderPoints.size());
        sum.mesh.V.resize(borderPoints + m_points, 3);
        sum.mesh.V.topRows(borderPoints) = pointRows(m_borderPoints);
        sum.mesh.F.resize(m_faces, 3);
        parallelFor(m_surfaces.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s)
                copy(s, sum.mesh);
        });
        sum.open = openEdges();
        return sum;
    }

private:
    /// Where a surface's own rows begin, and the numbers of its border's points.
    struct Place {
        Index firstPoint = 0;
        Index firstFace = 0;
        std::vector<int> border;
    };

    [[nodiscard]] const Border& borderOfSurface(std::size_t s) const {
        return m_borders.at(m_surfaces[s].mesh.get());
    }

    static Vector3d shift(const PlacedSurface& surface) {
        return {surface.offset.x(), surface.offset.y(), 0};
    }

    void numberPoints() {
        std::map<std::array<double, 3>, int> numberOf;
        for (std::size_t s = 0; s < m_surfaces.size(); ++s) {
            const PlacedSurface& surface = m_surfaces[s];
            Place place{m_points, m_faces, {}};
            for (const int v : borderOfSurface(s).points) {
                stopPointAt(v);
                const Vector3d p = surface.mesh->point(v) + shift(surface);
                const auto [at, isNew] =
                    numberOf.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(m_borderPoints.size()));
                if (isNew)
                    m_borderPoints.push_back(p);
                place.border.push_back(at->second);
            }
            m_points += static_cast<Index>(borderOfSurface(s).inside.size());
            m_faces += surface.mesh->F.rows();
            m_places.push_back(std::move(place));
        }
    }

    void copy(std::size_t s, IndexedMesh& into) const {
        const PlacedSurface& surface = m_surfaces[s];
        const Border& border = borderOfSurface(s);
        const Place& place = m_places[s];
        const Index first = static_cast<Index>(m_borderPoints.size()) + place.firstPoint;
        const Eigen::RowVector3d by = shift(surface).transpose();
        for (std::size_t i = 0; i < border.inside.size(); ++i)
            into.V.row(first + static_cast<Index>(i)) = surface.mesh->V.row(border.inside[i]) + by;
        const auto insidePoints = static_cast<int>(border.inside.size());
        const auto number = [&](int v) {
            const int own = border.numberOf[static_cast<std::size_t>(v)];
            return own < insidePoints ? static_cast<int>(first) + own
                                      : place.border[static_cast<std::size_t>(own - insidePoints)];
        };
        const int second = surface.insideOut ? 2 : 1;
        for (Index f = 0; f < surface.mesh->F.rows(); ++f) {
            stopPointAt(f);
            const auto face = surface.mesh->F.row(f);
            into.F.row(place.firstFace + f) << number(face[0]), number(face[second]),
                number(face[3 - second]);
        }
    }

    [[nodiscard]] std::vector<std::array<int, 2>> openEdges() const {
        std::vector<std::array<int, 2>> edges;
        for (std::size_t s = 0; s < m_surfaces.size(); ++s) {
            stopPoint();
            for (const auto& [from, to] : borderOfSurface(s).edges) {
                const auto [low, high] = std::minmax(m_places[s].border[static_cast<std::size_t>(from)],
                                                     m_places[s].border[static_cast<std::size_t>(to)]);
                edges.push_back({low, high});
            }
        }
        std::sort(edges.begin(), edges.end());
        std::vector<std::array<int, 2>> open;
        for (std::size_t i = 0; i < edges.size(); ++i)
            if ((i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i]))
                open.push_back(edges[i]);
        return open;
    }

    const std::vector<PlacedSurface>& m_surfaces;
    std::map<const IndexedMesh*, Border> m_borders;
    std::vector<Place> m_places;
    std::vector<Vector3d> m_borderPoints;
    Index m_points = 0; ///< inside of all surfaces
    Index m_faces = 0;
};

} // namespace

SurfaceSum sumOf(const std::vector<PlacedSurface>& surfaces) {
    return Adder(surfaces).sum();
}

} // namespace moldwright
