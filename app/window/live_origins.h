// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/face_origins.h"
#include "window/newest_job.h"

#include <QObject>

#include <memory>

namespace moldwright {

/// A shape made from a part, and where its points were.
struct OriginsRequest {
    SharedMesh part;
    SharedMesh shape;
    std::shared_ptr<const Points> before; ///< n×3, mm
};

/// Finds where the faces of casts and frames were on the part, on a thread of its own. Only the newest
/// request waits.
class LiveOrigins : public QObject {
    Q_OBJECT
public:
    explicit LiveOrigins(QObject* parent = nullptr);

    /// Those of a shape; null while they are being made, for which this asks.
    [[nodiscard]] std::shared_ptr<const FaceOrigins> of(const OriginsRequest& request);

Q_SIGNALS:
    void answered();

private:
    SharedMesh m_asked; ///< the shape of the last request
    std::shared_ptr<const FaceOrigins> m_newest;
    NewestJob<OriginsRequest> m_job;
};

} // namespace moldwright
