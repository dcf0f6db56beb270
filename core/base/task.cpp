// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/task.h"

#include <algorithm>
#include <utility>

namespace moldwright {

bool Task::State::stopped() const {
    if (cancelled || (whole && whole->stopped()))
        return true;
    return deadline && std::chrono::steady_clock::now() >= *deadline;
}

bool Task::stopped() const {
    return m_state->stopped();
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

Task Task::leg(Report report) const {
    Task own(std::move(report));
    own.m_state->whole = m_state;
    return own;
}

} // namespace moldwright
