// SPDX-License-Identifier: AGPL-3.0-or-later
#include "repair/wrap_surface.h"

#include "repair/cgal/surface_mesh.h"

#include <CGAL/alpha_wrap_3.h>

namespace moldwright {

IndexedMesh wrapSurface(const IndexedMesh& mesh, double alpha, double offset) {
    const RepairSoup soup = toSoup(mesh);
    RepairMesh wrap;
    CGAL::alpha_wrap_3(soup.points, soup.faces, alpha, offset, wrap);
    return toIndexed(wrap);
}

} // namespace moldwright
