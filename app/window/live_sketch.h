// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold_sketch.h"
#include "project/project.h"
#include "window/newest_job.h"

#include <QObject>

#include <memory>
#include <optional>

namespace moldwright {

/// The mold of a tray with these settings, to be sketched.
struct SketchRequest {
    Tray tray; ///< empty: nothing was asked yet
    double draftDegrees = 1;
    MoldSettings settings;

    bool operator==(const SketchRequest&) const = default;
};

struct SketchAnswer {
    SketchRequest request;
    Result<MoldSketch> sketch;
};

/// Says where a mold's features would stand while they are moved, on a thread of its own; what does not
/// follow from their places is prepared once. Only the newest request waits.
class LiveSketch : public QObject {
    Q_OBJECT
public:
    explicit LiveSketch(QObject* parent = nullptr);

    void ask(const SketchRequest& request) { m_job.ask(request); }

Q_SIGNALS:
    void answered(const std::shared_ptr<const moldwright::SketchAnswer>& answer);

private:
    [[nodiscard]] Result<MoldSketch> sketch(const SketchRequest& request);

    Tray m_tray; ///< of m_sketcher
    std::optional<MoldSketcher> m_sketcher;
    NewestJob<SketchRequest> m_job;
};

} // namespace moldwright
