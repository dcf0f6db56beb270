// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/section.h"

#include "features/cgal/constrained_triangulation.h"
#include "mesh/measures.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace moldwright {

namespace {

constexpr double inPlane = 1e-6; ///< of the mesh's size
constexpr int attempts = 4;

/// Collects the places where edges pass through the plane, each once, and the segments between them.
class Outline {
public:
    Outline(const IndexedMesh& mesh, const PartingPlane& cut, double tolerance)
        : m_mesh(mesh), m_cut(cut), m_tolerance(tolerance),
          m_height((mesh.V * cut.normal).array() - cut.offset) {
        for (int f = 0; f < mesh.faceCount(); ++f)
            addFace(f);
    }

    [[nodiscard]] const std::vector<Eigen::Vector3d>& points() const { return m_points; }

    /// Segments that run along each other an even number of times bound nothing.
    [[nodiscard]] std::vector<std::array<int, 2>> segments() const {
        std::vector<std::array<int, 2>> odd;
        for (const auto& [ends, times] : m_times)
            if (times % 2 == 1)
                odd.push_back({ends.first, ends.second});
        return odd;
    }

private:
    [[nodiscard]] bool isBefore(int v) const { return m_height[v] >= -m_tolerance; }

    void addFace(int f) {
        // Of three corners one lies alone on its side: exactly two edges pass through, or none.
        std::array<int, 2> ends{};
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const int a = m_mesh.F(f, k);
            const int b = m_mesh.F(f, (k + 1) % 3);
            if (isBefore(a) != isBefore(b))
                ends[static_cast<std::size_t>(found++)] = isBefore(a) ? pointOn(a, b) : pointOn(b, a);
        }
        if (found == 2 && ends[0] != ends[1])
            ++m_times[std::minmax(ends[0], ends[1])];
    }

    /// `before` lies before the plane, or in it, which is then the place.
    int pointOn(int before, int behind) {
        const bool touches = m_height[before] <= m_tolerance;
        const auto [at, isNew] =
            m_numbers.try_emplace(touches ? std::pair(before, before) : std::pair(before, behind),
                                  static_cast<int>(m_points.size()));
        if (isNew) {
            const double t = touches ? 0 : m_height[before] / (m_height[before] - m_height[behind]);
            m_points.push_back(m_mesh.point(before) + t * (m_mesh.point(behind) - m_mesh.point(before)));
        }
        return at->second;
    }

    const IndexedMesh& m_mesh;
    const PartingPlane& m_cut;
    double m_tolerance;
    Eigen::VectorXd m_height;
    std::vector<Eigen::Vector3d> m_points;
    std::map<std::pair<int, int>, int> m_numbers;
    std::map<std::pair<int, int>, int> m_times;
};

/// None where rounding made the outline cross itself or points coincide.
std::optional<Section> filled(const Outline& outline, const PartingPlane& cut) {
    Section section;
    section.outline = outline.segments();
    if (section.outline.empty())
        return section;
    const Eigen::Isometry3d frame = planeFrame(cut);
    const auto& points = outline.points();
    std::vector<Eigen::Vector2d> flat;
    section.fill.V.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Eigen::Vector3d p = frame * points[i];
        flat.emplace_back(p.head<2>());
        p.z() = 0;
        section.fill.V.row(static_cast<Eigen::Index>(i)) = (frame.inverse() * p).transpose();
    }
    std::optional<Triangles> triangles = triangulateRegion(flat, section.outline);
    if (!triangles)
        return std::nullopt;
    section.fill.F = std::move(*triangles);
    section.area = surfaceArea(section.fill);
    return section;
}

} // namespace

Section sectionOf(const IndexedMesh& mesh, const PartingPlane& cut) {
    const double size = diagonal(mesh);
    // A hair further on, what coincided lies apart.
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const PartingPlane near{cut.normal, cut.offset - attempt * 0.1 * inPlane * size};
        if (std::optional<Section> section = filled(Outline(mesh, near, inPlane * size), near))
            return *std::move(section);
    }
    return {};
}

} // namespace moldwright
