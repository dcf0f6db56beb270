// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>

namespace moldwright {

/// What panels tell of a mesh.
struct MeshFigures {
    Eigen::AlignedBox3d box; ///< mm
    double area = 0;         ///< mm²
    double volume = 0;       ///< mm³
};

/// The figures of the meshes at hand, each measured once: panels ask for them many times a second.
class KnownFigures {
public:
    /// Precondition: not null.
    [[nodiscard]] MeshFigures of(const SharedMesh& mesh);

private:
    struct Known {
        SharedMesh mesh; ///< held, so that no other mesh can come to lie in its place
        MeshFigures figures;
    };
    std::array<Known, 3> m_known; ///< part, cast, and the shape of a run
    std::size_t m_oldest = 0;
};

} // namespace moldwright
