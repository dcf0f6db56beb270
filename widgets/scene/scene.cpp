// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/scene.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace moldwright::scene {

namespace {

constexpr double arrowShare = 0.17; ///< of the part's diagonal
constexpr double arrowGap = 0.03;

/// The colour of a solid where it is cut open.
Rgb darker(Rgb colour) {
    const auto channel = [](std::uint8_t value) { return static_cast<std::uint8_t>(value * 4 / 5); };
    return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

/// Three lights that turn with the camera: a soft key from above left, fill from the right, a little rim.
void addLights(vtkRenderer* renderer) {
    struct Lamp {
        double x, y, z, strength;
    };
    renderer->RemoveAllLights();
    renderer->AutomaticLightCreationOff();
    for (const Lamp lamp :
         {Lamp{-0.5, 0.8, 1.0, 0.82}, Lamp{0.9, 0.2, 0.9, 0.36}, Lamp{0, -0.9, 0.4, 0.18}}) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(lamp.x, lamp.y, lamp.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(lamp.strength);
        renderer->AddLight(light);
    }
}

} // namespace

Scene::Scene()
    : m_surface(m_back), m_mold(m_back), m_sections{CutLayer(m_front), CutLayer(m_front), CutLayer(m_front)} {
    m_back->SetLayer(0);
    m_back->GradientBackgroundOn();
    m_front->SetLayer(1);
    m_front->PreserveDepthBufferOn();
    m_front->SetActiveCamera(m_back->GetActiveCamera());
    setSmoothEdges(true);
    for (vtkActor* actor : {m_plane.sheet(), m_plane.outline(), m_plane.crease(), m_plane.partingLine(),
                            m_arrow1.actor(), m_arrow2.actor()})
        m_front->AddActor(actor);
    for (const ConeLayer& cone : m_cones) {
        m_front->AddActor(cone.collar());
        m_front->AddActor(cone.rim());
    }
    m_front->AddActor(m_filling.actor());
    m_front->AddActor(m_faults.actor());
    m_front->AddViewProp(m_path.actor());
    m_pins.addTo(m_front);
    m_features.addTo(m_front);
    m_brush.addTo(m_front);
    m_overlay.addTo(m_front);
    addLights(m_back);
    addLights(m_front);
    setLook(m_colours, m_scale);
    updateVisibility();
}

Scene::~Scene() = default;

void Scene::showIn(vtkRenderWindow* window, bool withCube) {
    window->SetMultiSamples(0);
    window->SetNumberOfLayers(3);
    window->AddRenderer(m_back);
    window->AddRenderer(m_front);
    if (withCube)
        window->AddRenderer(m_cube.renderer());
}

void Scene::setLook(const SceneColours& colours, double scale) {
    m_colours = colours;
    m_scale = scale;
    m_back->SetBackground(colours.viewBottom.unit().data());
    m_back->SetBackground2(colours.viewTop.unit().data());
    m_plane.setColours(colours, scale);
    const std::array<Rgb, 3> solids = {colours.part, colours.half1, colours.half2};
    for (std::size_t i = 0; i < solids.size(); ++i)
        m_sections[i].setLook(darker(solids[i]), colours.partingLine, 1.4 * scale);
    m_arrow1.setColour(colours.side1);
    m_arrow2.setColour(colours.side2);
    m_cones[0].setLook(colours.side1, scale);
    m_cones[1].setLook(colours.side2, scale);
    m_path.setLook(colours.accent, 1.8 * scale);
    m_pins.setLook(colours, scale);
    m_features.setLook(colours, scale);
    m_brush.setScale(scale);
    m_filling.setColour(colours.accent);
    m_faults.setLook(colours.undercut, 3 * scale);
    m_cube.setLook(colours, m_words, scale);
    m_overlay.setColours(colours, scale);
    placePartingLine(); // its band has the theme's colour
}

void Scene::setCubeWords(const CubeWords& words) {
    m_words = words;
    m_cube.setLook(m_colours, words, m_scale);
}

Eigen::AlignedBox3d Scene::box() const {
    return m_surface.mesh() ? m_surface.mesh()->box : Eigen::AlignedBox3d();
}

std::array<MeshLayer*, 3> Scene::surfaces() {
    return {&m_surface, &m_mold.half(1), &m_mold.half(2)};
}

void Scene::setSurface(const SharedDrawnMesh& mesh, std::span<const Rgb> faceColours) {
    m_surface.setMesh(mesh, m_colours.part);
    m_faceColours.assign(mesh ? mesh->mesh->F.rows() : 0, m_colours.part);
    setFaceColours(faceColours);
    placePlane();
    placeSections();
    updateVisibility();
}

void Scene::setFaceColours(std::span<const Rgb> faceColours) {
    if (!faceColours.empty())
        m_faceColours.assign(faceColours.begin(), faceColours.end());
    paintSurface();
}

void Scene::paintSurface() {
    m_surface.setFaceColours(m_contacts.painted(m_faceColours, m_mold.ways(), m_colours.undercut));
}

void Scene::useStandIns(bool use) {
    if (use == m_standInsUsed)
        return;
    m_standInsUsed = use;
    for (MeshLayer* layer : surfaces())
        layer->useStandIn(use);
    placePartingLine();
}

void Scene::setSeeThrough(bool seeThrough) {
    m_seeThrough = seeThrough;
    m_surface.setOpacity(seeThrough ? 0.35 : 1);
}

void Scene::setSmoothEdges(bool smooth) {
    m_front->SetUseFXAA(smooth); // goes over the whole picture, so it comes last
}

void Scene::setSurfaceVisible(bool visible) {
    m_surfaceVisible = visible;
    updateVisibility();
}

void Scene::setState(const std::optional<MoldState>& state) {
    if (state == m_state)
        return;
    m_state = state;
    placePlane();
    updateVisibility();
}

void Scene::setPlaneVisible(bool visible) {
    m_planeVisible = visible;
    updateVisibility();
}

void Scene::setDirectionsVisible(bool visible) {
    m_directionsVisible = visible;
    updateVisibility();
}

void Scene::setGrips(bool shown, std::optional<Grip> held) {
    m_gripsShown = shown;
    m_heldGrip = held;
    updateVisibility();
}

void Scene::placePlane() {
    if (!m_state)
        return;
    m_rectangle = planeRectangle(m_state->plane, m_surface.mesh() ? m_surface.mesh()->bounds() : Points());
    m_plane.setPlane(m_rectangle);
    placePartingLine();
    placeArrows();
}

void Scene::placePartingLine() {
    const SharedDrawnMesh& mesh = m_surface.mesh();
    if (!mesh || !m_state)
        m_plane.clearPartingLine();
    else
        m_plane.setPartingLine(m_surface.standsIn() ? *mesh->standIn->mesh : *mesh->mesh, *m_state);
}

void Scene::placeArrows() {
    const SharedDrawnMesh& mesh = m_surface.mesh();
    const double size = mesh ? mesh->box.sizes().norm() : 1;
    const Eigen::Vector3d middle = mesh ? mesh->box.center() : Eigen::Vector3d::Zero().eval();
    for (const int side : {1, 2}) {
        const Eigen::Vector3d& d = m_state->directions.of(side);
        // Just outside the part, however it lies.
        const double reach = mesh ? (mesh->bounds() * d).maxCoeff() - middle.dot(d) : 0;
        m_reach[side - 1] = reach + arrowGap * size;
        const Eigen::Vector3d tail = middle + m_reach[side - 1] * d;
        (side == 1 ? m_arrow1 : m_arrow2).set(tail, d, arrowShare * size);
        m_arrowTips[side - 1] = tail + arrowShare * size * d;
    }
}

void Scene::updateVisibility() {
    const bool plane = m_state && m_planeVisible && m_surface.mesh();
    const bool arrows = m_state && m_directionsVisible && m_surface.mesh();
    const bool surface = m_surfaceVisible && !m_mold.turnedOver();
    m_surface.setVisible(surface);
    m_sections[0].setVisible(surface);
    m_plane.sheet()->SetVisibility(plane);
    m_plane.outline()->SetVisibility(plane);
    m_plane.crease()->SetVisibility(m_state && m_surface.mesh() && surface);
    m_plane.partingLine()->SetVisibility(m_state && m_surface.mesh() && surface);
    m_arrow1.actor()->SetVisibility(arrows);
    m_arrow2.actor()->SetVisibility(arrows);
    showGrips();
    showCones();
}

void Scene::setDirectionLimits(const DirectionLimits& limits, bool shown) {
    m_limits = limits;
    m_conesShown = shown;
    showCones();
}

void Scene::showCones() {
    for (const int side : {1, 2}) {
        const bool held = m_heldGrip == (side == 1 ? Grip::Direction1 : Grip::Direction2);
        const bool wanted =
            m_state && m_directionsVisible && m_gripsShown && m_surface.mesh() && (m_conesShown || held);
        const auto cap = wanted ? capWithin(m_limits, m_state->plane.normal, side) : std::nullopt;
        const bool shown = cap && cap->radiusDegrees > 0;
        const std::size_t i = side - 1;
        m_cones[i].collar()->SetVisibility(shown);
        m_cones[i].rim()->SetVisibility(shown);
        if (shown)
            m_cones[i].set(*cap, middle(), m_reach[i],
                           m_reach[i] + arrowShare * m_surface.mesh()->box.sizes().norm());
    }
}

std::vector<GripPlace> Scene::grips() const {
    std::vector<GripPlace> grips;
    if (!m_gripsShown || !m_state || !m_surface.mesh())
        return grips;
    if (m_planeVisible)
        for (const Grip grip : planeGrips)
            grips.push_back({grip, gripPlace(m_rectangle, grip)});
    if (m_directionsVisible) {
        grips.push_back({Grip::Direction1, arrowTip(1)});
        grips.push_back({Grip::Direction2, arrowTip(2)});
    }
    return grips;
}

void Scene::showGrips() {
    std::vector<Eigen::Vector3d> places;
    int held = -1;
    for (const GripPlace& grip : grips()) {
        if (m_heldGrip == grip.grip)
            held = static_cast<int>(places.size());
        places.push_back(grip.place);
    }
    m_overlay.setGrips(places, held);
}

void Scene::setHalves(const SharedDrawnMesh& half1, const SharedDrawnMesh& half2,
                      const Eigen::Isometry3d& moldToPart, const Directions& directions) {
    setContacts({});
    m_mold.set({half1, half2}, moldToPart, directions, {m_colours.half1, m_colours.half2});
    placeSections();
    updateVisibility();
}

void Scene::setOpening(const Opening& opening) {
    m_mold.open(opening, m_surface.mesh() ? m_surface.mesh()->box.sizes().norm() : 1);
    if (m_contacts.any())
        paintSurface();
    placeSections();
    updateVisibility();
}

void Scene::setCut(const std::optional<PartingPlane>& cut) {
    if (cut == m_cut)
        return;
    m_cut = cut;
    for (MeshLayer* layer : surfaces())
        layer->setCut(cut);
    m_plane.setCut(cut);
    placeSections();
}

void Scene::placeSections() {
    const auto layers = surfaces();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const SharedDrawnMesh& solid = layers[i]->mesh();
        m_sections[i].set(solid ? solid->mesh : nullptr, layers[i]->pose(), m_cut);
    }
}

std::vector<Eigen::Vector3d> Scene::outline() const {
    std::vector<Eigen::Vector3d> points;
    if (m_surfaceVisible && !m_mold.turnedOver())
        points = cornersOf(box());
    std::ranges::copy(m_mold.corners(), std::back_inserter(points));
    if (m_state && m_directionsVisible && m_surface.mesh())
        for (const int side : {1, 2})
            points.push_back(arrowTip(side));
    for (const Outline& line : m_features.plan().lines)
        points.insert(points.end(), line.begin(), line.end());
    return points;
}

std::optional<Spot> Scene::shapeSpot(const Camera& camera, ViewSize view) const {
    Eigen::AlignedBox2d seen;
    for (const Eigen::Vector3d& corner : m_mold.corners())
        seen.extend(camera.project(corner, view).head<2>());
    if (seen.isEmpty() && m_surface.mesh() && m_surfaceVisible)
        for (const auto& point : m_surface.mesh()->bounds().rowwise())
            seen.extend(camera.project(point.transpose(), view).head<2>());
    if (seen.isEmpty())
        return std::nullopt;
    return Spot{seen.min().x(), view.height - seen.max().y(), seen.sizes().x(), seen.sizes().y()};
}

void Scene::arrange(const Camera& camera, ViewSize view, bool still) {
    drawSlice(std::nullopt);
    vtkCamera* eye = m_back->GetActiveCamera();
    eye->SetParallelProjection(!camera.perspective);
    eye->SetViewAngle(camera.viewAngle);
    eye->SetParallelScale(camera.halfHeight());
    // A parallel camera may stand anywhere along its line of sight: far back, so that nothing is cut off.
    const double back = camera.perspective ? 0 : 50 * camera.distance;
    eye->SetPosition(Eigen::Vector3d(camera.position() + back * camera.backwards()).data());
    eye->SetFocalPoint(camera.focus.data());
    eye->SetViewUp(camera.up().data());
    // Both layers share depths: what is near and far is that of all.
    vtkBoundingBox all;
    for (vtkRenderer* layer : {m_back.Get(), m_front.Get()})
        if (const double* bounds = layer->ComputeVisiblePropBounds(); vtkMath::AreBoundsInitialized(bounds))
            all.AddBounds(bounds);
    if (all.IsValid()) {
        std::array<double, 6> bounds{};
        all.GetBounds(bounds.data());
        m_back->ResetCameraClippingRange(bounds.data());
    }
    m_cube.arrange(camera, view);
    m_pins.arrange(camera, view);
    m_features.arrange(camera, view);
    m_overlay.arrange(camera, view, still ? shapeSpot(camera, view) : std::nullopt);
}

int Scene::sliceCount() const {
    return m_surface.blockCount() + m_mold.half(1).blockCount() + m_mold.half(2).blockCount() + 1;
}

void Scene::drawSlice(std::optional<int> slice) {
    const bool last = !slice || *slice == sliceCount() - 1;
    m_front->SetDraw(last);
    m_cube.renderer()->SetDraw(last);
    m_back->SetErase(slice.value_or(0) == 0);
    int block = slice.value_or(0);
    for (MeshLayer* layer : surfaces()) {
        const int count = layer->blockCount();
        const bool own = block >= 0 && block < count;
        layer->drawOnly(slice ? std::optional(own ? block : -1) : std::nullopt);
        block -= count;
    }
}

} // namespace moldwright::scene
