// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/grip_disc.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace moldwright::scene {

namespace {

/// How much of a pixel lies inside, `depth` pixels within the edge.
double coverage(double depth) {
    return std::clamp(depth + 0.5, 0.0, 1.0);
}

} // namespace

GripDisc::GripDisc(vtkRenderer* renderer) {
    const vtkNew<vtkFloatArray> onPicture;
    onPicture->SetNumberOfComponents(2);
    for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        onPicture->InsertNextTuple2(s, t);
    const vtkNew<vtkCellArray> square;
    square->InsertNextCell({0, 1, 2, 3});
    m_square->SetPoints(m_corners);
    m_square->SetPolys(square);
    m_square->GetPointData()->SetTCoords(onPicture);
    const vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(m_square);
    m_texture->SetInputData(m_image);
    m_texture->InterpolateOn();
    m_actor->SetMapper(mapper);
    m_actor->SetTexture(m_texture);
    m_actor->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
    renderer->AddViewProp(m_actor);
}

void GripDisc::show(bool shown, const DiscLook& look) {
    m_actor->SetVisibility(shown);
    if (look == m_look)
        return;
    m_look = look;
    paint();
}

void GripDisc::paint() {
    const int half = static_cast<int>(std::ceil(m_look.radius)) + 1;
    const int side = 2 * half;
    m_image->SetDimensions(side, side, 1);
    m_image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double away = std::hypot(x + 0.5 - half, y + 0.5 - half);
            // Where face and rim meet, both are laid over one another by their shares.
            const double inside = coverage(m_look.radius - m_look.rim - away);
            const double face = inside * m_look.faceOpacity;
            const double edge = (1 - inside) * coverage(m_look.radius - away);
            const double whole = face + edge;
            const auto mixed = [&](std::uint8_t within, std::uint8_t rim) {
                return static_cast<unsigned char>(
                    whole > 0 ? std::lround((face * within + edge * rim) / whole) : 0);
            };
            auto* pixel = static_cast<unsigned char*>(m_image->GetScalarPointer(x, y, 0));
            pixel[0] = mixed(m_look.face.r, m_look.edge.r);
            pixel[1] = mixed(m_look.face.g, m_look.edge.g);
            pixel[2] = mixed(m_look.face.b, m_look.edge.b);
            pixel[3] = static_cast<unsigned char>(std::lround(255 * whole * m_look.opacity));
        }
    m_image->Modified();
    m_corners->Reset();
    for (const auto& [s, t] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
        m_corners->InsertNextPoint(s, t, 0);
    m_corners->Modified();
    m_square->Modified();
}

} // namespace moldwright::scene
