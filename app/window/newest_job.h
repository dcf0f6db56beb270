// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/latest.h"
#include "window/work_thread.h"

#include <functional>
#include <optional>
#include <utility>

namespace moldwright {

/// Does one thing for requests, on a thread of its own. Only the newest request waits; what is being done
/// when it is destroyed is ended first. An owner declares it last, so that its work finds all else alive.
template <class Request>
class NewestJob {
public:
    /// `work` is called on the thread; `name` tells threads apart in a debugger.
    NewestJob(const QString& name, std::function<void(const Request&)> work)
        : m_work(std::move(work)), m_thread(name) {}
    ~NewestJob() { (void)m_waiting.take(); }
    NewestJob(const NewestJob&) = delete;
    NewestJob& operator=(const NewestJob&) = delete;

    void ask(Request request) {
        m_waiting.put(std::move(request));
        m_thread.post([this] {
            // None where a newer one took the place of the one that woke this.
            if (const std::optional<Request> newest = m_waiting.take())
                m_work(*newest);
        });
    }

private:
    std::function<void(const Request&)> m_work;
    Latest<Request> m_waiting;
    WorkThread m_thread;
};

} // namespace moldwright
