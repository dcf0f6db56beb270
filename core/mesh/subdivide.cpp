// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/subdivide.h"

#include "mesh/triangle_mesh.h"

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include <algorithm>

namespace moldwright {

namespace {

std::size_t largestValence(const TriangleMesh& mesh) {
    std::size_t largest = 0;
    for (const auto v : mesh.vertices())
        largest = std::max<std::size_t>(largest, mesh.valence(v));
    return largest;
}

} // namespace

IndexedMesh subdivide(const IndexedMesh& mesh, int rounds) {
    TriangleMesh smooth = toTriangleMesh(mesh);
    OpenMesh::Subdivider::Uniform::LoopT<TriangleMesh, double> loop;
    loop.init_weights(largestValence(smooth) + 1); // OpenMesh's own table ends at 49, unchecked
    loop.attach(smooth);
    loop(static_cast<std::size_t>(rounds));
    loop.detach();
    return toIndexedMesh(smooth);
}

} // namespace moldwright
