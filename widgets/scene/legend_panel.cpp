// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/legend_panel.h"

namespace moldwright::scene {

namespace {

constexpr double gap = 12; ///< from the view's border, logical pixels

/// Whether two contents are as large, nearly: numbers in them may differ.
bool alike(const PanelContent& a, const PanelContent& b) {
    return a.title == b.title && a.lines.size() == b.lines.size();
}

} // namespace

void LegendPanel::setLook(const SceneColours& colours, double scale) {
    m_colours = colours;
    m_scale = scale;
    m_spots = {};
    lay(m_form);
}

void LegendPanel::set(const PanelContent& content) {
    if (content == m_content)
        return;
    if (!alike(content, m_content))
        m_spots = {};
    m_content = content;
    lay(m_form);
}

void LegendPanel::lay(PanelForm form) {
    m_form = form;
    m_panel.setContent(m_content, m_colours, m_scale, form);
    m_panel.setVisible(!m_content.title.empty() || !m_content.lines.empty());
    m_panel.moveTo(gap * m_scale, gap * m_scale);
    m_spots[static_cast<std::size_t>(form)] = spot();
}

Spot LegendPanel::spot() const {
    return m_panel.visible() ? Spot{gap * m_scale, gap * m_scale, m_panel.width(), m_panel.height()} : Spot{};
}

Spot LegendPanel::spotAs(PanelForm form) {
    std::optional<Spot>& known = m_spots[static_cast<std::size_t>(form)];
    if (!known)
        lay(form);
    return *known;
}

double LegendPanel::rowRoom() const {
    return (2 * gap + OverlayPanel::rowHeight) * m_scale;
}

void LegendPanel::arrange(ViewSize view, const std::optional<Spot>& shape) {
    if (!m_panel.visible())
        return;
    PanelForm form = shape ? PanelForm::Lines : m_form;
    for (; form != PanelForm::Title; form = static_cast<PanelForm>(static_cast<int>(form) + 1)) {
        const Spot spot = spotAs(form);
        const bool fits = spot.left + spot.width + gap * m_scale <= view.width &&
                          spot.bottom + spot.height + gap * m_scale <= view.height;
        if (fits && !(shape && form == PanelForm::Lines && spot.overlaps(*shape)))
            break;
    }
    if (form != m_form)
        lay(form);
}

} // namespace moldwright::scene
