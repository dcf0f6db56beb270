// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/stop_point.h"
#include "mesh/cgal/face_pairs.h"
#include "mesh/check.h"
#include "mesh/touching_boxes.h"

namespace moldwright {

std::vector<std::pair<int, int>> selfIntersections(const IndexedMesh& mesh) {
    const FacePairs pairs(mesh);
    std::vector<int> faces;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        if (!pairs.flat(f))
            faces.push_back(f);
    }
    return pairsWithTouchingBoxes(mesh, faces, [&](int f, int g) { return pairs.cross(f, g); });
}

std::vector<int> flatFaces(const IndexedMesh& mesh) {
    const FacePairs pairs(mesh);
    std::vector<int> flat;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        if (pairs.flat(f))
            flat.push_back(f);
    }
    return flat;
}

} // namespace moldwright
