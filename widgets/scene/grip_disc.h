// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>

class vtkRenderer;

namespace moldwright::scene {

/// How a disc is drawn; lengths in device pixels.
struct DiscLook {
    double radius = 0;
    double rim = 0; ///< of the radius
    Rgb face;
    Rgb edge = Rgb::hex(0xFFFFFF);
    double faceOpacity = 1; ///< 0: a ring
    double opacity = 1;     ///< of all of it

    bool operator==(const DiscLook&) const = default;
};

/// A small disc or ring, drawn flat in the view: a grip, a pin, or the mark of a place. A picture with smooth
/// edges, since so few pixels of a drawn circle look like an octagon.
class GripDisc {
public:
    explicit GripDisc(vtkRenderer* renderer);

    void show(bool shown, const DiscLook& look);
    /// Its middle, counted from the lower left corner of the view.
    void moveTo(double x, double y) { m_actor->SetPosition(x, y); }

private:
    void paint();

    DiscLook m_look;
    vtkNew<vtkImageData> m_image;
    vtkNew<vtkTexture> m_texture;
    vtkNew<vtkPoints> m_corners;
    vtkNew<vtkPolyData> m_square;
    vtkNew<vtkTexturedActor2D> m_actor;
};

} // namespace moldwright::scene
