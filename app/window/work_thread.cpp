// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/work_thread.h"

namespace moldwright {

WorkThread::WorkThread(const QString& name) {
    m_thread.setObjectName(name);
    m_place.moveToThread(&m_thread);
    m_thread.start();
}

WorkThread::~WorkThread() {
    m_thread.quit();
    m_thread.wait();
}

} // namespace moldwright
