// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/camera.h"
#include "scene/grip_disc.h"
#include "scene/legend_panel.h"
#include "scene/overlay_panel.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace moldwright::scene {

/// A short text beside a point of the scene.
struct Chip {
    Eigen::Vector3d place; ///< mm
    PanelContent content;
    std::optional<Rgb> mark = {}; ///< a disc of this colour at the place

    bool operator==(const Chip&) const = default;
};

/// What is drawn flat over the scene: legend bottom left, state chip top left, chips at their places (which
/// give way to each other), and the grips. In a small view a chip keeps its first word where that is bold; of
/// many marked chips only the bold ones keep their text.
class Overlay {
public:
    Overlay();
    ~Overlay();

    void addTo(vtkRenderer* renderer);
    void setColours(const SceneColours& colours, double scale);
    void setLegend(const PanelContent& content);
    void setState(const PanelContent& content);
    void setChips(const std::vector<Chip>& chips);

    /// The points to be drawn as grips; `held` is the one under the pointer, or −1.
    void setGrips(const std::vector<Eigen::Vector3d>& places, int held);

    /// The chip whose mark lies within `reach` of the pixel (x, y), y downwards; −1 for none.
    [[nodiscard]] int markAt(const Camera& camera, ViewSize view, double x, double y, double reach) const;

    /// Puts everything in its place for this camera. The legend gives way to the place of the shape, where it
    /// is given.
    void arrange(const Camera& camera, ViewSize view, const std::optional<Spot>& shape = {});

    [[nodiscard]] const LegendPanel& legend() const { return m_legend; }
    /// The state chip, pixels.
    [[nodiscard]] Spot stateSpot(ViewSize view) const;

private:
    void showMarks();
    void lay(OverlayPanel& panel, const PanelContent& content);
    void layAll();
    [[nodiscard]] PanelContent shownContent(const Chip& chip) const;
    void setSmall(bool small);

    vtkRenderer* m_renderer = nullptr;
    SceneColours m_colours;
    double m_scale = 1;
    bool m_small = false;   ///< the view is
    bool m_crowded = false; ///< more marks than can have their text
    LegendPanel m_legend;
    OverlayPanel m_state;
    PanelContent m_stateContent;
    std::vector<Chip> m_chips;
    std::vector<std::unique_ptr<OverlayPanel>> m_chipPanels;
    std::vector<Eigen::Vector3d> m_gripPlaces;
    int m_heldGrip = -1;
    std::vector<std::unique_ptr<GripDisc>> m_grips;
    std::vector<std::unique_ptr<GripDisc>> m_marks; ///< one for each chip, shown where it has a mark
};

} // namespace moldwright::scene
