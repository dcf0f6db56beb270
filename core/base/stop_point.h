// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"

#include <cstddef>
#include <optional>
#include <type_traits>

namespace moldwright {

/// Thrown by stopPoint() alone, caught by unlessStopped() alone. It is no std::exception, so that nobody on
/// the way takes it for a failure of their own.
struct WorkStopped {};

/// While this lives, what its thread does, and what parallel loops do for it, is work on a task. Scopes nest;
/// nothing has to be passed down to the loops that ask.
class StopScope {
public:
    /// The task must outlive this; null: nobody can stop the work.
    explicit StopScope(const Task* task);
    ~StopScope();
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

    /// The task that the calling thread works on, or null.
    [[nodiscard]] static const Task* current();

private:
    const Task* m_before;
};

/// Throws WorkStopped once the task that the thread works on is stopped. Long loops that take no Task ask at
/// least every 50 ms; parallel loops do at each block.
void stopPoint();

/// The same at every 1024th step of a loop.
inline void stopPointAt(std::ptrdiff_t step) {
    if (step % 1024 == 0)
        stopPoint();
}

/// What `work` returns, or nothing once the task was stopped: the work is left where it was, all it owns is
/// given back.
template <class Work>
[[nodiscard]] auto unlessStopped(const Task& task, Work&& work) -> std::optional<std::invoke_result_t<Work>> {
    try {
        const StopScope scope(&task);
        return work();
    } catch (const WorkStopped&) {
        return std::nullopt;
    }
}

} // namespace moldwright
