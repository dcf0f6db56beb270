// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "castability/plane_search.h"
#include "design/design.h"

#include <expected>
#include <string>

namespace moldwright {

/// What the stages of one design share: what is asked, who watches, and what is known so far.
class DesignRun {
public:
    DesignRun(const DesignRequest& request, const Task& task, const FrameSink& frames)
        : m_request(request), m_task(task), m_frames(frames) {}

    [[nodiscard]] const DesignRequest& request() const { return m_request; }
    [[nodiscard]] const Task& task() const { return m_task; }
    [[nodiscard]] bool stopped() const { return m_task.stopped(); }

    /// The seconds spent so far, by stage.
    [[nodiscard]] std::map<std::string, double>& seconds() { return m_seconds; }

    /// Directions at a plane, as the request chooses them.
    [[nodiscard]] Directions directionsFor(const IndexedMesh& shape, const PartingPlane& plane);

    /// The search for the `count` best planes, as the request limits draft, tilt and directions.
    [[nodiscard]] PlaneSearch planeSearch(int count) const;

    [[nodiscard]] const FrameSink& frames() const { return m_frames; }
    [[nodiscard]] bool watched() const { return static_cast<bool>(m_frames); }
    /// Shows a shape (part frame) to whoever watches; `labels` empty while it is not split.
    void show(const char* stage, IndexedMesh shape, const SideLabels& labels, const MoldState& state);

    [[nodiscard]] static std::unexpected<Error> cancelled();

private:
    const DesignRequest& m_request;
    Task m_task;
    const FrameSink& m_frames;
    std::map<std::string, double> m_seconds;
    int m_step = 0;
};

} // namespace moldwright
