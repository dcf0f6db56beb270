// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "pins/suggested_pins.h"
#include "window/newest_job.h"

#include <QObject>

#include <memory>

namespace moldwright {

/// Suggested pins of a part, to be ranked at a plane.
struct RankRequest {
    std::shared_ptr<const PinSuggestions> pins;
    SharedMesh part;
    MoldState state;
    double draftDegrees = 1;

    bool operator==(const RankRequest&) const = default;
};

/// Ranks suggested pins anew as the plane moves, on a thread of its own. Only the newest request waits.
class LiveRanks : public QObject {
    Q_OBJECT
public:
    explicit LiveRanks(QObject* parent = nullptr);

    void ask(const RankRequest& request) { m_job.ask(request); }

Q_SIGNALS:
    /// The pins of `request` with the ranks they have there.
    void answered(const moldwright::RankRequest& request,
                  const std::shared_ptr<const moldwright::PinSuggestions>& ranked);

private:
    NewestJob<RankRequest> m_job;
};

} // namespace moldwright
