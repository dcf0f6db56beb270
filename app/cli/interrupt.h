// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"

namespace moldwright::cli {

/// While this lives, Ctrl+C and SIGTERM cancel the task; a second one ends the program at once.
class CancelOnInterrupt {
public:
    explicit CancelOnInterrupt(Task task);
    ~CancelOnInterrupt();
    CancelOnInterrupt(const CancelOnInterrupt&) = delete;
    CancelOnInterrupt& operator=(const CancelOnInterrupt&) = delete;

private:
    Task m_task;
};

} // namespace moldwright::cli
