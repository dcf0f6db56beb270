// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "scene/colours.h"
#include "scene/drawn_mesh.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace moldwright::scene {

/// One surface in the view: smooth shading with creases, one colour per face. A large one can be drawn block
/// by block, or by its stand-in.
class MeshLayer {
public:
    explicit MeshLayer(vtkRenderer* renderer) : m_renderer(renderer) {}
    ~MeshLayer();
    MeshLayer(const MeshLayer&) = delete;
    MeshLayer& operator=(const MeshLayer&) = delete;

    /// Shows another mesh in one colour; null hides.
    void setMesh(const SharedDrawnMesh& mesh, Rgb colour);

    /// One colour per face of the mesh shown, or of its stand-in; other numbers of colours are passed over.
    void setFaceColours(std::span<const Rgb> colours);
    void setStandInColours(std::span<const Rgb> colours);

    void setVisible(bool visible);
    /// See-through from 0 to 1; 1 is solid.
    void setOpacity(double opacity);
    void setEdges(bool shown);
    /// Draws its back too, for a surface that is not closed.
    void setTwoSided(bool twoSided);
    void setPose(const Eigen::Isometry3d& pose);
    [[nodiscard]] const Eigen::Isometry3d& pose() const { return m_pose; }
    /// Hides what lies before the plane (n·x > o), in the scene's frame; nothing: shows all.
    void setCut(const std::optional<PartingPlane>& cut);

    /// Draws the stand-in, where there is one; a mesh without blocks is always drawn by it.
    void useStandIn(bool use);
    [[nodiscard]] bool standsIn() const;

    /// How many blocks are drawn now, and to draw only one of them (−1: none of them); nothing: all.
    [[nodiscard]] int blockCount() const;
    void drawOnly(std::optional<int> block);

    [[nodiscard]] const SharedDrawnMesh& mesh() const { return m_mesh; }

private:
    struct Piece {
        vtkNew<vtkPolyData> surface;
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
        int firstFace = 0;
        int faceCount = 0;
    };
    using Pieces = std::vector<std::unique_ptr<Piece>>;

    [[nodiscard]] Pieces piecesOf(const DrawnMesh& mesh);
    void remove(Pieces& pieces);
    static void paint(Pieces& pieces, std::span<const Rgb> colours);
    void applyLook();
    void applyVisibility();

    vtkRenderer* m_renderer;
    SharedDrawnMesh m_mesh;
    Pieces m_blocks;
    Pieces m_standIn;
    bool m_visible = true;
    bool m_standInUsed = false;
    std::optional<int> m_only;
    double m_opacity = 1;
    bool m_edges = false;
    bool m_twoSided = false;
    Eigen::Isometry3d m_pose = Eigen::Isometry3d::Identity();
    std::optional<PartingPlane> m_cut;
};

} // namespace moldwright::scene
