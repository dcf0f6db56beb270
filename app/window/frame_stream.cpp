// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/frame_stream.h"

#include "castability/cast_analysis.h"

#include <utility>

namespace moldwright {

void FrameStream::put(const DesignFrame& frame) {
    // What the view needs is made here, so that the interface thread need not.
    ShownFrame shown{frame, scene::sketchedMesh(frame.shape), {}, {}, {}};
    if (frame.shape) {
        const bool sketched = shown.drawn->sketched();
        const IndexedMesh& seen = sketched ? *shown.drawn->standIn->mesh : *frame.shape;
        shown.analysis = frame.labels.empty() || sketched
                             ? analyzeDraft(seen, frame.state, frame.settings.draftDegrees, false)
                             : analyzeCast(seen, frame.labels, frame.state, frame.settings.draftDegrees);
    }
    const std::lock_guard lock(m_mutex);
    m_newest = std::move(shown);
    m_points.push_back({frame.step, frame.energy, frame.worstDraftDegrees, frame.violatingAreaFraction});
}

std::optional<ShownFrame> FrameStream::take(std::vector<ProgressPoint>& points) {
    const std::lock_guard lock(m_mutex);
    points = std::exchange(m_points, {});
    return std::exchange(m_newest, std::nullopt);
}

} // namespace moldwright
