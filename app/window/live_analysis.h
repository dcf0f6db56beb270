// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "castability/certificate.h"
#include "mesh/indexed_mesh.h"
#include "scene/surface_picker.h"

#include <QObject>
#include <QThread>

#include <memory>
#include <mutex>
#include <optional>

namespace moldwright {

/// What is to be analysed: a surface in a mold state; with labels, also whether it is proved.
struct AnalysisRequest {
    SharedMesh mesh;
    std::optional<MoldState> state;
    double draftDegrees = 1;
    SideLabels labels; ///< empty: no proof asked for
};

/// What was found, and for what.
struct AnalysisAnswer {
    AnalysisRequest request;
    DraftAnalysis analysis; ///< empty without a state
    std::optional<Certificate> certificate;
    std::shared_ptr<const scene::SurfacePicker> picker;
    SharedMesh standIn; ///< coarser, to be drawn while something moves; null for a small mesh
    DraftAnalysis standInAnalysis;
};

/// Keeps draft analysis, proof and picking up with the project, on a thread of its own. While it computes,
/// only the newest request waits; older ones are dropped.
class LiveAnalysis : public QObject {
    Q_OBJECT
public:
    explicit LiveAnalysis(QObject* parent = nullptr);
    ~LiveAnalysis() override;

    void ask(const AnalysisRequest& request);

Q_SIGNALS:
    void answered(const std::shared_ptr<const moldwright::AnalysisAnswer>& answer);

private:
    void work();

    QThread m_thread;
    QObject m_place; ///< lives on the thread
    std::mutex m_mutex;
    std::optional<AnalysisRequest> m_waiting;
    std::shared_ptr<const scene::SurfacePicker> m_picker;
    SharedMesh m_standIn; ///< of the picker's mesh
};

} // namespace moldwright
