// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/design.h"

#include <cstddef>
#include <vector>

namespace moldwright {

/// The frames of a run that are kept to go back to. Memory is bounded: when it is full every second frame
/// goes, and from then on every second one is kept, so that they stay evenly spread over the run.
class FrameHistory {
public:
    explicit FrameHistory(std::size_t bytes = kBytes) : m_mostBytes(bytes) {}

    void clear();
    /// `frame` follows the ones before it.
    void add(const DesignFrame& frame);

    /// From the first to the newest, which is always there.
    [[nodiscard]] const std::vector<DesignFrame>& frames() const { return m_frames; }
    /// The number of the frame of this step, or −1.
    [[nodiscard]] int at(int step) const;
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

private:
    static constexpr std::size_t kBytes = std::size_t(256) << 20;

    void thin();

    std::size_t m_mostBytes;
    std::size_t m_bytes = 0;
    int m_stride = 1; ///< every so many steps are kept
    std::vector<DesignFrame> m_frames;
};

} // namespace moldwright
