// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/camera.h"
#include "scene/overlay_panel.h"

#include <array>
#include <optional>

class vtkRenderer;

namespace moldwright::scene {

/// A rectangle of the view in pixels; y upwards, as VTK counts.
struct Spot {
    double left = 0;
    double bottom = 0;
    double width = 0;
    double height = 0;

    [[nodiscard]] bool overlaps(const Spot& o) const {
        return left < o.left + o.width && o.left < left + width && bottom < o.bottom + o.height &&
               o.bottom < bottom + height;
    }
};

/// The legend, in the lower left corner. It gives way to the shape: where its lines would lie over it, it is
/// a row along the border, and only its title where the view is too narrow for that.
class LegendPanel {
public:
    void addTo(vtkRenderer* renderer) { m_panel.addTo(renderer); }
    void setLook(const SceneColours& colours, double scale);
    void set(const PanelContent& content);

    /// Takes its place, in a form that fits the view. With the place of the shape it takes the widest form
    /// that leaves it free; without it is changed only where it has to be.
    void arrange(ViewSize view, const std::optional<Spot>& shape);

    [[nodiscard]] PanelForm form() const { return m_form; }
    /// Its words as they are laid out; empty while there is none.
    [[nodiscard]] std::string words() const { return m_panel.visible() ? m_panel.words() : std::string(); }
    [[nodiscard]] Spot spot() const;
    /// As high as a row with the gap below it, for the scale set: what a view has to leave free for it.
    [[nodiscard]] double rowRoom() const;

private:
    void lay(PanelForm form);
    [[nodiscard]] Spot spotAs(PanelForm form);

    OverlayPanel m_panel;
    PanelContent m_content;
    SceneColours m_colours;
    double m_scale = 1;
    PanelForm m_form = PanelForm::Lines;
    std::array<std::optional<Spot>, 4> m_spots; ///< of each form, where it was laid out
};

} // namespace moldwright::scene
