// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/camera.h"
#include "scene/colours.h"
#include "scene/grip_disc.h"

#include <Eigen/Core>

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>

#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace moldwright::scene {

/// A pin, and where the parting plane would have it.
struct ShownPin {
    int number = 0;                         ///< which one it is
    Eigen::Vector3d place;                  ///< mm
    std::optional<Eigen::Vector3d> onPlane; ///< mm; none without a plane
    bool chosen = false;

    bool operator==(const ShownPin&) const = default;
};

/// What a view shows of pins.
struct ShownPins {
    std::vector<ShownPin> pins;
    std::vector<Eigen::Vector3d> suggested; ///< mm

    bool operator==(const ShownPins&) const = default;
};

/// A pin by its number, or a suggested one by its number among those shown.
struct PinAt {
    bool suggested = false;
    int number = 0;
};

/// Pins in the view, drawn over everything: a disc at each, a ring where it belongs on the plane, a dashed
/// line between them; suggested ones as faint rings.
class PinLayer {
public:
    PinLayer();

    void addTo(vtkRenderer* renderer);
    void setLook(const SceneColours& colours, double scale);
    void set(const ShownPins& pins);
    [[nodiscard]] const ShownPins& pins() const { return m_pins; }

    /// The one nearest to the pixel (x, y), y downwards, within `reach`; pins before suggested ones.
    [[nodiscard]] std::optional<PinAt> at(const Camera& camera, ViewSize view, double x, double y,
                                          double reach) const;

    /// Puts everything in its place for this camera.
    void arrange(const Camera& camera, ViewSize view);

private:
    using Discs = std::vector<std::unique_ptr<GripDisc>>;

    void show();
    void showDiscs(Discs& discs, const std::vector<DiscLook>& looks);
    void layLines();

    vtkRenderer* m_renderer = nullptr;
    SceneColours m_colours;
    double m_scale = 1;
    ShownPins m_pins;
    Discs m_suggested;
    Discs m_rings;
    Discs m_discs;
    vtkNew<vtkPolyData> m_dashes;
    vtkNew<vtkPolyDataMapper2D> m_mapper;
    vtkNew<vtkActor2D> m_lines;
};

} // namespace moldwright::scene
