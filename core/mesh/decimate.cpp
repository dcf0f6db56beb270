// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/decimate.h"

#include "mesh/triangle_mesh.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace moldwright {

IndexedMesh decimate(const IndexedMesh& mesh, int targetFaces) {
    if (mesh.faceCount() <= targetFaces)
        return mesh;
    TriangleMesh reduced = toTriangleMesh(mesh);
    reduced.request_face_normals();
    reduced.update_face_normals();
    OpenMesh::Decimater::DecimaterT<TriangleMesh> decimater(reduced);
    OpenMesh::Decimater::ModQuadricT<TriangleMesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<TriangleMesh>::Handle flipping;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    decimater.add(flipping);
    decimater.initialize();
    decimater.decimate_to_faces(0, static_cast<std::size_t>(targetFaces));
    reduced.garbage_collection();
    return toIndexedMesh(reduced);
}

} // namespace moldwright
