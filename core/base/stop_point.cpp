// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/stop_point.h"

namespace moldwright {

namespace {

thread_local const Task* working = nullptr;

} // namespace

StopScope::StopScope(const Task* task) : m_before(working) {
    working = task;
}

StopScope::~StopScope() {
    working = m_before;
}

const Task* StopScope::current() {
    return working;
}

void stopPoint() {
    if (working != nullptr && working->stopped())
        throw WorkStopped{};
}

} // namespace moldwright
