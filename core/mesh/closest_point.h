// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <memory>

namespace moldwright {

/// Answers how far points are from a surface, by a tree of boxes (CGAL AABB tree). Thread-safe once built.
class ClosestPoint {
public:
    explicit ClosestPoint(const IndexedMesh& mesh);
    ~ClosestPoint();
    ClosestPoint(ClosestPoint&&) noexcept;
    ClosestPoint& operator=(ClosestPoint&&) noexcept;

    /// Distance from p to the nearest point of the surface, in the mesh's units.
    [[nodiscard]] double distance(const Eigen::Vector3d& p) const;

private:
    struct Tree;
    std::unique_ptr<Tree> m_tree;
};

} // namespace moldwright
