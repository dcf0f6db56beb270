// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "scene/arrow_layer.h"
#include "scene/camera.h"
#include "scene/colours.h"
#include "scene/grips.h"
#include "scene/half_layer.h"
#include "scene/mesh_layer.h"
#include "scene/orientation_cube.h"
#include "scene/overlay.h"
#include "scene/plane_handle.h"
#include "scene/plane_layer.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <optional>
#include <span>
#include <vector>

class vtkRenderWindow;

namespace moldwright::scene {

/// Everything one view shows: the surface with its colours, the parting plane, both directions, the mold
/// halves, legend, chips and cube. It draws into any VTK window; it knows neither Qt nor files nor threads.
/// Lengths in mm in the part's frame, pixels are device pixels.
class Scene {
public:
    Scene();
    ~Scene();

    /// Puts this scene into a window, with or without the cube (pictures for paper need none).
    void showIn(vtkRenderWindow* window, bool withCube = true);

    /// Colours, and how much finer than 96 dpi the screen is.
    void setLook(const SceneColours& colours, double scale);
    void setCubeWords(const CubeWords& words);

    /// The surface in view; null for none. `faceColours` may be empty: all in the part's colour.
    void setSurface(const SharedMesh& mesh, std::span<const Rgb> faceColours);
    void setFaceColours(std::span<const Rgb> faceColours);
    /// A coarser mesh that stands in for the surface while something moves; null for none.
    void setStandIn(const SharedMesh& coarse, std::span<const Rgb> faceColours);
    [[nodiscard]] bool hasStandIn() const { return m_standIn.mesh() != nullptr; }
    void useStandIn(bool use);
    void setSurfaceVisible(bool visible);
    void setEdges(bool shown) { m_surface.setEdges(shown); }
    void setSeeThrough(bool seeThrough);

    /// Plane and directions; none hides them.
    void setState(const std::optional<MoldState>& state);
    void setPlaneVisible(bool visible);
    void setDirectionsVisible(bool visible);
    /// Grips of what is visible, to be taken hold of; `held` is the one under the pointer.
    void setGrips(bool shown, std::optional<Grip> held);
    [[nodiscard]] std::vector<GripPlace> grips() const;

    /// The mold's halves in the mold's frame; null meshes for none.
    void setHalves(const SharedMesh& half1, const SharedMesh& half2, const Eigen::Isometry3d& moldToPart,
                   const Directions& directions);
    /// 0 closed … 1 open wide.
    void setOpening(double opening);

    void setLegend(const PanelContent& content) { m_overlay.setLegend(content); }
    void setStateChip(const PanelContent& content) { m_overlay.setState(content); }
    void setChips(const std::vector<Chip>& chips) { m_overlay.setChips(chips); }

    /// Places camera, lights and all that is drawn flat. Call before rendering.
    void arrange(const Camera& camera, ViewSize view);

    /// Points that bound what is visible, arrows included, mm.
    [[nodiscard]] std::vector<Eigen::Vector3d> outline() const;
    [[nodiscard]] const SharedMesh& surface() const { return m_surface.mesh(); }
    [[nodiscard]] const std::optional<MoldState>& state() const { return m_state; }
    [[nodiscard]] const SceneColours& colours() const { return m_colours; }
    [[nodiscard]] PlaneRectangle rectangle() const;
    [[nodiscard]] const OrientationCube& cube() const { return m_cube; }

    /// The middle of the part, which arrows start from and turn about, mm.
    [[nodiscard]] Eigen::Vector3d middle() const { return m_surfaceBox.center(); }

    /// Where the arrow of direction 1 or 2 ends, mm: the place for its chip.
    [[nodiscard]] Eigen::Vector3d arrowTip(int side) const;

private:
    void placePlane();
    void placeArrows();
    void updateVisibility();
    void showGrips();
    [[nodiscard]] Eigen::Vector3d arrowTail(int side) const;

    vtkNew<vtkRenderer> m_renderer;
    SceneColours m_colours = lightColours();
    double m_scale = 1;
    CubeWords m_words = {"Front", "Back", "Left", "Right", "Top", "Bottom"};
    MeshLayer m_surface;
    MeshLayer m_standIn;
    bool m_standInUsed = false;
    Eigen::AlignedBox3d m_surfaceBox;
    PlaneLayer m_plane;
    ArrowLayer m_arrow1;
    ArrowLayer m_arrow2;
    HalfLayer m_half1;
    HalfLayer m_half2;
    OrientationCube m_cube;
    Overlay m_overlay;
    std::optional<MoldState> m_state;
    bool m_surfaceVisible = true;
    bool m_planeVisible = true;
    bool m_directionsVisible = true;
    bool m_gripsShown = false;
    std::optional<Grip> m_heldGrip;
};

} // namespace moldwright::scene
