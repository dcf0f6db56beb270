// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/geodesic_disc.h"
#include "mesh/indexed_mesh.h"

#include <memory>
#include <optional>
#include <vector>

namespace moldwright {

/// Where the faces of a shape, bent from a part, were on the part.
class FaceOrigins {
public:
    /// `before`: n×3, mm: where each point of `shape` was before it was bent.
    FaceOrigins(SharedMesh part, SharedMesh shape, std::shared_ptr<const Points> before);

    /// Whether they are those of this shape too: one with the same faces, of points that were at the same
    /// places.
    [[nodiscard]] bool areOf(const SharedMesh& part, const IndexedMesh& shape, const Points& before) const;

    /// For each face of the shape: the part's face that its middle was on; −1 where filling made it.
    [[nodiscard]] const std::vector<int>& faces() const { return m_faces; }
    /// The first face of the shape that came from this one of the part; −1 for none.
    [[nodiscard]] int faceFrom(int partFace) const;
    /// The part's faces that these of the shape came from; ascending.
    [[nodiscard]] std::vector<int> onPart(const std::vector<int>& shapeFaces) const;
    /// Where on the part a place on `shape` was, one that areOf() holds for; none where filling made it.
    [[nodiscard]] std::optional<SurfacePlace> onPart(const IndexedMesh& shape,
                                                     const SurfacePlace& place) const;

private:
    SharedMesh m_part;
    SharedMesh m_shape;
    std::shared_ptr<const Points> m_before;
    std::vector<int> m_faces;
};

} // namespace moldwright
