// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/divide_region.h"

#include "fill/planar_cover.h"
#include "mesh/opposite_sides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace moldwright {

namespace {

constexpr double kRounding =
    1e-12; ///< of the part's size, which is about 1: heights this low are in the plane

/// One cut. Works on a copy of the choices, which is given away only if the cut is clean.
class Cut {
public:
    Cut(const ChoiceMesh& choices, int region, const DividingPlane& plane)
        : m_choices(choices), m_region(region), m_beyond(choices.regions), m_plane(plane) {
        m_sign.reserve(choices.points.size());
        for (const Eigen::Vector3d& x : choices.points) {
            const double distance = x.dot(plane.normal) - plane.offset;
            m_sign.push_back(distance == 0 ? 0 : distance > 0 ? 1 : -1);
        }
    }

    bool divide() {
        splitEdges();
        splitFaces();
        takeBeyond();
        return !m_border.empty() && triangulate() && addFacesBetween();
    }

    ChoiceMesh take() { return std::move(m_choices); }

private:
    [[nodiscard]] const Eigen::Vector3d& point(int v) const {
        return m_choices.points[static_cast<std::size_t>(v)];
    }
    [[nodiscard]] int sign(int v) const { return m_sign[static_cast<std::size_t>(v)]; }
    [[nodiscard]] bool ofRegion(const ChoiceFace& face) const {
        return face.made == m_region || face.covered == m_region;
    }

    static std::uint64_t key(int a, int b) {
        return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
               static_cast<std::uint64_t>(std::max(a, b));
    }

    void splitEdges() {
        m_splitAt.assign(m_choices.points.size(), 0);
        for (const ChoiceFace& face : m_choices.faces)
            for (std::size_t k = 0; ofRegion(face) && k < 3; ++k) {
                const auto [a, b] = std::minmax(face.corners[k], face.corners[(k + 1) % 3]);
                if (sign(a) * sign(b) >= 0 || m_middle.contains(key(a, b)))
                    continue;
                const double from = point(a).dot(m_plane.normal) - m_plane.offset;
                const double to = point(b).dot(m_plane.normal) - m_plane.offset;
                m_middle.emplace(key(a, b), pointAt(point(a) + from / (from - to) * (point(b) - point(a))));
                m_splitAt[static_cast<std::size_t>(a)] = m_splitAt[static_cast<std::size_t>(b)] = 1;
            }
    }

    /// A new point, or the one of this cut that stands there already: walls of the part and of the filling
    /// often coincide.
    int pointAt(Eigen::Vector3d x) {
        if (std::abs(x.z()) <= kRounding)
            x.z() = 0;
        const auto cell = [&](Eigen::Index k, int by) {
            return static_cast<std::int64_t>(std::floor(x[k] / (4 * kRounding))) + by;
        };
        for (int i = 0; i < 27; ++i) {
            const auto [from, to] =
                m_newAt.equal_range({cell(0, i % 3 - 1), cell(1, i / 3 % 3 - 1), cell(2, i / 9 - 1)});
            for (auto near = from; near != to; ++near)
                if ((point(near->second) - x).norm() <= kRounding)
                    return near->second;
        }
        const auto fresh = static_cast<int>(m_choices.points.size());
        m_newAt.emplace(std::array{cell(0, 0), cell(1, 0), cell(2, 0)}, fresh);
        m_choices.points.push_back(x);
        m_choices.partPoint.push_back(-1);
        m_sign.push_back(0);
        return fresh;
    }

    [[nodiscard]] int middle(int a, int b) const {
        if (!m_splitAt[static_cast<std::size_t>(a)] || !m_splitAt[static_cast<std::size_t>(b)])
            return -1;
        const auto found = m_middle.find(key(a, b));
        return found == m_middle.end() ? -1 : found->second;
    }

    /// Both copies of a face between regions are split alike: the shorter diagonal, then the lower point.
    void splitFaces() {
        const std::size_t count = m_choices.faces.size();
        for (std::size_t f = 0; f < count; ++f) {
            const std::array<int, 3> c = m_choices.faces[f].corners;
            const std::array<int, 3> m = {middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
            const auto split = std::count_if(m.begin(), m.end(), [](int v) { return v >= 0; });
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                const std::size_t last = (k + 2) % 3;
                if (split == 1 && m[k] >= 0)
                    replace(f, {{{c[k], m[k], c[last]}, {m[k], c[next], c[last]}}});
                if (split != 2 || m[k] < 0 || m[last] < 0)
                    continue;
                // Corner k is cut off; the rest has the corners m[k], next, last, m[last].
                const auto across = std::pair((point(m[k]) - point(c[last])).norm(), c[last]);
                const auto along = std::pair((point(c[next]) - point(m[last])).norm(), c[next]);
                if (across < along)
                    replace(f, {{{c[k], m[k], m[last]}, {m[k], c[next], c[last]}, {m[k], c[last], m[last]}}});
                else
                    replace(f,
                            {{{c[k], m[k], m[last]}, {m[k], c[next], m[last]}, {c[next], c[last], m[last]}}});
            }
        }
    }

    void replace(std::size_t f, const std::vector<std::array<int, 3>>& pieces) {
        const ChoiceFace whole = m_choices.faces[f];
        bool replaced = false;
        for (const auto& corners : pieces) {
            if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
                continue;
            if (replaced)
                m_choices.faces.push_back(whole);
            (replaced ? m_choices.faces.back() : m_choices.faces[f]).corners = corners;
            replaced = true;
        }
    }

    /// Whether a face of the region's boundary belongs to its space beyond the plane.
    [[nodiscard]] bool beyond(const ChoiceFace& face) const {
        for (const int v : face.corners)
            if (sign(v) != 0)
                return sign(v) > 0;
        // In the plane: it looks away from the space that it bounds.
        const Eigen::Vector3d up = (point(face.corners[1]) - point(face.corners[0]))
                                       .cross(point(face.corners[2]) - point(face.corners[0]));
        return up.dot(m_plane.normal) * (face.made == m_region ? 1 : -1) < 0;
    }

    void takeBeyond() {
        for (ChoiceFace& face : m_choices.faces) {
            if (!ofRegion(face) || !beyond(face))
                continue;
            const int how = bounds(face, m_region);
            (face.made == m_region ? face.made : face.covered) = m_beyond;
            for (std::size_t k = 0; how != 0 && k < 3; ++k) {
                const int from = face.corners[k];
                const int to = face.corners[(k + 1) % 3];
                if (sign(from) == 0 && sign(to) == 0)
                    how > 0 ? m_border.add(from, to) : m_border.add(to, from);
            }
        }
        ++m_choices.regions;
    }

    /// Covers what the border encloses in the plane. The filled surface may dip below the part by a hair:
    /// where the border crosses itself, both its edges get a point, and what lies between them the wrong way
    /// round is covered the other way round.
    bool triangulate() {
        const Eigen::Vector3d e1 = m_plane.normal.unitOrthogonal();
        const Eigen::Vector3d e2 = m_plane.normal.cross(e1);
        std::map<int, int> number;
        std::vector<int> vertices;
        std::vector<Eigen::Vector2d> points;
        const auto numberOf = [&](int v) {
            const auto [place, fresh] = number.emplace(v, static_cast<int>(points.size()));
            if (fresh) {
                vertices.push_back(v);
                points.emplace_back(point(v).dot(e1), point(v).dot(e2));
            }
            return place->second;
        };
        std::vector<std::array<int, 2>> segments;
        for (const auto& [a, b] : m_border.list())
            segments.push_back({numberOf(a), numberOf(b)});
        const std::optional<PlanarCover> cover = coverBorder(points, segments);
        if (!cover)
            return false;
        for (std::size_t p = points.size(); p < cover->points.size(); ++p)
            vertices.push_back(pointAt(cover->points[p].x() * e1 + cover->points[p].y() * e2 +
                                       m_plane.offset * m_plane.normal));
        splitBorder(cover->chains, vertices);
        for (const auto& t : cover->triangles) {
            const std::array<int, 3> c = {vertices[static_cast<std::size_t>(t[0])],
                                          vertices[static_cast<std::size_t>(t[1])],
                                          vertices[static_cast<std::size_t>(t[2])]};
            if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0])
                m_between.push_back(c);
        }
        return true;
    }

    /// Puts the points along each edge of the border onto it, one after the other.
    void splitBorder(std::vector<std::vector<int>> chains, const std::vector<int>& vertices) {
        m_border = {};
        m_middle.clear();
        m_splitAt.assign(m_choices.points.size(), 0);
        std::size_t longest = 0;
        for (std::vector<int>& chain : chains) {
            for (int& v : chain)
                v = vertices[static_cast<std::size_t>(v)];
            chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
                m_border.add(chain[i], chain[i + 1]);
                if (i + 2 == chain.size())
                    break;
                m_middle.emplace(key(chain[i], chain.back()), chain[i + 1]);
                for (const int v : {chain[i], chain[i + 1], chain.back()})
                    m_splitAt[static_cast<std::size_t>(v)] = 1;
            }
            longest = std::max(longest, chain.size());
        }
        for (std::size_t i = 2; i < longest; ++i)
            splitFaces();
    }

    bool addFacesBetween() {
        DirectedEdges open = m_border;
        for (const auto& c : m_between)
            for (std::size_t k = 0; k < 3; ++k)
                open.add(c[(k + 1) % 3], c[k]);
        if (m_between.empty() || !open.empty())
            return false;
        for (const auto& c : m_between) {
            const auto up = static_cast<std::uint8_t>(m_plane.label == 0 ? 1 : m_plane.label);
            const auto down = static_cast<std::uint8_t>(m_plane.label == 0 ? 2 : m_plane.label);
            m_choices.faces.push_back({{c[0], c[1], c[2]}, up, -1, m_region, m_beyond});
            m_choices.faces.push_back({{c[0], c[2], c[1]}, down, -1, m_beyond, m_region});
        }
        return true;
    }

    ChoiceMesh m_choices;
    int m_region;
    int m_beyond;
    DividingPlane m_plane;
    std::multimap<std::array<std::int64_t, 3>, int>
        m_newAt;                                     ///< the points that the cut makes, by cells of space
    std::vector<signed char> m_sign;                 ///< per point: beyond the plane 1, before it −1, in it 0
    std::vector<char> m_splitAt;                     ///< per point: whether an edge at it is split
    std::unordered_map<std::uint64_t, int> m_middle; ///< the point at which an edge is split
    DirectedEdges m_border; ///< where the boundary beyond the plane ends, its faces on the left
    std::vector<std::array<int, 3>> m_between; ///< the faces between the regions, seen from beyond
};

bool isClosedManifold(const ChoiceMesh& choices, const std::vector<char>& filled) {
    std::vector<int> choiceOf;
    const PartedMesh surface = surfaceWith(choices, filled, choiceOf);
    return closedManifold(surface.mesh.F, surface.mesh.vertexCount());
}

} // namespace

bool divideRegion(ChoiceMesh& choices, int region, const DividingPlane& plane, const CutCheck& check) {
    Cut cut(choices, region, plane);
    if (!cut.divide())
        return false;
    ChoiceMesh divided = cut.take();
    for (const char filled : {0, 1})
        if (!isClosedManifold(divided, std::vector<char>(static_cast<std::size_t>(divided.regions), filled)))
            return false;
    if (check && !check(divided, region, divided.regions - 1))
        return false;
    choices = std::move(divided);
    return true;
}

} // namespace moldwright
