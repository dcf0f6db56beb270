// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_frames.h"

namespace moldwright {

LiveFrames::LiveFrames(QObject* parent)
    : QObject(parent), m_job(QStringLiteral("frames"), [this](const Request& request) {
          QMetaObject::invokeMethod(
              this, [this, number = request.number, shown = shownFrame(request.frame, request.withPicker)] {
                  Q_EMIT answered(number, shown);
              });
      }) {}

} // namespace moldwright
