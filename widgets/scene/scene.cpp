// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/scene.h"

#include "mesh/measures.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace moldwright::scene {

namespace {

constexpr double arrowShare = 0.17; ///< of the part's diagonal
constexpr double arrowGap = 0.03;
constexpr double openShare = 0.5; ///< of the part's diagonal, each half

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

Scene::Scene() {
    m_renderer->SetLayer(0);
    m_renderer->GradientBackgroundOn();
    m_renderer->UseFXAAOn();
    m_renderer->AddActor(m_surface.actor());
    m_renderer->AddActor(m_standIn.actor());
    m_renderer->AddActor(m_half1.actor());
    m_renderer->AddActor(m_half2.actor());
    m_renderer->AddActor(m_plane.sheet());
    m_renderer->AddActor(m_plane.outline());
    m_renderer->AddActor(m_plane.partingLine());
    m_renderer->AddActor(m_arrow1.actor());
    m_renderer->AddActor(m_arrow2.actor());
    m_overlay.addTo(m_renderer);
    addLights(m_renderer);
    setLook(m_colours, m_scale);
    updateVisibility();
}

Scene::~Scene() = default;

void Scene::showIn(vtkRenderWindow* window, bool withCube) {
    window->SetMultiSamples(0);
    window->SetNumberOfLayers(2);
    window->AddRenderer(m_renderer);
    if (withCube)
        window->AddRenderer(m_cube.renderer());
}

void Scene::setLook(const SceneColours& colours, double scale) {
    m_colours = colours;
    m_scale = scale;
    m_renderer->SetBackground(colours.viewBottom.unit().data());
    m_renderer->SetBackground2(colours.viewTop.unit().data());
    m_plane.setColours(colours, scale);
    m_arrow1.setColour(colours.side1);
    m_arrow2.setColour(colours.side2);
    m_cube.setLook(colours, m_words, scale);
    m_overlay.setColours(colours, scale);
}

void Scene::setCubeWords(const CubeWords& words) {
    m_words = words;
    m_cube.setLook(m_colours, words, m_scale);
}

void Scene::setSurface(const SharedMesh& mesh, std::span<const Rgb> faceColours) {
    m_surface.setMesh(mesh, m_colours.part);
    m_surface.setFaceColours(faceColours);
    m_surfaceBox = mesh ? boundingBox(*mesh) : Eigen::AlignedBox3d();
    placePlane();
    updateVisibility();
}

void Scene::setFaceColours(std::span<const Rgb> faceColours) {
    m_surface.setFaceColours(faceColours);
}

void Scene::setStandIn(const SharedMesh& coarse, std::span<const Rgb> faceColours) {
    if (coarse != m_standIn.mesh())
        m_standIn.setMesh(coarse, m_colours.part);
    m_standIn.setFaceColours(faceColours);
    updateVisibility();
}

void Scene::useStandIn(bool use) {
    m_standInUsed = use;
    updateVisibility();
}

void Scene::setSeeThrough(bool seeThrough) {
    m_surface.setOpacity(seeThrough ? 0.35 : 1);
    m_standIn.setOpacity(seeThrough ? 0.35 : 1);
}

void Scene::setSurfaceVisible(bool visible) {
    m_surfaceVisible = visible;
    updateVisibility();
}

void Scene::setState(const std::optional<MoldState>& state) {
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
    m_plane.setPlane(rectangle());
    if (m_surface.mesh())
        m_plane.setPartingLine(*m_surface.mesh(), m_state->plane);
    else
        m_plane.clearPartingLine();
    placeArrows();
}

PlaneRectangle Scene::rectangle() const {
    return planeRectangle(m_state ? m_state->plane : PartingPlane{},
                          m_surface.mesh() ? m_surface.mesh()->V : Points());
}

Eigen::Vector3d Scene::arrowTail(int side) const {
    if (!m_surface.mesh())
        return Eigen::Vector3d::Zero();
    const Eigen::Vector3d& d = m_state->directions.of(side);
    const Eigen::Vector3d middle = m_surfaceBox.center();
    // Just outside the part, however it lies.
    const double reach = (m_surface.mesh()->V * d).maxCoeff() - middle.dot(d);
    return middle + (reach + arrowGap * m_surfaceBox.sizes().norm()) * d;
}

Eigen::Vector3d Scene::arrowTip(int side) const {
    if (!m_state)
        return Eigen::Vector3d::Zero();
    const double length = arrowShare * (m_surfaceBox.isEmpty() ? 1 : m_surfaceBox.sizes().norm());
    return arrowTail(side) + length * m_state->directions.of(side);
}

void Scene::placeArrows() {
    const double length = arrowShare * (m_surfaceBox.isEmpty() ? 1 : m_surfaceBox.sizes().norm());
    m_arrow1.set(arrowTail(1), m_state->directions.d1, length);
    m_arrow2.set(arrowTail(2), m_state->directions.d2, length);
}

void Scene::updateVisibility() {
    const bool plane = m_state && m_planeVisible && !m_surfaceBox.isEmpty();
    const bool arrows = m_state && m_directionsVisible && !m_surfaceBox.isEmpty();
    const bool standsIn = m_standInUsed && m_standIn.mesh();
    m_surface.actor()->SetVisibility(m_surface.mesh() && m_surfaceVisible && !standsIn);
    m_standIn.actor()->SetVisibility(standsIn && m_surfaceVisible);
    m_plane.sheet()->SetVisibility(plane);
    m_plane.outline()->SetVisibility(plane);
    m_plane.partingLine()->SetVisibility(m_state && m_surface.mesh() && m_surfaceVisible);
    m_arrow1.actor()->SetVisibility(arrows);
    m_arrow2.actor()->SetVisibility(arrows);
    showGrips();
}

std::vector<GripPlace> Scene::grips() const {
    std::vector<GripPlace> grips;
    if (!m_gripsShown || !m_state || m_surfaceBox.isEmpty())
        return grips;
    if (m_planeVisible)
        for (const Grip grip : planeGrips)
            grips.push_back({grip, gripPlace(rectangle(), grip)});
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

void Scene::setHalves(const SharedMesh& half1, const SharedMesh& half2, const Eigen::Isometry3d& moldToPart,
                      const Directions& directions) {
    if (half1)
        m_half1.set(half1, moldToPart, directions.d1, m_colours.half1);
    else
        m_half1.clear();
    if (half2)
        m_half2.set(half2, moldToPart, directions.d2, m_colours.half2);
    else
        m_half2.clear();
}

void Scene::setOpening(double opening) {
    const double size = m_surfaceBox.isEmpty() ? 1 : m_surfaceBox.sizes().norm();
    m_half1.open(opening * openShare * size);
    m_half2.open(opening * openShare * size);
}

std::vector<Eigen::Vector3d> Scene::outline() const {
    std::vector<Eigen::Vector3d> points;
    if (m_surfaceVisible)
        points = cornersOf(m_surfaceBox);
    for (const HalfLayer* half : {&m_half1, &m_half2})
        std::ranges::copy(half->corners(), std::back_inserter(points));
    if (m_state && m_directionsVisible && !m_surfaceBox.isEmpty())
        for (const int side : {1, 2})
            points.push_back(arrowTip(side));
    return points;
}

void Scene::arrange(const Camera& camera, ViewSize view) {
    vtkCamera* eye = m_renderer->GetActiveCamera();
    eye->SetParallelProjection(!camera.perspective);
    eye->SetViewAngle(camera.viewAngle);
    eye->SetParallelScale(camera.halfHeight());
    // A parallel camera may stand anywhere along its line of sight: far back, so that nothing is cut off.
    const double back = camera.perspective ? 0 : 50 * camera.distance;
    eye->SetPosition(Eigen::Vector3d(camera.position() + back * camera.backwards()).data());
    eye->SetFocalPoint(camera.focus.data());
    eye->SetViewUp(camera.up().data());
    m_renderer->ResetCameraClippingRange();
    m_cube.arrange(camera, view);
    m_overlay.arrange(camera, view);
}

} // namespace moldwright::scene
