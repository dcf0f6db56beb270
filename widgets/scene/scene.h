// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "scene/arrow_layer.h"
#include "scene/brush_layer.h"
#include "scene/camera.h"
#include "scene/colours.h"
#include "scene/cone_layer.h"
#include "scene/contact_paint.h"
#include "scene/cut_layer.h"
#include "scene/drawn_mesh.h"
#include "scene/fault_layer.h"
#include "scene/feature_layer.h"
#include "scene/filling_layer.h"
#include "scene/grips.h"
#include "scene/mesh_layer.h"
#include "scene/opened_mold.h"
#include "scene/orientation_cube.h"
#include "scene/overlay.h"
#include "scene/path_layer.h"
#include "scene/pin_layer.h"
#include "scene/plane_handle.h"
#include "scene/plane_layer.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

class vtkRenderWindow;

namespace moldwright::scene {

/// Everything one view shows: the surface with its colours, the parting plane, both directions, the mold
/// halves, legend, chips and cube. It draws into any VTK window; it knows neither Qt nor files nor threads.
/// Lengths in mm in the part's frame, pixels are device pixels. The surfaces lie in a layer of their own
/// behind all else, so that a picture can be drawn in slices: surfaces block by block, then the rest.
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
    void setSurface(const SharedDrawnMesh& mesh, std::span<const Rgb> faceColours);
    void setFaceColours(std::span<const Rgb> faceColours);
    void setStandInColours(std::span<const Rgb> faceColours) { m_surface.setStandInColours(faceColours); }
    /// Without it edges are stepped, and a picture takes less than half the time.
    void setSmoothEdges(bool smooth);
    /// Draws the coarse stand-ins of large surfaces instead of these.
    void useStandIns(bool use);
    [[nodiscard]] bool standInsUsed() const { return m_standInsUsed; }
    void setSurfaceVisible(bool visible);
    void setEdges(bool shown) { m_surface.setEdges(shown); }
    /// Draws the surface from behind too: it may be open.
    void setTwoSided(bool twoSided) { m_surface.setTwoSided(twoSided); }
    /// Edges of the surface that are at fault; none for a sound one. mm.
    void setFaults(const std::vector<FaultLayer::Edge>& edges) { m_faults.set(edges); }
    [[nodiscard]] const FaultLayer& faults() const { return m_faults; }
    void setSeeThrough(bool seeThrough);
    [[nodiscard]] bool seeThrough() const { return m_seeThrough; }

    /// Plane and directions; none hides them.
    void setState(const std::optional<MoldState>& state);
    void setPlaneVisible(bool visible);
    void setDirectionsVisible(bool visible);
    /// Where directions may point; shown as a cone about each arrow while `shown`, else about one that is
    /// held.
    void setDirectionLimits(const DirectionLimits& limits, bool shown);
    [[nodiscard]] const DirectionLimits& directionLimits() const { return m_limits; }
    [[nodiscard]] const SharpestCrease& sharpestCrease() const { return m_plane.sharpestCrease(); }
    /// Grips of what is visible, to be taken hold of; `held` is the one under the pointer.
    void setGrips(bool shown, std::optional<Grip> held);
    [[nodiscard]] std::vector<GripPlace> grips() const;

    /// The mold's halves in the mold's frame; null meshes for none.
    void setHalves(const SharedDrawnMesh& half1, const SharedDrawnMesh& half2,
                   const Eigen::Isometry3d& moldToPart, const Directions& directions);
    /// Half 1 or 2 as it was set.
    [[nodiscard]] const SharedDrawnMesh& half(int side) const { return m_mold.half(side).mesh(); }
    /// One colour per face of half 1 or 2, and of its stand-in.
    void setHalfColours(int side, std::span<const Rgb> faces, std::span<const Rgb> standIn) {
        MeshLayer& layer = m_mold.half(side);
        layer.setFaceColours(faces);
        layer.setStandInColours(standIn);
    }
    /// What these halves meet of the surface while they leave: its faces are red where and while they do.
    void setContacts(const std::array<ContactWays, 2>& contacts) {
        m_contacts.setContacts(contacts);
        paintSurface();
    }
    /// While half 1 is turned over, the surface is out of sight.
    void setOpening(const Opening& opening);
    /// Where a place of half 1 or 2 in the mold's frame is seen, opened as it is, mm.
    [[nodiscard]] Eigen::Vector3d placeOnHalf(int side, const Eigen::Vector3d& place) const {
        return m_mold.half(side).pose() * place;
    }
    /// How many faces a half meets, opened as it is.
    [[nodiscard]] int facesMet() const { return m_contacts.facesMet(); }

    /// Cuts away what lies before the plane (n·x > o) of all surfaces, and fills the sections; nothing: shows
    /// all.
    void setCut(const std::optional<PartingPlane>& cut);
    [[nodiscard]] const std::optional<PartingPlane>& cut() const { return m_cut; }

    void setLegend(const PanelContent& content) { m_overlay.setLegend(content); }
    void setStateChip(const PanelContent& content) { m_overlay.setState(content); }
    /// Lines from place to place, as measured.
    void setPath(const std::vector<Eigen::Vector3d>& places) { m_path.set(places); }
    /// The line under the hand that paints.
    void setBrush(const std::vector<Eigen::Vector3d>& places) { m_brush.set(places); }
    [[nodiscard]] const BrushLayer& brush() const { return m_brush; }
    /// Walls that filling would make, drawn as glass; null for none.
    void setFilling(const SharedMesh& walls) { m_filling.set(walls); }
    [[nodiscard]] const SharedMesh& filling() const { return m_filling.walls(); }
    void setPins(const ShownPins& pins) { m_pins.set(pins); }
    [[nodiscard]] const PinLayer& pins() const { return m_pins; }
    /// The mold's features on the parting plane.
    void setPlan(const ShownPlan& plan) { m_features.set(plan); }
    [[nodiscard]] const FeatureLayer& features() const { return m_features; }
    void setChips(const std::vector<Chip>& chips) { m_overlay.setChips(chips); }
    [[nodiscard]] const Overlay& overlay() const { return m_overlay; }

    /// Places camera, lights and all that is drawn flat. Call before rendering. What is drawn flat gives way
    /// to the shape where that holds `still`.
    void arrange(const Camera& camera, ViewSize view, bool still = false);

    /// Where the mold is seen, or else the surface; none without either. Pixels.
    [[nodiscard]] std::optional<Spot> shapeSpot(const Camera& camera, ViewSize view) const;

    /// In how many slices the picture can be drawn: one for each block of its surfaces, and one for the rest.
    [[nodiscard]] int sliceCount() const;
    /// Draws only this slice, over those before it; nothing: all at once. Call after arrange().
    void drawSlice(std::optional<int> slice);

    /// Points that bound what is visible, arrows included, mm.
    [[nodiscard]] std::vector<Eigen::Vector3d> outline() const;
    [[nodiscard]] const SharedDrawnMesh& surface() const { return m_surface.mesh(); }
    [[nodiscard]] const std::optional<MoldState>& state() const { return m_state; }
    [[nodiscard]] const SceneColours& colours() const { return m_colours; }
    [[nodiscard]] const PlaneRectangle& rectangle() const { return m_rectangle; }
    [[nodiscard]] const OrientationCube& cube() const { return m_cube; }

    /// The middle of the part, which arrows start from and turn about, mm.
    [[nodiscard]] Eigen::Vector3d middle() const { return box().center(); }

    /// Where the arrow of direction 1 or 2 ends, mm: the place for its chip.
    [[nodiscard]] Eigen::Vector3d arrowTip(int side) const { return m_arrowTips[side - 1]; }

private:
    [[nodiscard]] Eigen::AlignedBox3d box() const;
    [[nodiscard]] std::array<MeshLayer*, 3> surfaces();
    void placePlane();
    void placePartingLine();
    void placeArrows();
    void showCones();
    void placeSections();
    void updateVisibility();
    void showGrips();
    void paintSurface();

    vtkNew<vtkRenderer> m_back;  ///< background and surfaces
    vtkNew<vtkRenderer> m_front; ///< all else, hidden where surfaces are nearer
    SceneColours m_colours = lightColours();
    double m_scale = 1;
    CubeWords m_words = {"Front", "Back", "Left", "Right", "Top", "Bottom"};
    MeshLayer m_surface;
    std::vector<Rgb> m_faceColours; ///< of the surface, as wanted
    OpenedMold m_mold;
    ContactPaint m_contacts;
    std::array<CutLayer, 3> m_sections; ///< of surface, half 1, half 2
    std::optional<PartingPlane> m_cut;
    bool m_standInsUsed = false;
    bool m_seeThrough = false;
    PlaneLayer m_plane;
    PlaneRectangle m_rectangle;
    ArrowLayer m_arrow1;
    ArrowLayer m_arrow2;
    std::array<ConeLayer, 2> m_cones;
    std::array<double, 2> m_reach{}; ///< from the middle to where each arrow begins, mm
    DirectionLimits m_limits;
    bool m_conesShown = false;
    std::array<Eigen::Vector3d, 2> m_arrowTips{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    PathLayer m_path;
    BrushLayer m_brush;
    PinLayer m_pins;
    FillingLayer m_filling;
    FaultLayer m_faults;
    FeatureLayer m_features;
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
