// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/mesh_figures.h"

#include "mesh/measures.h"

namespace moldwright {

MeshFigures KnownFigures::of(const SharedMesh& mesh) {
    for (const Known& known : m_known)
        if (known.mesh == mesh)
            return known.figures;
    Known& known = m_known[m_oldest];
    m_oldest = (m_oldest + 1) % m_known.size();
    known = {mesh, {boundingBox(*mesh), surfaceArea(*mesh), volume(*mesh)}};
    return known.figures;
}

} // namespace moldwright
