// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"

#include <condition_variable>
#include <mutex>

namespace moldwright {

/// What the user asks of a running design: to rest, to go on, to finish. Asked on the interface's thread,
/// heeded by the run on its own after every step.
class RunControl {
public:
    void rest();
    void goOn();
    /// Ends the bending where it is; a resting run goes on with the finish.
    void finish();
    [[nodiscard]] bool resting() const;

    /// For the run: comes back at once, or when it is to go on, to finish, or to stop.
    void waitWhileResting(const Task& task);
    /// For the run: true once after each finish().
    [[nodiscard]] bool takeFinish();

private:
    mutable std::mutex m_mutex;
    std::condition_variable m_change;
    bool m_resting = false;
    bool m_finish = false;
};

} // namespace moldwright
