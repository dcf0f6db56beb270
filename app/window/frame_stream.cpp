// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/frame_stream.h"

#include "castability/cast_analysis.h"

#include <utility>

namespace moldwright {

void FrameStream::put(const DesignFrame& frame, double draftDegrees) {
    ShownFrame shown{frame, {}};
    // Which faces to paint red is found here, so that the interface thread need not.
    if (frame.shape)
        shown.analysis = frame.labels.empty()
                             ? analyzeDraft(*frame.shape, frame.state, draftDegrees, false)
                             : analyzeCast(*frame.shape, frame.labels, frame.state, draftDegrees);
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
