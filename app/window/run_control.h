// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "design/design.h"

#include <condition_variable>
#include <mutex>
#include <optional>

namespace moldwright {

/// What the user asks of a running design: to rest, to go on, to finish, to heed other settings. Asked on the
/// interface's thread, heeded by the run on its own after every step.
class RunControl {
public:
    void rest();
    void goOn();
    /// Lets a resting run do one step.
    void stepOnce();
    /// Ends the bending where it is; a resting run goes on with the finish.
    void finish();
    [[nodiscard]] bool resting() const;
    /// What is to hold from the next step on; a run that has not taken the one before sees this one only.
    void post(const LiveSettings& settings);

    /// For the run: comes back at once, or when it is to go on, to finish, or to stop.
    void waitWhileResting(const Task& task);
    /// For the run: true once after each finish().
    [[nodiscard]] bool takeFinish();
    /// For the run: what was posted since it asked last.
    [[nodiscard]] std::optional<LiveSettings> takeNewest();

private:
    mutable std::mutex m_mutex;
    std::condition_variable m_change;
    bool m_resting = false;
    bool m_finish = false;
    bool m_stepOnce = false;
    std::optional<LiveSettings> m_newest;
};

} // namespace moldwright
