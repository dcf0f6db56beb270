// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace moldwright::scene {

/// A surface made ready to be drawn: shaded, and cut into blocks small enough that each is drawn in a blink.
/// It never changes, so it can be made on any thread and be shown in several views.
struct DrawnMesh {
    struct Block {
        int firstFace = 0; ///< its faces lie in a row in the mesh
        int faceCount = 0;
        vtkSmartPointer<vtkPoints> points;
        vtkSmartPointer<vtkFloatArray> normals;
        vtkSmartPointer<vtkCellArray> faces;
    };

    SharedMesh mesh;
    Eigen::AlignedBox3d box; ///< mm
    std::vector<Block> blocks;
    std::shared_ptr<const DrawnMesh> standIn; ///< coarser, for while something moves; null for a small mesh
    std::vector<int> standInFaces; ///< for each of its faces the mesh's face nearest to its middle; none
                                   ///< while sketched

    /// Whether only the stand-in can be drawn.
    [[nodiscard]] bool sketched() const { return standIn && blocks.empty(); }

    /// Points that bound the surface, to be measured in no time: of a large one those of its stand-in.
    [[nodiscard]] const Points& bounds() const { return standIn ? standIn->mesh->V : mesh->V; }
};

using SharedDrawnMesh = std::shared_ptr<const DrawnMesh>;

/// About 1 µs a face; null for null. A mesh of more than 60,000 faces gets a stand-in.
[[nodiscard]] SharedDrawnMesh drawnMesh(const SharedMesh& mesh);

/// As drawnMesh(), but of a large mesh only the stand-in is made: for what is gone in a moment, or until the
/// rest is there.
[[nodiscard]] SharedDrawnMesh sketchedMesh(const SharedMesh& mesh);
[[nodiscard]] SharedDrawnMesh completed(const SharedDrawnMesh& sketch);

} // namespace moldwright::scene
