// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/task.h"

#include <algorithm>

namespace moldwright {

bool Task::stopped() const {
    if (m_state->cancelled)
        return true;
    return m_state->deadline && std::chrono::steady_clock::now() >= *m_state->deadline;
}

void Task::progress(double fraction, const std::string& stage) const {
    if (m_state->report)
        m_state->report(m_from + (m_to - m_from) * std::clamp(fraction, 0.0, 1.0), stage);
}

Task Task::part(double from, double to) const {
    Task narrowed = *this;
    narrowed.m_from = m_from + (m_to - m_from) * from;
    narrowed.m_to = m_from + (m_to - m_from) * to;
    return narrowed;
}

} // namespace moldwright
