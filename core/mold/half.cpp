// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/half.h"

#include "castability/certificate.h"
#include "features/cgal/constrained_triangulation.h"
#include "mesh/point_rows.h"
#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <map>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// One of the six flat faces that close a half: coordinate `axis` is `value`, and it looks along ± that axis.
struct Flat {
    int axis = 2;
    double value = 0;
    bool positive = true;
};

class HalfAssembly {
public:
    HalfAssembly(int side, SurfaceSum surface, const Block& block)
        : m_surface(std::move(surface.mesh)), m_open(std::move(surface.open)),
          m_end(side == 1 ? block.max().z() : block.min().z()) {
        for (int k = 0; k < 4; ++k)
            for (const double z : {0.0, m_end}) {
                const bool right = k == 1 || k == 2;
                m_corners.emplace_back(right ? block.max().x() : block.min().x(),
                                       k >= 2 ? block.max().y() : block.min().y(), z);
            }
        for (const Vector3d& p : m_corners)
            m_points.push_back(p);
        // An edge of a flat foot that lies in the parting plane and in a face of the block borders the
        // latter.
        m_flats = {{0, block.min().x(), false}, {0, block.max().x(), true}, {1, block.min().y(), false},
                   {1, block.max().y(), true},  {2, 0, side == 2},          {2, m_end, side == 1}};
    }

    std::optional<IndexedMesh> closed() {
        std::array<std::vector<std::array<int, 2>>, 6> segments = borders();
        addBlockEdges(segments);
        for (std::size_t i = 0; i < m_flats.size(); ++i)
            if (!addFlat(m_flats[i], segments[i]))
                return std::nullopt;
        return whole();
    }

private:
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
        const int corners = m_surface.vertexCount();
        m_surface.V.conservativeResize(corners + static_cast<Eigen::Index>(m_corners.size()), 3);
        m_surface.V.bottomRows(static_cast<Eigen::Index>(m_corners.size())) = pointRows(m_corners);
        Eigen::Index row = m_surface.F.rows();
        m_surface.F.conservativeResize(row + static_cast<Eigen::Index>(m_faces.size()), 3);
        const auto number = [&](int v) {
            const std::size_t at = static_cast<std::size_t>(v);
            return at < m_corners.size() ? corners + v : m_ofSurface[at - m_corners.size()];
        };
        for (const Eigen::RowVector3i& face : m_faces)
            m_surface.F.row(row++) << number(face[0]), number(face[1]), number(face[2]);
        return std::move(m_surface);
    }

    /// The surface's open edges, by the flat face that they lie in.
    std::array<std::vector<std::array<int, 2>>, 6> borders() {
        std::array<std::vector<std::array<int, 2>>, 6> found;
        for (const auto& [from, to] : m_open) {
            const Vector3d a = m_surface.point(from);
            const Vector3d b = m_surface.point(to);
            for (std::size_t i = 0; i < m_flats.size(); ++i)
                if (a[m_flats[i].axis] == m_flats[i].value && b[m_flats[i].axis] == m_flats[i].value) {
                    found[i].push_back({pointOf(from), pointOf(to)});
                    break;
                }
        }
        return found;
    }

    /// The block's twelve edges. Those in the parting plane are interrupted where something opens into the
    /// face.
    void addBlockEdges(std::array<std::vector<std::array<int, 2>>, 6>& segments) {
        for (int k = 0; k < 4; ++k) {
            const int next = (k + 1) % 4;
            addEdge(segments, 2 * k, 2 * next);
            addEdge(segments, 2 * k + 1, 2 * next + 1);
            addEdge(segments, 2 * k, 2 * k + 1);
        }
    }
    void addEdge(std::array<std::vector<std::array<int, 2>>, 6>& segments, int from, int to) {
        const Vector3d a = m_points[static_cast<std::size_t>(from)];
        const Vector3d b = m_points[static_cast<std::size_t>(to)];
        const Vector3d along = (b - a).normalized();
        std::vector<std::pair<double, int>> openings;
        for (std::size_t v = m_corners.size(); v < m_points.size(); ++v) {
            const Vector3d p = m_points[v] - a;
            if ((p - along * p.dot(along)).squaredNorm() == 0)
                openings.emplace_back(p.dot(along), static_cast<int>(v));
        }
        std::sort(openings.begin(), openings.end());
        std::vector<int> stops{from};
        for (const auto& [at, v] : openings)
            stops.push_back(v);
        stops.push_back(to);
        for (std::size_t i = 0; i + 1 < stops.size(); i += 2)
            for (std::size_t flat = 0; flat < m_flats.size(); ++flat)
                if (a[m_flats[flat].axis] == m_flats[flat].value &&
                    b[m_flats[flat].axis] == m_flats[flat].value)
                    segments[flat].push_back({stops[i], stops[i + 1]});
    }

    bool addFlat(const Flat& flat, const std::vector<std::array<int, 2>>& segments) {
        std::map<int, int> numberOf;
        std::vector<int> used;
        std::vector<Vector2d> points;
        std::vector<std::array<int, 2>> outline;
        const int u = (flat.axis + 1) % 3; // (u, v, axis) is right-handed
        const int v = (flat.axis + 2) % 3;
        for (const auto& segment : segments) {
            std::array<int, 2> ends{};
            for (std::size_t k = 0; k < 2; ++k) {
                const auto [at, isNew] = numberOf.try_emplace(segment[k], static_cast<int>(used.size()));
                if (isNew) {
                    used.push_back(segment[k]);
                    const Vector3d& p = m_points[static_cast<std::size_t>(segment[k])];
                    points.emplace_back(p[u], p[v]);
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
    double m_end;
    std::vector<Vector3d> m_corners;
    std::vector<Flat> m_flats;
    std::vector<Vector3d> m_points; ///< the block's corners, then the borders'
    std::vector<int> m_ofSurface;   ///< after the corners: which point of the surface each is
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
