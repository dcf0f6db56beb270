// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/frame_stream.h"

#include "castability/cast_analysis.h"

#include <utility>

namespace moldwright {

ShownFrame shownFrame(const DesignFrame& frame, bool withPicker) {
    ShownFrame shown{frame, scene::sketchedMesh(frame.shape), {}, {}, {}};
    if (!frame.shape)
        return shown;
    if (withPicker)
        shown.picker = std::make_shared<const scene::SurfacePicker>(frame.shape);
    const bool sketched = shown.drawn->sketched();
    const IndexedMesh& seen = sketched ? *shown.drawn->standIn->mesh : *frame.shape;
    const double draft = frame.settings.draftDegrees;
    shown.analysis = frame.labels.empty() || sketched ? analyzeDraft(seen, frame.state, draft, false)
                                                      : analyzeCast(seen, frame.labels, frame.state, draft);
    return shown;
}

void FrameStream::put(const DesignFrame& frame) {
    // What the view needs is made here, so that the interface thread need not.
    ShownFrame shown = shownFrame(frame, m_pickers);
    const std::lock_guard lock(m_mutex);
    m_waiting.newest = std::move(shown);
    m_waiting.frames.push_back(frame);
    m_waiting.points.push_back(
        {frame.step, frame.energy, frame.worstDraftDegrees, frame.violatingAreaFraction});
}

TakenFrames FrameStream::take() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_waiting, {});
}

} // namespace moldwright
