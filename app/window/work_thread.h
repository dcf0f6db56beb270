// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThread>

#include <utility>

namespace moldwright {

/// A thread that does what is posted to it, one after the other, and gives way to the window. What was begun
/// when it is destroyed is ended first, what only waits may be dropped: an owner declares it last, so that
/// its work finds all else alive.
class WorkThread {
public:
    /// `name` tells threads apart in a debugger.
    explicit WorkThread(const QString& name);
    ~WorkThread();
    WorkThread(const WorkThread&) = delete;
    WorkThread& operator=(const WorkThread&) = delete;

    template <class Work>
    void post(Work&& work) {
        QMetaObject::invokeMethod(&m_place, std::forward<Work>(work));
    }

private:
    QThread m_thread;
    QObject m_place; ///< lives on the thread
};

} // namespace moldwright
