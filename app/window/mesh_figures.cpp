// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/mesh_figures.h"

#include "base/parallel.h"
#include "mesh/measures.h"

namespace moldwright {

MeshFigures KnownFigures::of(const SharedMesh& mesh) {
    for (const Known& known : m_known)
        if (known.mesh == mesh)
            return known.figures;
    Known& known = m_known[m_oldest];
    m_oldest = (m_oldest + 1) % m_known.size();
    known.mesh = mesh;
    MeshFigures& figures = known.figures;
    parallelInvoke({[&] { figures.box = boundingBox(*mesh); }, [&] { figures.area = surfaceArea(*mesh); },
                    [&] { figures.volume = volume(*mesh); }});
    return figures;
}

} // namespace moldwright
