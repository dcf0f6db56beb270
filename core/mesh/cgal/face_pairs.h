// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <memory>

namespace moldwright {

/// Exact questions about the faces of one mesh, whatever the rounding of its coordinates; may be asked from
/// several threads at once. The mesh must outlive this.
class FacePairs {
public:
    explicit FacePairs(const IndexedMesh& mesh);
    ~FacePairs();
    FacePairs(const FacePairs&) = delete;
    FacePairs& operator=(const FacePairs&) = delete;

    /// True when the corners of f lie on one line.
    [[nodiscard]] bool flat(int f) const;

    /// True when f and g meet elsewhere than at points and edges they share. Precondition: neither is flat.
    [[nodiscard]] bool cross(int f, int g) const;

private:
    class Predicates;
    std::unique_ptr<Predicates> m_predicates;
};

} // namespace moldwright
