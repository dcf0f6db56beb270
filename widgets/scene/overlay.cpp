// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/overlay.h"

#include "scene/orientation_cube.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace moldwright::scene {

namespace {

constexpr double edge = 12;        ///< from the view's border, logical pixels
constexpr double smallWidth = 420; ///< a view below is small, logical pixels
constexpr double smallHeight = 330;
constexpr int mostMarkTexts = 6;

} // namespace

Overlay::Overlay() = default;

Overlay::~Overlay() = default;

void Overlay::addTo(vtkRenderer* renderer) {
    m_renderer = renderer;
    m_legend.addTo(renderer);
    m_state.addTo(renderer);
}

void Overlay::lay(OverlayPanel& panel, const PanelContent& content) {
    panel.setContent(content, m_colours, m_scale);
    panel.setVisible(!content.title.empty() || !content.lines.empty());
}

void Overlay::setColours(const SceneColours& colours, double scale) {
    m_colours = colours;
    m_scale = scale;
    m_legend.setLook(colours, scale);
    layAll();
    setGrips(m_gripPlaces, m_heldGrip);
    showMarks();
}

void Overlay::layAll() {
    lay(m_state, m_stateContent);
    for (std::size_t i = 0; i < m_chips.size(); ++i)
        lay(*m_chipPanels[i], shownContent(m_chips[i]));
}

PanelContent Overlay::shownContent(const Chip& chip) const {
    PanelContent content = chip.content;
    const bool bold =
        !content.lines.empty() && !content.lines[0].runs.empty() && content.lines[0].runs[0].bold;
    // In a small view the rest would lie over the shape, and a first word alone tells nothing.
    if (!bold && (m_small || (chip.mark && m_crowded)))
        return {};
    if (m_small && !content.lines.empty()) {
        content.lines.resize(1);
        content.lines[0].runs.resize(std::min<std::size_t>(1, content.lines[0].runs.size()));
    }
    return content;
}

void Overlay::setSmall(bool small) {
    if (small == m_small)
        return;
    m_small = small;
    layAll();
}

void Overlay::setLegend(const PanelContent& content) {
    m_legend.set(content);
}

void Overlay::setState(const PanelContent& content) {
    if (content == m_stateContent)
        return;
    m_stateContent = content;
    lay(m_state, content);
}

void Overlay::setChips(const std::vector<Chip>& chips) {
    while (m_chipPanels.size() < chips.size()) {
        m_marks.push_back(std::make_unique<GripDisc>(m_renderer));
        m_chipPanels.push_back(std::make_unique<OverlayPanel>());
        m_chipPanels.back()->addTo(m_renderer);
    }
    const bool crowded = std::ranges::count_if(chips, [](const Chip& chip) {
                             return chip.mark && !chip.content.lines.empty();
                         }) > mostMarkTexts;
    const bool anew = crowded != m_crowded;
    m_crowded = crowded;
    for (std::size_t i = 0; i < m_chipPanels.size(); ++i) {
        if (i >= chips.size())
            m_chipPanels[i]->setVisible(false);
        else if (anew || i >= m_chips.size() || chips[i].content != m_chips[i].content ||
                 chips[i].mark != m_chips[i].mark)
            lay(*m_chipPanels[i], shownContent(chips[i]));
    }
    m_chips = chips;
    showMarks();
}

void Overlay::showMarks() {
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        const std::optional<Rgb> mark = i < m_chips.size() ? m_chips[i].mark : std::nullopt;
        m_marks[i]->show(mark.has_value(), {8 * m_scale, 2 * m_scale, mark.value_or(m_colours.undercut)});
    }
}

int Overlay::markAt(const Camera& camera, ViewSize view, double x, double y, double reach) const {
    for (std::size_t i = 0; i < m_chips.size(); ++i)
        if (m_chips[i].mark &&
            (camera.project(m_chips[i].place, view).head<2>() - Eigen::Vector2d(x, y)).norm() <= reach)
            return static_cast<int>(i);
    return -1;
}

void Overlay::setGrips(const std::vector<Eigen::Vector3d>& places, int held) {
    m_gripPlaces = places;
    m_heldGrip = held;
    while (m_grips.size() < places.size())
        m_grips.push_back(std::make_unique<GripDisc>(m_renderer));
    for (std::size_t i = 0; i < m_grips.size(); ++i) {
        const bool isHeld = static_cast<int>(i) == held;
        m_grips[i]->show(i < places.size(), {(isHeld ? 7.5 : 6) * m_scale, 2 * m_scale,
                                             isHeld ? m_colours.accent : m_colours.plane});
    }
}

Spot Overlay::stateSpot(ViewSize view) const {
    const double gap = edge * m_scale;
    return m_state.visible()
               ? Spot{gap, view.height - gap - m_state.height(), m_state.width(), m_state.height()}
               : Spot{};
}

void Overlay::arrange(const Camera& camera, ViewSize view, const std::optional<Spot>& shape) {
    setSmall(view.width < smallWidth * m_scale || view.height < smallHeight * m_scale);
    const double gap = edge * m_scale;
    m_legend.arrange(view, shape);
    m_state.moveTo(gap, view.height - gap - m_state.height());
    std::vector<Spot> taken = {m_legend.spot(), stateSpot(view)};
    const double side = OrientationCube::side * m_scale;
    const Spot cube{view.width - side, view.height - side, side, side};
    for (std::size_t i = 0; i < m_chips.size(); ++i) {
        OverlayPanel& panel = *m_chipPanels[i];
        const Eigen::Vector3d pixel = camera.project(m_chips[i].place, view);
        m_marks[i]->moveTo(pixel.x(), view.height - pixel.y());
        if (!panel.visible())
            continue;
        // Away from the middle, so that the arrow it belongs to stays free.
        const bool leftwards = pixel.x() < view.width / 2;
        Spot spot{leftwards ? pixel.x() - 14 * m_scale - panel.width() : pixel.x() + 14 * m_scale,
                  view.height - pixel.y() - panel.height() / 2, panel.width(), panel.height()};
        spot.left = std::clamp(spot.left, gap, std::max(gap, view.width - panel.width() - gap));
        spot.bottom = std::clamp(spot.bottom, gap, std::max(gap, view.height - panel.height() - gap));
        if (spot.overlaps(cube))
            spot.left = cube.left - panel.width() - 4 * m_scale;
        for (const Spot& other : taken) {
            if (!spot.overlaps(other))
                continue;
            spot.bottom = other.bottom + other.height + 4 * m_scale;
            if (spot.bottom + spot.height > view.height)
                spot.bottom = other.bottom - spot.height - 4 * m_scale;
        }
        taken.push_back(spot);
        panel.moveTo(spot.left, spot.bottom);
    }
    for (std::size_t i = 0; i < m_gripPlaces.size(); ++i) {
        const Eigen::Vector3d pixel = camera.project(m_gripPlaces[i], view);
        m_grips[i]->moveTo(pixel.x(), view.height - pixel.y());
    }
}

} // namespace moldwright::scene
