// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/camera.h"
#include "scene/colours.h"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkActor;

namespace moldwright::scene {

/// Words on the cube's faces, in the order front, back, left, right, top, bottom.
using CubeWords = std::array<std::string, 6>;

/// Where the cube's faces look, in the order of CubeWords: front is seen looking along +y.
[[nodiscard]] const std::array<Eigen::Vector3d, 6>& cubeFaces();

/// Which of cubeFaces() the camera looks straight at; −1 for none.
[[nodiscard]] int faceSeen(const Camera& camera);

/// The view that a click on the cube asks for: from a face, an edge or a corner. (x, y) in half edges of the
/// cube from its centre on the screen, y upwards. None beside the cube.
[[nodiscard]] std::optional<Eigen::Vector3d> cubeView(const Camera& camera, double x, double y);

/// A cube in the upper right corner of the view that turns with the camera.
class OrientationCube {
public:
    static constexpr double side = 104; ///< of its square in the view, logical pixels

    OrientationCube();
    ~OrientationCube();

    /// Draws over everything else; the caller adds it to a window with three layers.
    [[nodiscard]] vtkRenderer* renderer() const { return m_renderer; }

    void setLook(const SceneColours& colours, const CubeWords& words, double scale);
    void arrange(const Camera& camera, ViewSize view);

    /// The view asked for by a click on this pixel.
    [[nodiscard]] std::optional<Eigen::Vector3d> viewAt(const Camera& camera, ViewSize view, double x,
                                                        double y) const;

private:
    vtkNew<vtkRenderer> m_renderer;
    std::vector<vtkSmartPointer<vtkActor>> m_faces;
    vtkSmartPointer<vtkActor> m_edges;
    double m_scale = 1;
};

} // namespace moldwright::scene
