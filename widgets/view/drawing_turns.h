// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QTimer>

#include <deque>

namespace moldwright {

class RenderView;

/// Several views never draw one after the other without the window hearing of anything in between: between
/// two rounds of events only one draws, and those that had to wait come before those that come again.
class DrawingTurns {
public:
    /// Those of all views of the program.
    [[nodiscard]] static DrawingTurns& all();

    /// Whether this view may draw now; if not, it is asked to paint itself when its turn has come.
    [[nodiscard]] bool take(RenderView& view);
    /// A view is no more.
    void forget(RenderView& view) { std::erase(m_waiting, &view); }

private:
    DrawingTurns();
    void next();

    QTimer m_round; ///< runs out once other events were heard
    bool m_taken = false;
    std::deque<RenderView*> m_waiting;
};

} // namespace moldwright
