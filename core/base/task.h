// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace moldwright {

/// Progress, cancellation and time limit of one long operation; a cheap handle that is passed by value.
/// `part` narrows the progress range so that a sub-task need not know its place in the whole.
/// Thread-safe: any thread may cancel; reports may come from any one thread at a time.
class Task {
public:
    /// Called with the fraction done in [0, 1] and an English name of the current stage.
    using Report = std::function<void(double fraction, const std::string& stage)>;

    /// A task that nobody watches and nobody cancels.
    Task() : Task(Report{}) {}
    explicit Task(Report report) : m_state(std::make_shared<State>()) { m_state->report = std::move(report); }

    void cancel() const { m_state->cancelled = true; }
    void setDeadline(std::chrono::steady_clock::time_point end) const { m_state->deadline = end; }

    /// True once cancelled or past the deadline. Long loops ask at least every 100 ms.
    [[nodiscard]] bool stopped() const;

    /// Reports progress within this task's range.
    void progress(double fraction, const std::string& stage) const;

    /// The sub-range [from, to] of this task's range, as a task of its own.
    [[nodiscard]] Task part(double from, double to) const;

    /// A task that can be cancelled without this one and is stopped when this one is; it reports over the
    /// range [0, 1] to `report`.
    [[nodiscard]] Task leg(Report report) const;

private:
    struct State {
        Report report;
        std::atomic<bool> cancelled = false;
        std::optional<std::chrono::steady_clock::time_point> deadline;
        std::shared_ptr<const State> whole; ///< of a leg
        [[nodiscard]] bool stopped() const;
    };
    std::shared_ptr<State> m_state;
    double m_from = 0;
    double m_to = 1;
};

} // namespace moldwright
