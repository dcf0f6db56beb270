// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_origins.h"

namespace moldwright {

LiveOrigins::LiveOrigins(QObject* parent)
    : QObject(parent), m_job(QStringLiteral("origins"), [this](const OriginsRequest& request) {
          auto made = std::make_shared<const FaceOrigins>(request.part, request.shape, request.before);
          QMetaObject::invokeMethod(this, [this, made = std::move(made)] {
              m_newest = made;
              Q_EMIT answered();
          });
      }) {}

std::shared_ptr<const FaceOrigins> LiveOrigins::of(const OriginsRequest& request) {
    // Frames of one run differ by where their points are: their origins are the same.
    if (m_newest && m_newest->areOf(request.part, *request.shape, *request.before))
        return m_newest;
    if (request.shape != m_asked) {
        m_asked = request.shape;
        m_job.ask(request);
    }
    return nullptr;
}

} // namespace moldwright
