// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/orientation_cube.h"

#include "scene/fonts.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

namespace moldwright::scene {

namespace {

constexpr double halfSeen = 1.85; ///< half edges from the centre to the square's border
constexpr int textureSize = 160;

/// Right and up of the words on each face.
const std::array<std::array<Eigen::Vector3d, 2>, 6>& faceAxes() {
    using V = Eigen::Vector3d;
    static const std::array<std::array<V, 2>, 6> axes = {{{V(1, 0, 0), V(0, 0, 1)},
                                                          {V(-1, 0, 0), V(0, 0, 1)},
                                                          {V(0, -1, 0), V(0, 0, 1)},
                                                          {V(0, 1, 0), V(0, 0, 1)},
                                                          {V(1, 0, 0), V(0, 1, 0)},
                                                          {V(1, 0, 0), V(0, -1, 0)}}};
    return axes;
}

/// A square picture of `word` in the middle of a plain ground.
vtkNew<vtkImageData> wordPicture(const std::string& word, Rgb ground, Rgb ink) {
    vtkNew<vtkTextProperty> style;
    if (const std::string& file = viewFontFor(word, true); !file.empty()) {
        style->SetFontFamily(VTK_FONT_FILE);
        style->SetFontFile(file.c_str());
    }
    style->SetFontSize(word.size() > 7 ? 26 : 36);
    style->SetColor(1, 1, 1);
    vtkNew<vtkImageData> text;
    std::array<int, 2> size = {};
    if (!vtkTextRenderer::GetInstance()->RenderString(style, word, text, size.data(), 72))
        size = {0, 0};

    vtkNew<vtkImageData> picture;
    picture->SetDimensions(textureSize, textureSize, 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    const int left = (textureSize - size[0]) / 2;
    const int bottom = (textureSize - size[1]) / 2;
    const std::array<int, 6> extent = {
        text->GetExtent()[0], text->GetExtent()[1], text->GetExtent()[2], text->GetExtent()[3], 0, 0};
    for (int y = 0; y < textureSize; ++y)
        for (int x = 0; x < textureSize; ++x) {
            const int tx = x - left + extent[0];
            const int ty = y - bottom + extent[2];
            double cover = 0;
            if (x >= left && y >= bottom && x < left + size[0] && y < bottom + size[1] && tx <= extent[1] &&
                ty <= extent[3])
                cover = static_cast<unsigned char*>(text->GetScalarPointer(tx, ty, 0))[3] / 255.;
            auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
            const std::array<double, 3> from = ground.unit();
            const std::array<double, 3> to = ink.unit();
            for (int c = 0; c < 3; ++c)
                pixel[c] =
                    static_cast<unsigned char>(std::lround(255 * (from[c] + cover * (to[c] - from[c]))));
        }
    return picture;
}

vtkSmartPointer<vtkActor> faceActor(int face) {
    const Eigen::Vector3d centre = cubeFaces()[face];
    const auto& [right, up] = faceAxes()[face];
    vtkNew<vtkPlaneSource> quad;
    quad->SetOrigin(Eigen::Vector3d(centre - right - up).data());
    quad->SetPoint1(Eigen::Vector3d(centre + right - up).data());
    quad->SetPoint2(Eigen::Vector3d(centre - right + up).data());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(quad->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->BackfaceCullingOn();
    return actor;
}

} // namespace

const std::array<Eigen::Vector3d, 6>& cubeFaces() {
    using V = Eigen::Vector3d;
    static const std::array<V, 6> faces = {V(0, -1, 0), V(0, 1, 0), V(-1, 0, 0),
                                           V(1, 0, 0),  V(0, 0, 1), V(0, 0, -1)};
    return faces;
}

int faceSeen(const Camera& camera) {
    constexpr double straight = 1 - 1e-6;
    for (int face = 0; face < 6; ++face)
        if (camera.backwards().dot(cubeFaces()[face]) > straight)
            return face;
    return -1;
}

std::optional<Eigen::Vector3d> cubeView(const Camera& camera, double x, double y) {
    const Eigen::Vector3d origin = x * camera.right() + y * camera.up() + 10 * camera.backwards();
    const Eigen::Vector3d way = -camera.backwards();
    double enter = 0;
    double leave = 100;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(way[axis]) < 1e-12) {
            if (std::abs(origin[axis]) > 1)
                return std::nullopt;
            continue;
        }
        const double a = (-1 - origin[axis]) / way[axis];
        const double b = (1 - origin[axis]) / way[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave)
        return std::nullopt;
    constexpr double border = 0.64; // beyond it an edge or a corner is meant
    const Eigen::Vector3d hit = origin + enter * way;
    Eigen::Vector3d from;
    for (int axis = 0; axis < 3; ++axis)
        from[axis] = hit[axis] > border ? 1 : hit[axis] < -border ? -1 : 0;
    return from;
}

OrientationCube::OrientationCube() {
    m_renderer->SetLayer(2);
    m_renderer->InteractiveOff();
    for (int face = 0; face < 6; ++face) {
        m_faces.push_back(faceActor(face));
        m_renderer->AddActor(m_faces.back());
    }
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(2);
    cube->SetYLength(2);
    cube->SetZLength(2);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cube->GetOutputPort());
    m_edges = vtkSmartPointer<vtkActor>::New();
    m_edges->SetMapper(mapper);
    m_edges->GetProperty()->SetRepresentationToWireframe();
    m_edges->GetProperty()->LightingOff();
    m_edges->GetProperty()->FrontfaceCullingOff();
    m_edges->GetProperty()->BackfaceCullingOn();
    m_edges->SetScale(1.002);
    m_renderer->AddActor(m_edges);
    m_renderer->GetActiveCamera()->ParallelProjectionOn();
}

OrientationCube::~OrientationCube() = default;

void OrientationCube::setLook(const SceneColours& colours, const CubeWords& words, double scale) {
    m_scale = scale;
    for (int face = 0; face < 6; ++face) {
        vtkNew<vtkTexture> texture;
        texture->SetInputData(wordPicture(words[face], colours.cube, colours.text));
        texture->InterpolateOn();
        texture->MipmapOn();
        m_faces[face]->SetTexture(texture);
    }
    m_edges->GetProperty()->SetColor(colours.cubeEdge.unit().data());
    m_edges->GetProperty()->SetLineWidth(static_cast<float>(1.2 * scale));
}

void OrientationCube::arrange(const Camera& camera, ViewSize view) {
    const double wide = side * m_scale;
    m_renderer->SetViewport(std::max(0.0, 1 - wide / view.width), std::max(0.0, 1 - wide / view.height), 1,
                            1);
    vtkCamera* eye = m_renderer->GetActiveCamera();
    eye->SetFocalPoint(0, 0, 0);
    eye->SetPosition(Eigen::Vector3d(10 * camera.backwards()).data());
    eye->SetViewUp(camera.up().data());
    eye->SetParallelScale(halfSeen);
    eye->SetClippingRange(1, 20);
}

std::optional<Eigen::Vector3d> OrientationCube::viewAt(const Camera& camera, ViewSize view, double x,
                                                       double y) const {
    const double half = side * m_scale / 2;
    return cubeView(camera, (x - (view.width - half)) / half * halfSeen, (half - y) / half * halfSeen);
}

} // namespace moldwright::scene
