// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/work_thread.h"

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace moldwright {

namespace {

/// The window, and what draws its pictures, come first where processors are few. Threads that are begun by
/// this one follow it.
void giveWay() {
#ifdef Q_OS_LINUX
    constexpr int politeness = 5;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), politeness);
#endif
}

} // namespace

WorkThread::WorkThread(const QString& name) {
    m_thread.setObjectName(name);
    m_place.moveToThread(&m_thread);
    m_thread.start();
    post([] { giveWay(); });
}

WorkThread::~WorkThread() {
    m_thread.quit();
    m_thread.wait();
}

} // namespace moldwright
