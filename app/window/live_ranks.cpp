// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_ranks.h"

namespace moldwright {

LiveRanks::LiveRanks(QObject* parent)
    : QObject(parent), m_job(QStringLiteral("ranks"), [this](const RankRequest& request) {
          PinSuggestions ranked = *request.pins;
          rankPins(ranked, *request.part, request.state, request.draftDegrees);
          const auto shared = std::make_shared<const PinSuggestions>(std::move(ranked));
          QMetaObject::invokeMethod(this, [this, request, shared] { Q_EMIT answered(request, shared); });
      }) {}

} // namespace moldwright
