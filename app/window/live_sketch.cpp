// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_sketch.h"

namespace moldwright {

LiveSketch::LiveSketch(QObject* parent)
    : QObject(parent), m_job(QStringLiteral("sketch"), [this](const SketchRequest& request) {
          const auto answer = std::make_shared<const SketchAnswer>(request, sketch(request));
          QMetaObject::invokeMethod(this, [this, answer] { Q_EMIT answered(answer); });
      }) {}

Result<MoldSketch> LiveSketch::sketch(const SketchRequest& request) {
    if (request.tray != m_tray || !m_sketcher || !m_sketcher->serves(request.settings)) {
        m_sketcher.reset();
        m_tray = request.tray;
        Result<MoldSketcher> prepared =
            MoldSketcher::prepared(request.tray, request.draftDegrees, request.settings);
        if (!prepared)
            return std::unexpected(prepared.error());
        m_sketcher.emplace(*std::move(prepared));
    }
    return m_sketcher->sketch(request.settings.placed);
}

} // namespace moldwright
