// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_ranks.h"

namespace moldwright {

LiveRanks::LiveRanks(QObject* parent) : QObject(parent), m_thread(QStringLiteral("ranks")) {}

LiveRanks::~LiveRanks() {
    (void)m_waiting.take();
}

void LiveRanks::ask(const RankRequest& request) {
    m_waiting.put(request);
    m_thread.post([this] { work(); });
}

void LiveRanks::work() {
    const std::optional<RankRequest> request = m_waiting.take();
    if (!request)
        return; // a newer one took the place of the one that woke this
    PinSuggestions ranked = *request->pins;
    rankPins(ranked, *request->part, request->state, request->draftDegrees);
    const auto shared = std::make_shared<const PinSuggestions>(std::move(ranked));
    QMetaObject::invokeMethod(this, [this, request, shared] { Q_EMIT answered(*request, shared); });
}

} // namespace moldwright
