// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_origins.h"

namespace moldwright {

LiveOrigins::LiveOrigins(QObject* parent) : QObject(parent), m_thread(QStringLiteral("origins")) {}

LiveOrigins::~LiveOrigins() {
    (void)m_waiting.take();
}

std::shared_ptr<const FaceOrigins> LiveOrigins::of(const OriginsRequest& request) {
    // Frames of one run differ by where their points are: their origins are the same.
    if (m_newest && m_newest->areOf(request.part, *request.shape, *request.before))
        return m_newest;
    if (request.shape != m_asked) {
        m_asked = request.shape;
        m_waiting.put(request);
        m_thread.post([this] { work(); });
    }
    return nullptr;
}

void LiveOrigins::work() {
    const std::optional<OriginsRequest> request = m_waiting.take();
    if (!request)
        return; // a newer one took the place of the one that woke this
    auto made = std::make_shared<const FaceOrigins>(request->part, request->shape, request->before);
    QMetaObject::invokeMethod(this, [this, made = std::move(made)] {
        m_newest = made;
        Q_EMIT answered();
    });
}

} // namespace moldwright
