// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <span>
#include <vector>

namespace moldwright {

/// The faces of a mesh as planes and directions see them, stored for vector code: eight side by side.
class FaceArrays {
public:
    static constexpr int kLanes = 8;

    struct alignas(64) Batch {
        double corner[9][kLanes]; ///< coordinate i of corner k in row 3k + i
        double normal[3][kLanes]; ///< unit; 0 for a face without area
        double area[kLanes];      ///< 0 for idle lanes
    };

    explicit FaceArrays(const IndexedMesh& mesh);

    /// Number of batches that hold a mesh's faces.
    [[nodiscard]] static std::size_t batchCount(const IndexedMesh& mesh);
    /// Fills batches with the faces of a mesh from batch `first` on.
    static void gather(const IndexedMesh& mesh, std::size_t first, std::span<Batch> batches);

    [[nodiscard]] const std::vector<Batch>& batches() const { return m_batches; }
    [[nodiscard]] double area() const;

private:
    std::vector<Batch> m_batches;
};

} // namespace moldwright
