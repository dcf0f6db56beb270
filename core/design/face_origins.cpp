// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/face_origins.h"

#include "base/parallel.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"
#include "mesh/nearest_on_triangle.h"

#include <algorithm>
#include <set>
#include <utility>

namespace moldwright {

namespace {

constexpr double kOnPart = 2e-3; ///< of the diagonal: clean-up moves faces off the part by no more
constexpr std::size_t kGrain = 512;

} // namespace

FaceOrigins::FaceOrigins(SharedMesh part, SharedMesh shape, std::shared_ptr<const Points> before)
    : m_part(std::move(part)), m_shape(std::move(shape)), m_before(std::move(before)),
      m_faces(static_cast<std::size_t>(m_shape->faceCount()), -1) {
    const ClosestPoint surface(*m_part);
    const double onPart = kOnPart * diagonal(*m_part);
    parallelFor(m_faces.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const Eigen::RowVector3i c = m_shape->F.row(static_cast<Eigen::Index>(f));
            const Eigen::Vector3d middle =
                (m_before->row(c[0]) + m_before->row(c[1]) + m_before->row(c[2])).transpose() / 3;
            const ClosestPoint::Nearest nearest = surface.nearest(middle);
            if ((nearest.point - middle).norm() <= onPart)
                m_faces[f] = nearest.face;
        }
    });
}

bool FaceOrigins::areOf(const SharedMesh& part, const IndexedMesh& shape, const Points& before) const {
    const auto same = [](const auto& a, const auto& b) { return a.rows() == b.rows() && a == b; };
    return part == m_part && same(shape.F, m_shape->F) && same(before, *m_before);
}

int FaceOrigins::faceFrom(int partFace) const {
    const auto found = std::ranges::find(m_faces, partFace);
    return found == m_faces.end() ? -1 : static_cast<int>(found - m_faces.begin());
}

std::vector<int> FaceOrigins::onPart(const std::vector<int>& shapeFaces) const {
    std::set<int> faces;
    for (const int f : shapeFaces)
        if (const int face = m_faces[static_cast<std::size_t>(f)]; face >= 0)
            faces.insert(face);
    return {faces.begin(), faces.end()};
}

std::optional<SurfacePlace> FaceOrigins::onPart(const IndexedMesh& shape, const SurfacePlace& place) const {
    const int face = m_faces[static_cast<std::size_t>(place.face)];
    if (face < 0)
        return std::nullopt;
    const Eigen::Vector3d shares = nearestOnTriangle(
        place.point, shape.corner(place.face, 0), shape.corner(place.face, 1), shape.corner(place.face, 2));
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        before += shares[k] * m_before->row(shape.F(place.face, k)).transpose();
    return SurfacePlace{face, before};
}

} // namespace moldwright
