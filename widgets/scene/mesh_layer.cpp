// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/mesh_layer.h"

#include "scene/cut_layer.h"

#include <vtkCellData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>

namespace moldwright::scene {

namespace {

void prepareLook(vtkPolyDataMapper* mapper, vtkActor* actor) {
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUseCellData();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    actor->SetMapper(mapper);
    vtkProperty* look = actor->GetProperty();
    look->SetInterpolationToPhong();
    look->SetAmbient(0.22);
    look->SetDiffuse(0.88);
    look->SetSpecular(0.10);
    look->SetSpecularPower(24);
    look->SetEdgeColor(0.25, 0.28, 0.32);
}

vtkNew<vtkUnsignedCharArray> colourArray(std::span<const Rgb> colours) {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
    static_assert(sizeof(Rgb) == 3);
    std::memcpy(array->GetPointer(0), colours.data(), colours.size_bytes());
    return array;
}

} // namespace

MeshLayer::~MeshLayer() {
    remove(m_blocks);
    remove(m_standIn);
}

void MeshLayer::remove(Pieces& pieces) {
    for (const auto& piece : pieces)
        m_renderer->RemoveActor(piece->actor);
    pieces.clear();
}

MeshLayer::Pieces MeshLayer::piecesOf(const DrawnMesh& mesh) {
    Pieces pieces;
    for (const DrawnMesh::Block& block : mesh.blocks) {
        auto piece = std::make_unique<Piece>();
        piece->firstFace = block.firstFace;
        piece->faceCount = block.faceCount;
        piece->surface->SetPoints(block.points);
        piece->surface->GetPointData()->SetNormals(block.normals);
        piece->surface->SetPolys(block.faces);
        piece->mapper->SetInputData(piece->surface);
        prepareLook(piece->mapper, piece->actor);
        m_renderer->AddActor(piece->actor);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

void MeshLayer::setMesh(const SharedDrawnMesh& mesh, Rgb colour) {
    remove(m_blocks);
    remove(m_standIn);
    m_mesh = mesh;
    m_only.reset();
    if (!mesh)
        return;
    m_blocks = piecesOf(*mesh);
    setFaceColours(std::vector<Rgb>(mesh->mesh->F.rows(), colour));
    if (mesh->standIn) {
        m_standIn = piecesOf(*mesh->standIn);
        setStandInColours(std::vector<Rgb>(mesh->standIn->mesh->F.rows(), colour));
    }
    applyLook();
    applyVisibility();
}

void MeshLayer::paint(Pieces& pieces, std::span<const Rgb> colours) {
    for (const auto& piece : pieces) {
        const auto own = colours.subspan(piece->firstFace, piece->faceCount);
        vtkCellData* data = piece->surface->GetCellData();
        // Equal colours are not sent to the graphics card again.
        if (const auto* old = vtkUnsignedCharArray::SafeDownCast(data->GetScalars());
            old && std::memcmp(const_cast<vtkUnsignedCharArray*>(old)->GetPointer(0), own.data(),
                               own.size_bytes()) == 0)
            continue;
        data->SetScalars(colourArray(own));
        piece->surface->Modified();
    }
}

void MeshLayer::setFaceColours(std::span<const Rgb> colours) {
    if (m_mesh && static_cast<Eigen::Index>(colours.size()) == m_mesh->mesh->F.rows())
        paint(m_blocks, colours);
}

void MeshLayer::setStandInColours(std::span<const Rgb> colours) {
    if (m_mesh && m_mesh->standIn &&
        static_cast<Eigen::Index>(colours.size()) == m_mesh->standIn->mesh->F.rows())
        paint(m_standIn, colours);
}

void MeshLayer::setVisible(bool visible) {
    m_visible = visible;
    applyVisibility();
}

void MeshLayer::setOpacity(double opacity) {
    m_opacity = opacity;
    applyLook();
}

void MeshLayer::setEdges(bool shown) {
    m_edges = shown;
    applyLook();
}

void MeshLayer::setTwoSided(bool twoSided) {
    if (twoSided == m_twoSided)
        return;
    m_twoSided = twoSided;
    applyLook();
}

void MeshLayer::setPose(const Eigen::Isometry3d& pose) {
    m_pose = pose;
    applyLook();
}

void MeshLayer::setCut(const std::optional<PartingPlane>& cut) {
    m_cut = cut;
    applyLook();
}

void MeshLayer::applyLook() {
    const vtkNew<vtkMatrix4x4> pose;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            pose->SetElement(row, column, m_pose.matrix()(row, column));
    for (const Pieces* pieces : {&m_blocks, &m_standIn})
        for (const auto& piece : *pieces) {
            vtkProperty* look = piece->actor->GetProperty();
            look->SetOpacity(m_opacity);
            // The backs of a closed surface are never seen, and cost as much.
            look->SetBackfaceCulling(m_opacity == 1 && !m_twoSided);
            look->SetEdgeVisibility(m_edges);
            piece->actor->SetUserMatrix(pose);
            cutMapper(piece->mapper, m_cut);
        }
}

bool MeshLayer::standsIn() const {
    return !m_standIn.empty() && (m_standInUsed || m_blocks.empty());
}

void MeshLayer::useStandIn(bool use) {
    m_standInUsed = use;
    applyVisibility();
}

int MeshLayer::blockCount() const {
    return static_cast<int>(!m_visible ? 0 : standsIn() ? m_standIn.size() : m_blocks.size());
}

void MeshLayer::drawOnly(std::optional<int> block) {
    m_only = block;
    applyVisibility();
}

void MeshLayer::applyVisibility() {
    const auto show = [&](const Pieces& pieces, bool drawn) {
        for (int i = 0; i < static_cast<int>(pieces.size()); ++i)
            pieces[i]->actor->SetVisibility(m_visible && drawn && m_only.value_or(i) == i);
    };
    show(m_blocks, !standsIn());
    show(m_standIn, standsIn());
}

} // namespace moldwright::scene
