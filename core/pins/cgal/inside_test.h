// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <memory>

namespace moldwright {

/// Answers whether points lie inside a closed surface, exactly (CGAL). May be asked from several threads.
class InsideTest {
public:
    explicit InsideTest(const IndexedMesh& mesh);
    ~InsideTest();
    InsideTest(const InsideTest&) = delete;
    InsideTest& operator=(const InsideTest&) = delete;

    /// Strictly inside: not on the surface.
    [[nodiscard]] bool inside(const Eigen::Vector3d& p) const;

private:
    struct Tree;
    std::unique_ptr<Tree> m_tree;
};

} // namespace moldwright
