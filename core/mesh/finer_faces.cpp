// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/finer_faces.h"

#include <algorithm>
#include <array>
#include <map>

namespace moldwright {

namespace {

class Cutter {
public:
    Cutter(const IndexedMesh& mesh, const std::vector<char>& wanted, double longest)
        : m_wanted(wanted), m_longest(longest) {
        for (const auto& p : mesh.V.rowwise())
            m_points.emplace_back(p.transpose());
        for (int f = 0; f < mesh.faceCount(); ++f)
            m_faces.push_back({{mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)}, f});
    }

    FinerMesh cut() {
        while (markLong())
            cutOnce();
        FinerMesh finer;
        finer.mesh.V.resize(static_cast<Eigen::Index>(m_points.size()), 3);
        for (std::size_t v = 0; v < m_points.size(); ++v)
            finer.mesh.V.row(static_cast<Eigen::Index>(v)) = m_points[v].transpose();
        finer.mesh.F.resize(static_cast<Eigen::Index>(m_faces.size()), 3);
        for (std::size_t f = 0; f < m_faces.size(); ++f) {
            const auto& [a, b, c] = m_faces[f].corners;
            finer.mesh.F.row(static_cast<Eigen::Index>(f)) << a, b, c;
            finer.from.push_back(m_faces[f].from);
        }
        return finer;
    }

private:
    struct Face {
        std::array<int, 3> corners;
        int from;
    };

    [[nodiscard]] double length(int a, int b) const {
        return (m_points[static_cast<std::size_t>(a)] - m_points[static_cast<std::size_t>(b)]).norm();
    }

    /// Gives each edge that is too long the point in its middle; whether there are any.
    bool markLong() {
        m_middles.clear();
        for (const Face& face : m_faces)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [low, high] = std::minmax(face.corners[k], face.corners[(k + 1) % 3]);
                if (m_wanted[static_cast<std::size_t>(face.from)] == 0 || length(low, high) <= m_longest)
                    continue;
                const auto [at, isNew] =
                    m_middles.try_emplace({low, high}, static_cast<int>(m_points.size()));
                if (isNew)
                    m_points.emplace_back(
                        (m_points[static_cast<std::size_t>(low)] + m_points[static_cast<std::size_t>(high)]) /
                        2);
            }
        return !m_middles.empty();
    }

    [[nodiscard]] int middleOf(int a, int b) const {
        const auto found = m_middles.find(std::minmax(a, b));
        return found == m_middles.end() ? -1 : found->second;
    }

    void cutOnce() {
        std::vector<Face> faces;
        for (const Face& face : m_faces) {
            std::array<int, 3> middle{};
            int cuts = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                middle[k] = middleOf(face.corners[k], face.corners[(k + 1) % 3]);
                cuts += middle[k] >= 0 ? 1 : 0;
            }
            addParts(face, middle, cuts, faces);
        }
        m_faces = std::move(faces);
    }

    void addParts(const Face& face, const std::array<int, 3>& middle, int cuts,
                  std::vector<Face>& faces) const {
        const auto add = [&](int a, int b, int c) { faces.push_back({{a, b, c}, face.from}); };
        // Turned so that the first edge is cut, and of two the last is not.
        std::size_t k = 0;
        while (cuts > 0 && cuts < 3 && (middle[k] < 0 || (cuts == 2 && middle[(k + 2) % 3] >= 0)))
            ++k;
        const auto& [a, b, c] =
            std::array{face.corners[k], face.corners[(k + 1) % 3], face.corners[(k + 2) % 3]};
        const auto& [ab, bc, ca] = std::array{middle[k], middle[(k + 1) % 3], middle[(k + 2) % 3]};
        if (cuts == 0) {
            add(a, b, c);
        } else if (cuts == 1) {
            add(a, ab, c);
            add(ab, b, c);
        } else if (cuts == 3) {
            add(a, ab, ca);
            add(ab, b, bc);
            add(bc, c, ca);
            add(ab, bc, ca);
        } else {
            add(ab, b, bc);
            const bool fromA = length(a, bc) <= length(ab, c);
            add(a, ab, fromA ? bc : c);
            add(fromA ? a : ab, bc, c);
        }
    }

    const std::vector<char>& m_wanted;
    double m_longest;
    std::vector<Eigen::Vector3d> m_points;
    std::vector<Face> m_faces;
    std::map<std::pair<int, int>, int> m_middles;
};

} // namespace

FinerMesh withFinerFaces(const IndexedMesh& mesh, const std::vector<char>& wanted, double longest) {
    return Cutter(mesh, wanted, longest).cut();
}

} // namespace moldwright
