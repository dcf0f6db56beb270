// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/surface_picker.h"
#include "window/measurement.h"

#include <QObject>
#include <QPointer>

#include <optional>

class QLabel;

namespace moldwright {

class ViewPane;
class Workbench;

/// The measuring tool: takes places from the views, and tells what it is like under the pointer.
class MeasureTool : public QObject {
    Q_OBJECT
public:
    explicit MeasureTool(Workbench& bench, QObject* parent = nullptr);

    [[nodiscard]] bool active() const { return m_active; }
    /// Leaving it forgets what was measured.
    void setActive(bool active);
    /// Listens to a view.
    void serve(ViewPane& pane);

    [[nodiscard]] const Measurement& measurement() const { return m_measurement; }
    void copy() const;

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] std::optional<MeasuredPoint> pointAt(const ViewPane& pane,
                                                       const scene::SurfacePicker::Hit& hit);
    void take(const ViewPane& pane, const scene::SurfacePicker::Hit& hit);
    void hover(ViewPane& pane, const std::optional<scene::SurfacePicker::Hit>& hit);

    Workbench& m_bench;
    Measurement m_measurement;
    QPointer<QLabel> m_reading; ///< beside the pointer, in the view it is over
    bool m_active = false;
};

} // namespace moldwright
