// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "design/design.h"
#include "panels/progress_plots.h"
#include "scene/drawn_mesh.h"
#include "scene/surface_picker.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <vector>

namespace moldwright {

/// A frame of a run, ready to be shown.
struct ShownFrame {
    DesignFrame frame;
    scene::SharedDrawnMesh drawn;                            ///< of a large shape only the stand-in
    DraftAnalysis analysis;                                  ///< of the shape, of a large one of its stand-in
    std::shared_ptr<const scene::SurfacePicker> picker = {}; ///< made when something is to be clicked on it
    std::vector<Pin> pins = {}; ///< the document's, where they are in the shape; none where that is not known
};

/// Made ready to be shown.
[[nodiscard]] ShownFrame shownFrame(const DesignFrame& frame, bool withPicker);

/// What a view takes from a run at a time.
struct TakenFrames {
    std::optional<ShownFrame> newest;  ///< not yet taken
    std::vector<DesignFrame> frames;   ///< all since the last time
    std::vector<ProgressPoint> points; ///< their numbers
};

/// Where a running design leaves its frames: a slot for the newest one, ready to be shown, and a list of all.
/// The run writes on its thread, the view takes at display rate; what the view does not take in time is
/// not made ready again.
class FrameStream {
public:
    /// Called by the run after every step.
    void put(const DesignFrame& frame);

    [[nodiscard]] TakenFrames take();

    /// Whether frames come with a picker.
    void setPickers(bool wanted) { m_pickers = wanted; }

private:
    std::atomic<bool> m_pickers = false;
    std::mutex m_mutex;
    TakenFrames m_waiting;
};

} // namespace moldwright
