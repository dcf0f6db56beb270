// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/parallel.h"

#include "base/stop_point.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace moldwright {

namespace {

std::mutex limitMutex;
std::unique_ptr<tbb::global_control> limit;

} // namespace

void setThreadCount(int threads) {
    const std::lock_guard lock(limitMutex);
    limit.reset();
    if (threads > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads));
}

int threadCount() {
    return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body) {
    const std::size_t blocks = (count + grain - 1) / grain;
    const auto run = [&](std::size_t b) {
        stopPoint();
        body(b * grain, std::min(count, (b + 1) * grain));
    };
    if (blocks <= 1 || threadCount() == 1) {
        for (std::size_t b = 0; b < blocks; ++b)
            run(b);
        return;
    }
    const Task* task = StopScope::current();
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
        const StopScope scope(task);
        run(b);
    });
}

void parallelInvoke(const std::vector<std::function<void()>>& tasks) {
    parallelFor(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            tasks[i]();
    });
}

} // namespace moldwright
