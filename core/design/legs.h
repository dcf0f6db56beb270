// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "design/design.h"
#include "design/design_run.h"

#include <atomic>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>

namespace moldwright {

/// The legs of one design, each from where the one before it was left. Where the request lets it, a leg goes
/// on beside its successor until that has something to show; each runs on a thread of its own, and their
/// frames come one at a time.
class Legs {
public:
    using RunLeg = std::function<Result<DesignResult>(DesignRun&)>;

    /// `request`, `task` and `frames` outlive it.
    Legs(const DesignRequest& request, const Task& task, const FrameSink& frames, RunLeg runLeg);
    Legs(const Legs&) = delete;
    Legs& operator=(const Legs&) = delete;

    /// Runs them all. The last one's result, with the seconds and steps of all.
    [[nodiscard]] Result<DesignResult> run();

private:
    struct Leg {
        DesignRun run;
        std::shared_ptr<const Points> points; ///< the part's, where it begins; null: as they are
        bool begunAnew = false; ///< with the part, because the shape reached could not be parted
        std::future<Result<DesignResult>> result = {};
    };

    void begin(const DesignRequest& request, const std::shared_ptr<const Points>& points);
    /// Begins the successor of a leg that has heard something that bending cannot take as it goes.
    void follow(std::size_t leg, const DesignRun& run);
    [[nodiscard]] DesignRun runOf(std::size_t leg, const DesignRequest& request,
                                  const std::shared_ptr<const Points>& points);
    [[nodiscard]] Result<DesignResult> runToItsEnd(std::size_t number);
    void show(std::size_t leg, const DesignFrame& frame);
    /// The legs before this one are over.
    void takeOver(std::size_t leg);
    [[nodiscard]] Result<DesignResult> finished(Result<DesignResult> result);
    [[nodiscard]] Leg& at(std::size_t leg);
    [[nodiscard]] bool isLast(std::size_t leg);

    const DesignRequest& m_request;
    const Task& m_task;
    const FrameSink& m_frames;
    const RunLeg m_runLeg;
    std::mutex m_legsMutex;
    std::deque<Leg> m_legs;                ///< deque: a leg stays where it is while others begin
    std::atomic<std::size_t> m_inView = 0; ///< the newest leg that has something to show
    std::mutex m_viewMutex;
    int m_steps = 0;
};

} // namespace moldwright
