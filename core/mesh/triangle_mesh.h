// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

// After the mesh: it specialises templates that it does not declare.
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>

namespace moldwright {

/// What Moldwright asks of OpenMesh: double points, nothing stored that can be computed.
struct TriangleMeshTraits : OpenMesh::DefaultTraits {
    using Point = Eigen::Vector3d;
    using Normal = Eigen::Vector3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};

/// The core's mesh with topology: neighbourhood queries, splitting, collapsing, flipping.
using TriangleMesh = OpenMesh::TriMesh_ArrayKernelT<TriangleMeshTraits>;

/// `mesh` with topology; vertex and face k keep their index. Precondition: edge- and vertex-manifold,
/// oriented consistently (see diagnose()); asserts otherwise.
[[nodiscard]] TriangleMesh toTriangleMesh(const IndexedMesh& mesh);

/// The plain arrays of `mesh`, which must hold no deleted elements (call garbage_collection() first).
[[nodiscard]] IndexedMesh toIndexedMesh(const TriangleMesh& mesh);

} // namespace moldwright
