// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/insert_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

namespace moldwright {

namespace {

constexpr int kOutward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}; ///< face k is opposite corner k
constexpr double kFlat = 1e-3; ///< of the volume given way: tetrahedra no larger are all but flat
constexpr int kRounds = 8;     ///< in which neighbours give way too

using Face = std::array<int, 3>;

/// A face's corners from the smallest on: the same for all ways to begin, another one seen from behind.
Face fromSmallest(Face face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

Face faceOf(const TetMesh& tets, int t, int k) {
    return fromSmallest({tets.T(t, kOutward[k][0]), tets.T(t, kOutward[k][1]), tets.T(t, kOutward[k][2])});
}

/// Six times the volume between a face that looks outward and a point before it, on its inner side.
double sixfoldVolume(const TetMesh& tets, const Face& face, const Eigen::Vector3d& point) {
    const Eigen::Vector3d a = tets.V.row(face[0]).transpose() - point;
    const Eigen::Vector3d b = tets.V.row(face[1]).transpose() - point;
    const Eigen::Vector3d c = tets.V.row(face[2]).transpose() - point;
    return a.dot(b.cross(c));
}

/// The tetrahedron that holds the point deepest.
std::optional<int> tetAt(const TetMesh& tets, const Eigen::Vector3d& point) {
    std::optional<int> found;
    double deepest = 0;
    for (int t = 0; t < tets.T.rows(); ++t) {
        double least = 1;
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
            const double volume = sixfoldVolume(tets, faceOf(tets, t, k), point);
            least = k == 0 ? volume : std::min(least, volume);
            sum += volume;
        }
        if (least >= 0 && sum > 0 && (!found || least / sum > deepest)) {
            found = t;
            deepest = least / sum;
        }
    }
    return found;
}

/// What gives way to a point: tetrahedra, and the faces that bound them, outward.
class Cavity {
public:
    Cavity(const TetMesh& tets, int first) : m_tets(tets) {
        for (int t = 0; t < tets.T.rows(); ++t)
            for (int k = 0; k < 4; ++k)
                m_tetOf[faceOf(tets, t, k)] = t;
        take(first);
    }

    /// Lets neighbours give way until no face is too near to the point. False where the surface is.
    bool clear(const Eigen::Vector3d& point) {
        for (int round = 0; round < kRounds; ++round) {
            double whole = 0;
            for (const Face& face : m_faces)
                whole += sixfoldVolume(m_tets, face, point);
            std::vector<Face> near;
            for (const Face& face : m_faces)
                if (sixfoldVolume(m_tets, face, point) <= kFlat * whole)
                    near.push_back(face);
            if (near.empty())
                return true;
            for (const Face& face : near) {
                const auto beyond = m_tetOf.find(fromSmallest({face[0], face[2], face[1]}));
                if (beyond == m_tetOf.end())
                    return false;
                take(beyond->second);
            }
        }
        return false;
    }

    [[nodiscard]] const std::vector<int>& tets() const { return m_taken; }
    [[nodiscard]] const std::vector<Face>& faces() const { return m_faces; }

private:
    void take(int t) {
        if (std::ranges::find(m_taken, t) != m_taken.end())
            return;
        m_taken.push_back(t);
        for (int k = 0; k < 4; ++k) {
            const Face face = faceOf(m_tets, t, k);
            const Face behind = fromSmallest({face[0], face[2], face[1]});
            if (const auto shared = std::ranges::find(m_faces, behind); shared != m_faces.end())
                m_faces.erase(shared);
            else
                m_faces.push_back(face);
        }
    }

    const TetMesh& m_tets;
    std::map<Face, int> m_tetOf; ///< by outward faces
    std::vector<int> m_taken;
    std::vector<Face> m_faces;
};

} // namespace

bool insertPoint(TetMesh& tets, const Eigen::Vector3d& point) {
    const std::optional<int> first = tetAt(tets, point);
    if (!first)
        return false;
    Cavity cavity(tets, *first);
    if (!cavity.clear(point))
        return false;
    std::vector<char> gone(static_cast<std::size_t>(tets.T.rows()), 0);
    for (const int t : cavity.tets())
        gone[static_cast<std::size_t>(t)] = 1;
    Tetrahedra T(tets.T.rows() - static_cast<Eigen::Index>(cavity.tets().size()) +
                     static_cast<Eigen::Index>(cavity.faces().size()),
                 4);
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < tets.T.rows(); ++t)
        if (!gone[static_cast<std::size_t>(t)])
            T.row(count++) = tets.T.row(t);
    const auto fresh = static_cast<int>(tets.V.rows());
    for (const Face& face : cavity.faces())
        T.row(count++) << fresh, face[0], face[1], face[2];
    tets.T = std::move(T);
    tets.V.conservativeResize(fresh + 1, Eigen::NoChange);
    tets.V.row(fresh) = point.transpose();
    return true;
}

} // namespace moldwright
