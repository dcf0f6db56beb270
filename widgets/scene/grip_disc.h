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

/// A small disc with a white rim, drawn flat in the view: a grip, or the mark of a place. A picture with
/// smooth edges, since so few pixels of a drawn circle look like an octagon. Lengths in device pixels.
class GripDisc {
public:
    explicit GripDisc(vtkRenderer* renderer);

    void show(bool shown, double radius, double rim, Rgb colour);
    /// Its middle, counted from the lower left corner of the view.
    void moveTo(double x, double y) { m_actor->SetPosition(x, y); }

private:
    void paint();

    double m_radius = 0;
    double m_rim = 0;
    Rgb m_colour;
    vtkNew<vtkImageData> m_image;
    vtkNew<vtkTexture> m_texture;
    vtkNew<vtkPoints> m_corners;
    vtkNew<vtkPolyData> m_square;
    vtkNew<vtkTexturedActor2D> m_actor;
};

} // namespace moldwright::scene
