// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Core>

#include <memory>

namespace moldwright {

/// Answers how far points are from a surface, and what meets it, by a tree of boxes (CGAL AABB tree).
/// Thread-safe once built.
class ClosestPoint {
public:
    explicit ClosestPoint(const IndexedMesh& mesh);
    ~ClosestPoint();
    ClosestPoint(ClosestPoint&&) noexcept;
    ClosestPoint& operator=(ClosestPoint&&) noexcept;

    /// Distance from p to the nearest point of the surface, in the mesh's units.
    [[nodiscard]] double distance(const Eigen::Vector3d& p) const;

    /// That point and the face it lies on.
    struct Nearest {
        int face;
        Eigen::Vector3d point;
    };
    [[nodiscard]] Nearest nearest(const Eigen::Vector3d& p) const;

    /// Whether `other`, moved by `shift`, crosses or touches the surface, but for rounding.
    [[nodiscard]] bool meets(const IndexedMesh& other, const Eigen::Vector3d& shift) const;

    /// Whether p lies in the solid. Precondition: the surface is closed.
    [[nodiscard]] bool holds(const Eigen::Vector3d& p) const;

private:
    struct Tree;
    std::unique_ptr<Tree> m_tree;
};

} // namespace moldwright
