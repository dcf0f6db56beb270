// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_frames.h"

namespace moldwright {

LiveFrames::LiveFrames(QObject* parent) : QObject(parent), m_thread(QStringLiteral("frames")) {}

LiveFrames::~LiveFrames() {
    (void)m_waiting.take();
}

void LiveFrames::ask(int number, const DesignFrame& frame, bool withPicker) {
    m_waiting.put({number, frame, withPicker});
    m_thread.post([this] { work(); });
}

void LiveFrames::work() {
    const std::optional<Request> request = m_waiting.take();
    if (!request)
        return; // a newer one took the place of the one that woke this
    QMetaObject::invokeMethod(
        this, [this, number = request->number, shown = shownFrame(request->frame, request->withPicker)] {
            Q_EMIT answered(number, shown);
        });
}

} // namespace moldwright
