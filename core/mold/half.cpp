// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/half.h"

#include "base/stop_point.h"
#include "castability/certificate.h"
#include "features/cgal/constrained_triangulation.h"
#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// One of the flat faces that close a half: the parting face, the back, or a wall.
struct Flat {
    Vector3d origin; ///< a point of it
    Vector3d normal; ///< unit
    Vector3d
        across; ///< unit, in the plane z = 0; with `upwards` right-handed seen from outside, or from inside
    Vector3d upwards;
    double tolerance = 0; ///< mm that points of it may lie off: walls lean, and their points are rounded
    bool positive = true; ///< seen from outside

    [[nodiscard]] bool holds(const Vector3d& p) const {
        return std::abs(normal.dot(p - origin)) <= tolerance;
    }
    [[nodiscard]] Vector2d flat(const Vector3d& p) const {
        return {across.dot(p - origin), upwards.dot(p - origin)};
    }
};

class HalfAssembly {
public:
    HalfAssembly(int side, SurfaceSum surface, const Block& block)
        : m_surface(std::move(surface.mesh)), m_open(std::move(surface.open)),
          m_corners(block.body.base.size()), m_tolerance(4 * block.body.grid) {
        for (std::size_t k = 0; k < m_corners; ++k)
            m_points.push_back(block.body.foot(k));
        for (std::size_t k = 0; k < m_corners; ++k)
            m_points.push_back(block.body.top(side, k));
        m_blockPoints = m_points.size();
        const Vector3d z = Vector3d::UnitZ();
        // An edge of a flat foot that lies in the parting plane and in a wall of the block borders the
        // latter.
        for (std::size_t k = 0; k < m_corners; ++k) {
            const Vector3d& foot = m_points[k];
            const Vector3d along = (m_points[(k + 1) % m_corners] - foot).normalized();
            const Vector3d normal = along.cross(m_points[m_corners + k] - foot).normalized();
            m_flats.push_back({foot, normal, along, z, m_tolerance, true});
        }
        for (const std::size_t at : {std::size_t{0}, m_corners})
            m_flats.push_back(
                {m_points[at], z, Vector3d::UnitX(), Vector3d::UnitY(), 0, (at == 0) == (side == 2)});
    }

    std::optional<IndexedMesh> closed() {
        std::vector<Segments> segments = borders();
        addBlockEdges(segments);
        for (std::size_t i = 0; i < m_flats.size(); ++i)
            if (!addFlat(m_flats[i], segments[i]))
                return std::nullopt;
        return whole();
    }

private:
    using Segments = std::vector<std::array<int, 2>>;

    int pointOf(int v) {
        const auto [at, isNew] = m_numberOf.try_emplace(v, static_cast<int>(m_points.size()));
        if (isNew) {
            m_points.push_back(m_surface.point(v));
            m_ofSurface.push_back(v);
        }
        return at->second;
    }

    /// The surface with the flat faces, whose points are its own but for the block's corners.
    IndexedMesh whole() {
        const int own = m_surface.vertexCount();
        m_surface.V.conservativeResize(own + static_cast<Eigen::Index>(m_blockPoints), 3);
        for (std::size_t k = 0; k < m_blockPoints; ++k)
            m_surface.V.row(own + static_cast<Eigen::Index>(k)) = m_points[k].transpose();
        Eigen::Index row = m_surface.F.rows();
        m_surface.F.conservativeResize(row + static_cast<Eigen::Index>(m_faces.size()), 3);
        const auto number = [&](int v) {
            const std::size_t at = static_cast<std::size_t>(v);
            return at < m_blockPoints ? own + v : m_ofSurface[at - m_blockPoints];
        };
        for (const Eigen::RowVector3i& face : m_faces)
            m_surface.F.row(row++) << number(face[0]), number(face[1]), number(face[2]);
        return std::move(m_surface);
    }

    /// The surface's open edges, by the flat face that they lie in.
    std::vector<Segments> borders() {
        std::vector<Segments> found(m_flats.size());
        for (const auto& [from, to] : m_open) {
            stopPointAt(from);
            const Vector3d a = m_surface.point(from);
            const Vector3d b = m_surface.point(to);
            for (std::size_t i = 0; i < m_flats.size(); ++i)
                if (m_flats[i].holds(a) && m_flats[i].holds(b)) {
                    found[i].push_back({pointOf(from), pointOf(to)});
                    break;
                }
        }
        return found;
    }

    /// The block's own edges. Those in the parting plane are interrupted where something opens into a wall.
    void addBlockEdges(std::vector<Segments>& segments) {
        const std::size_t plane = m_corners;
        const std::size_t back = m_corners + 1;
        for (std::size_t k = 0; k < m_corners; ++k) {
            const std::size_t next = (k + 1) % m_corners;
            addEdge(segments, static_cast<int>(k), static_cast<int>(next), {k, plane});
            addEdge(segments, static_cast<int>(m_corners + k), static_cast<int>(m_corners + next), {k, back});
            addEdge(segments, static_cast<int>(k), static_cast<int>(m_corners + k),
                    {k, (k + m_corners - 1) % m_corners});
        }
    }
    void addEdge(std::vector<Segments>& segments, int from, int to, const std::array<std::size_t, 2>& flats) {
        const Vector3d a = m_points[static_cast<std::size_t>(from)];
        const Vector3d b = m_points[static_cast<std::size_t>(to)];
        const Vector3d along = (b - a).normalized();
        std::vector<std::pair<double, int>> openings;
        for (std::size_t v = m_blockPoints; v < m_points.size(); ++v) {
            const Vector3d p = m_points[v] - a;
            if ((p - along * p.dot(along)).norm() <= m_tolerance)
                openings.emplace_back(p.dot(along), static_cast<int>(v));
        }
        std::sort(openings.begin(), openings.end());
        std::vector<int> stops{from};
        for (const auto& [at, v] : openings)
            stops.push_back(v);
        stops.push_back(to);
        for (std::size_t i = 0; i + 1 < stops.size(); i += 2)
            for (const std::size_t flat : flats)
                segments[flat].push_back({stops[i], stops[i + 1]});
    }

    bool addFlat(const Flat& flat, const Segments& segments) {
        stopPoint();
        std::map<int, int> numberOf;
        std::vector<int> used;
        std::vector<Vector2d> points;
        std::vector<std::array<int, 2>> outline;
        for (const auto& segment : segments) {
            std::array<int, 2> ends{};
            for (std::size_t k = 0; k < 2; ++k) {
                const auto [at, isNew] = numberOf.try_emplace(segment[k], static_cast<int>(used.size()));
                if (isNew) {
                    used.push_back(segment[k]);
                    points.push_back(flat.flat(m_points[static_cast<std::size_t>(segment[k])]));
                }
                ends[k] = at->second;
            }
            outline.push_back(ends);
        }
        const std::optional<Triangles> faces = triangulateRegion(points, outline);
        if (!faces)
            return false;
        for (const auto& t : faces->rowwise()) {
            const auto point = [&](int k) { return used[static_cast<std::size_t>(t[k])]; };
            m_faces.emplace_back(point(0), point(flat.positive ? 1 : 2), point(flat.positive ? 2 : 1));
        }
        return true;
    }

    IndexedMesh m_surface;
    std::vector<std::array<int, 2>> m_open;
    std::size_t m_corners;         ///< of the block's outline
    std::size_t m_blockPoints = 0; ///< its corners in the plane, then those of the back
    double m_tolerance;
    std::vector<Flat> m_flats;      ///< the walls, the parting face, the back
    std::vector<Vector3d> m_points; ///< the block's, then the borders'
    std::vector<int> m_ofSurface;   ///< after the block's: which point of the surface each is
    std::map<int, int> m_numberOf;
    std::vector<Eigen::RowVector3i> m_faces;
};

} // namespace

std::optional<IndexedMesh> assembleHalf(int side, const HalfSurfaces& surfaces, const Block& block) {
    std::vector<PlacedSurface> all = surfaces.bosses;
    for (PlacedSurface surface : surfaces.voids) {
        surface.insideOut = !surface.insideOut;
        all.push_back(std::move(surface));
    }
    return HalfAssembly(side, sumOf(all), block).closed();
}

IndexedMesh sideOf(const IndexedMesh& solid, int side, double end) {
    const SideLabels labels = labelSides(solid, {});
    IndexedMesh faces{solid.V, Triangles(solid.F.rows(), 3)};
    Eigen::Index kept = 0;
    for (int f = 0; f < solid.faceCount(); ++f) {
        const bool outside =
            solid.corner(f, 0).z() == end && solid.corner(f, 1).z() == end && solid.corner(f, 2).z() == end;
        if (labels[static_cast<std::size_t>(f)] == side && !outside)
            faces.F.row(kept++) = solid.F.row(f);
    }
    faces.F.conservativeResize(kept, 3);
    return withoutUnusedPoints(faces).mesh;
}

} // namespace moldwright
