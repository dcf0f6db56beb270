// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/drawn_mesh.h"

#include "mesh/cluster.h"
#include "mesh/measures.h"
#include "scene/shading.h"
#include "scene/value_scale.h"

#include <vtkTypeInt32Array.h>

#include <algorithm>

namespace moldwright::scene {

namespace {

constexpr int blockFaces = 25000;   ///< drawn in about 20 ms without a graphics card
constexpr int largeFaces = 60000;   ///< more of them cannot be drawn smoothly everywhere
constexpr int standInFaces = 25000; ///< of the mesh that is drawn instead

vtkSmartPointer<vtkFloatArray> emptyRows(std::size_t rows) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
    return array;
}

vtkSmartPointer<vtkCellArray> triangles(const std::vector<int>& corners) {
    const auto faceCount = static_cast<vtkIdType>(corners.size()) / 3;
    const vtkNew<vtkTypeInt32Array> starts;
    starts->SetNumberOfValues(faceCount + 1);
    for (vtkIdType f = 0; f <= faceCount; ++f)
        starts->SetValue(f, static_cast<int>(3 * f));
    const vtkNew<vtkTypeInt32Array> ends;
    ends->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
    std::ranges::copy(corners, ends->GetPointer(0));
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(starts, ends);
    return cells;
}

/// Faces first … first + count of a shaded mesh over points of their own; `number` is −1 all over, before
/// and after.
DrawnMesh::Block blockOf(const ShadedMesh& shaded, int first, int count, std::vector<int>& number) {
    std::vector<int> used;
    std::vector<int> corners;
    corners.reserve(3 * static_cast<std::size_t>(count));
    for (int f = first; f < first + count; ++f)
        for (int k = 0; k < 3; ++k) {
            const int point = shaded.faces(f, k);
            int& own = number[static_cast<std::size_t>(point)];
            if (own < 0) {
                own = static_cast<int>(used.size());
                used.push_back(point);
            }
            corners.push_back(own);
        }
    const auto places = emptyRows(used.size());
    DrawnMesh::Block block{first, count, vtkSmartPointer<vtkPoints>::New(), emptyRows(used.size()),
                           triangles(corners)};
    for (std::size_t i = 0; i < used.size(); ++i) {
        std::copy_n(shaded.points.row(used[i]).data(), 3, places->GetPointer(3 * static_cast<vtkIdType>(i)));
        std::copy_n(shaded.normals.row(used[i]).data(), 3,
                    block.normals->GetPointer(3 * static_cast<vtkIdType>(i)));
        number[static_cast<std::size_t>(used[i])] = -1;
    }
    block.points->SetData(places);
    return block;
}

std::vector<DrawnMesh::Block> blocksOf(const IndexedMesh& mesh) {
    const ShadedMesh shaded = shade(mesh);
    std::vector<int> number(static_cast<std::size_t>(shaded.points.rows()), -1);
    std::vector<DrawnMesh::Block> blocks;
    for (int first = 0; first < mesh.faceCount(); first += blockFaces)
        blocks.push_back(blockOf(shaded, first, std::min(blockFaces, mesh.faceCount() - first), number));
    return blocks;
}

} // namespace

SharedDrawnMesh drawnMesh(const SharedMesh& mesh) {
    return completed(sketchedMesh(mesh));
}

SharedDrawnMesh sketchedMesh(const SharedMesh& mesh) {
    if (!mesh)
        return nullptr;
    auto drawn = std::make_shared<DrawnMesh>();
    drawn->mesh = mesh;
    drawn->box = boundingBox(*mesh);
    if (mesh->faceCount() > largeFaces)
        drawn->standIn = drawnMesh(std::make_shared<const IndexedMesh>(cluster(*mesh, standInFaces)));
    else
        drawn->blocks = blocksOf(*mesh);
    return drawn;
}

SharedDrawnMesh completed(const SharedDrawnMesh& sketch) {
    if (!sketch || !sketch->sketched())
        return sketch;
    auto drawn = std::make_shared<DrawnMesh>(*sketch);
    drawn->blocks = blocksOf(*sketch->mesh);
    drawn->standInFaces = nearestFaces(*sketch->mesh, *sketch->standIn->mesh);
    return drawn;
}

} // namespace moldwright::scene
