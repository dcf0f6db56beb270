// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_ranks.h"

#include <utility>

namespace moldwright {

LiveRanks::LiveRanks(QObject* parent) : QObject(parent), m_thread(QStringLiteral("ranks")) {}

LiveRanks::~LiveRanks() {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.reset();
    }
}

void LiveRanks::ask(const RankRequest& request) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = request;
    }
    m_thread.post([this] { work(); });
}

void LiveRanks::work() {
    std::optional<RankRequest> request;
    {
        const std::lock_guard lock(m_mutex);
        request = std::exchange(m_waiting, std::nullopt);
    }
    if (!request)
        return; // a newer one took the place of the one that woke this
    PinSuggestions ranked = *request->pins;
    rankPins(ranked, *request->part, request->state, request->draftDegrees);
    const auto shared = std::make_shared<const PinSuggestions>(std::move(ranked));
    QMetaObject::invokeMethod(this, [this, request, shared] { Q_EMIT answered(*request, shared); });
}

} // namespace moldwright
