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

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace moldwright::scene {

/// A closed line through these points, mm.
using Outline = std::vector<Eigen::Vector3d>;

/// A feature of the mold, on the parting plane.
struct ShownFeature {
    std::vector<Outline> outlines;       ///< one for each of its copies
    std::vector<Eigen::Vector3d> places; ///< where each copy can be taken hold of, mm
    bool byHand = false;                 ///< it stands where a hand put it
    bool failing = false;                ///< a limit is broken there
    bool chosen = false;

    bool operator==(const ShownFeature&) const = default;
};

/// What a view shows of the mold's plan.
struct ShownPlan {
    std::vector<Outline> lines; ///< the block's edge and the parting lines
    std::vector<ShownFeature> features;

    bool operator==(const ShownPlan&) const = default;
};

/// A feature under the pointer, and which of its copies.
struct FeatureAt {
    int feature = 0;
    int copy = 0;

    bool operator==(const FeatureAt&) const = default;
};

/// The features of a mold as outlines on the parting plane, drawn over everything, each with a disc to take
/// hold of: a ring where the program found the place, filled where a hand did.
class FeatureLayer {
public:
    FeatureLayer();

    void addTo(vtkRenderer* renderer);
    void setLook(const SceneColours& colours, double scale);
    void set(const ShownPlan& plan);
    [[nodiscard]] const ShownPlan& plan() const { return m_plan; }

    /// The one whose disc is nearest to the pixel (x, y), y downwards, within `reach`.
    [[nodiscard]] std::optional<FeatureAt> at(const Camera& camera, ViewSize view, double x, double y,
                                              double reach) const;

    /// Puts everything in its place for this camera.
    void arrange(const Camera& camera, ViewSize view);

private:
    /// Lines of one look.
    struct Strokes {
        vtkNew<vtkPolyData> lines;
        vtkNew<vtkPolyDataMapper2D> mapper;
        vtkNew<vtkActor2D> actor;
    };
    enum Look { Quiet, Found, Chosen, Failing, LookCount };

    [[nodiscard]] static Look lookOf(const ShownFeature& feature);
    [[nodiscard]] Rgb colourOf(Look look) const;
    void show();
    void layLines();

    vtkRenderer* m_renderer = nullptr;
    SceneColours m_colours;
    double m_scale = 1;
    ShownPlan m_plan;
    std::array<Strokes, LookCount> m_strokes;
    std::vector<std::unique_ptr<GripDisc>> m_discs; ///< of all copies, in their order
};

} // namespace moldwright::scene
