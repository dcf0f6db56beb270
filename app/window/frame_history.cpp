// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/frame_history.h"

#include <algorithm>

namespace moldwright {

namespace {

std::size_t bytesOf(const DesignFrame& frame) {
    std::size_t bytes = frame.labels.size() * sizeof(frame.labels.front());
    if (frame.shape)
        bytes += static_cast<std::size_t>(frame.shape->V.size()) * sizeof(double) +
                 static_cast<std::size_t>(frame.shape->F.size()) * sizeof(int);
    for (const auto& points : {frame.before, frame.partPoints})
        if (points)
            bytes += static_cast<std::size_t>(points->size()) * sizeof(double);
    return bytes;
}

} // namespace

void FrameHistory::clear() {
    m_frames.clear();
    m_bytes = 0;
    m_stride = 1;
}

void FrameHistory::add(const DesignFrame& frame) {
    // The newest is kept until a newer one comes, even out of turn.
    if (!m_frames.empty() && (m_frames.back().step - 1) % m_stride != 0) {
        m_bytes -= bytesOf(m_frames.back());
        m_frames.pop_back();
    }
    m_frames.push_back(frame);
    m_bytes += bytesOf(frame);
    while (m_bytes > m_mostBytes && m_frames.size() > 2)
        thin();
}

int FrameHistory::at(int step) const {
    const auto frame = std::ranges::find(m_frames, step, &DesignFrame::step);
    return frame == m_frames.end() ? -1 : static_cast<int>(frame - m_frames.begin());
}

void FrameHistory::thin() {
    m_stride *= 2;
    const int newest = m_frames.back().step;
    std::erase_if(m_frames, [&](const DesignFrame& frame) {
        return (frame.step - 1) % m_stride != 0 && frame.step != newest;
    });
    m_bytes = 0;
    for (const DesignFrame& frame : m_frames)
        m_bytes += bytesOf(frame);
}

} // namespace moldwright
