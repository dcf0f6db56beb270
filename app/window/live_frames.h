// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/frame_stream.h"
#include "window/newest_job.h"

#include <QObject>

namespace moldwright {

/// Makes frames that are gone back to ready to be shown, on a thread of its own. Only the newest request
/// waits.
class LiveFrames : public QObject {
    Q_OBJECT
public:
    explicit LiveFrames(QObject* parent = nullptr);

    /// `number` tells the answer apart from those to earlier requests.
    void ask(int number, const DesignFrame& frame, bool withPicker) {
        m_job.ask({number, frame, withPicker});
    }

Q_SIGNALS:
    void answered(int number, const moldwright::ShownFrame& frame);

private:
    struct Request {
        int number;
        DesignFrame frame;
        bool withPicker;
    };
    NewestJob<Request> m_job;
};

} // namespace moldwright
