// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <cstddef>
#include <vector>

namespace moldwright {

/// Where a mold half meets the cast while it leaves along its direction: for each face of the cast the
/// stretches of the way on which the face's middle lies within the half. Empty where mold and cast are
/// proved.
class ContactWays {
public:
    /// A stretch of the half's way, mm.
    struct Stretch {
        double from = 0;
        double to = 0;
    };

    /// One list of stretches for each face.
    explicit ContactWays(const std::vector<std::vector<Stretch>>& ofFaces);
    ContactWays() = default;

    /// Whether the half meets this face once it has gone `way` mm.
    [[nodiscard]] bool touches(std::size_t face, double way) const;
    /// Whether it meets any, anywhere on its way.
    [[nodiscard]] bool any() const { return !m_stretches.empty(); }

private:
    std::vector<std::size_t> m_first; ///< of each face, and one more
    std::vector<Stretch> m_stretches;
};

/// What a half, a closed mesh, meets as it moves along d (unit); `middles` are those of the cast's faces,
/// n×3, mm. What lies within 1e-5 of the half's size of its surface does not count: halves and cast touch
/// there. O(m) on even meshes.
[[nodiscard]] ContactWays contactWays(const Points& middles, const IndexedMesh& half,
                                      const Eigen::Vector3d& d);

} // namespace moldwright
