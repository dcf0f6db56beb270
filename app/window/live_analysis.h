// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "castability/certificate.h"
#include "mesh/indexed_mesh.h"
#include "scene/drawn_mesh.h"
#include "scene/surface_picker.h"
#include "window/work_thread.h"

#include <QObject>

#include <condition_variable>
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
    scene::SharedDrawnMesh drawn;
    std::shared_ptr<const scene::SurfacePicker> picker; ///< null until it is made
    /// Of a large mesh the stand-in comes first: `analysis` is then the stand-in's, there is no proof yet,
    /// and another answer follows unless something newer is asked.
    bool coarse = false;
    DraftAnalysis analysis; ///< empty without a state
    DraftAnalysis standInAnalysis;
    std::optional<Certificate> certificate;
};

/// Keeps the drawn surface, draft analysis, proof and picking up with the project, on a thread of its own.
/// While it computes, only the newest request waits; older ones are dropped.
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
    /// Waits a moment for it; also true when it is time to end.
    [[nodiscard]] bool somethingNewer();
    void answer(AnalysisAnswer answer);

    std::mutex m_mutex;
    std::condition_variable m_asked;
    std::optional<AnalysisRequest> m_waiting;
    bool m_ending = false;
    scene::SharedDrawnMesh m_drawn;
    std::shared_ptr<const scene::SurfacePicker> m_picker; ///< of the mesh drawn
    WorkThread m_thread;
};

} // namespace moldwright
