// SPDX-License-Identifier: AGPL-3.0-or-later
#include "view/drawing_turns.h"

#include "view/render_view.h"

#include <algorithm>

namespace moldwright {

DrawingTurns& DrawingTurns::all() {
    static DrawingTurns turns;
    return turns;
}

DrawingTurns::DrawingTurns() {
    m_round.setSingleShot(true);
    m_round.setInterval(0);
    QObject::connect(&m_round, &QTimer::timeout, [this] { next(); });
}

bool DrawingTurns::take(RenderView& view) {
    const bool others = !m_waiting.empty() && m_waiting.front() != &view;
    m_round.start();
    if (m_taken || others) {
        if (std::ranges::find(m_waiting, &view) == m_waiting.end())
            m_waiting.push_back(&view);
        return false;
    }
    forget(view);
    m_taken = true;
    return true;
}

void DrawingTurns::next() {
    m_taken = false;
    // Nobody waits for a view that was hidden meanwhile, or that was drawn in another way.
    while (!m_waiting.empty() && !(m_waiting.front()->isVisible() && m_waiting.front()->drawing()))
        m_waiting.pop_front();
    if (!m_waiting.empty())
        m_waiting.front()->update();
}

} // namespace moldwright
