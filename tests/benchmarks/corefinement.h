// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <array>
#include <memory>

namespace moldwright::bench {

/// The general way to a mold's halves, as a peer: CGAL's exact corefinement takes the cavities out of both
/// halves of the block.
class Corefinement {
public:
    Corefinement(const std::array<IndexedMesh, 2>& blocks, const IndexedMesh& cavities);
    ~Corefinement();
    Corefinement(const Corefinement&) = delete;
    Corefinement& operator=(const Corefinement&) = delete;

    /// Both differences, in CGAL's own meshes: neither reading the input nor reading the result is part of
    /// it. Only once: corefinement changes its input. False when CGAL gave up.
    [[nodiscard]] bool run();

    /// Volume of both halves as cut.
    [[nodiscard]] double volume() const;

private:
    struct Meshes;
    std::unique_ptr<Meshes> m_meshes;
};

} // namespace moldwright::bench
