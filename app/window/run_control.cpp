// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/run_control.h"

#include <utility>

namespace moldwright {

void RunControl::rest() {
    const std::lock_guard lock(m_mutex);
    m_resting = true;
}

void RunControl::goOn() {
    const std::lock_guard lock(m_mutex);
    m_resting = false;
    m_change.notify_all();
}

void RunControl::stepOnce() {
    const std::lock_guard lock(m_mutex);
    m_stepOnce = m_resting;
    m_change.notify_all();
}

void RunControl::finish() {
    const std::lock_guard lock(m_mutex);
    m_finish = true;
    m_resting = false;
    m_change.notify_all();
}

bool RunControl::resting() const {
    const std::lock_guard lock(m_mutex);
    return m_resting;
}

void RunControl::waitWhileResting(const Task& task) {
    std::unique_lock lock(m_mutex);
    // A task that is cancelled wakes nobody: it is asked now and then.
    while (m_resting && !m_stepOnce && !task.stopped())
        m_change.wait_for(lock, std::chrono::milliseconds(50));
    m_stepOnce = false;
}

void RunControl::post(const LiveSettings& settings) {
    const std::lock_guard lock(m_mutex);
    m_newest = settings;
}

std::optional<LiveSettings> RunControl::takeNewest() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_newest, std::nullopt);
}

bool RunControl::takeFinish() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_finish, false);
}

} // namespace moldwright
