// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "design/design.h"
#include "panels/progress_plots.h"
#include "scene/drawn_mesh.h"
#include "scene/surface_picker.h"

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

/// Where a running design leaves its frames: a slot for the newest frame and a list of every step's numbers.
/// The run writes on its thread, the view takes at display rate; what the view does not take in time is
/// replaced.
class FrameStream {
public:
    /// Called by the run after every step.
    void put(const DesignFrame& frame);

    /// The newest frame not yet taken, and the numbers of the steps since the last time.
    [[nodiscard]] std::optional<ShownFrame> take(std::vector<ProgressPoint>& points);

private:
    std::mutex m_mutex;
    std::optional<ShownFrame> m_newest;
    std::vector<ProgressPoint> m_points;
};

} // namespace moldwright
