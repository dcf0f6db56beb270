// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_analysis.h"

#include "castability/cast_analysis.h"
#include "mesh/cluster.h"

namespace moldwright {

namespace {

constexpr int standInFaces = 25000;
constexpr int largeFaces = 60000; ///< more of them cannot be drawn smoothly everywhere

SharedMesh standInFor(const IndexedMesh& mesh) {
    if (mesh.faceCount() <= largeFaces)
        return nullptr;
    return std::make_shared<const IndexedMesh>(cluster(mesh, standInFaces));
}

} // namespace

LiveAnalysis::LiveAnalysis(QObject* parent) : QObject(parent) {
    m_thread.setObjectName(QStringLiteral("analysis"));
    m_place.moveToThread(&m_thread);
    m_thread.start();
}

LiveAnalysis::~LiveAnalysis() {
    m_thread.quit();
    m_thread.wait();
}

void LiveAnalysis::ask(const AnalysisRequest& request) {
    const std::lock_guard lock(m_mutex);
    const bool asleep = !m_waiting;
    m_waiting = request;
    if (asleep)
        QMetaObject::invokeMethod(&m_place, [this] { work(); });
}

void LiveAnalysis::work() {
    std::optional<AnalysisRequest> request;
    {
        const std::lock_guard lock(m_mutex);
        request.swap(m_waiting);
    }
    if (!request)
        return;
    auto answer = std::make_shared<AnalysisAnswer>();
    answer->request = *request;
    if (request->state && !request->labels.empty()) {
        answer->certificate =
            certify(*request->mesh, request->labels, *request->state, request->draftDegrees);
        answer->analysis = analyzeCast(*request->mesh, request->labels, *request->state,
                                       request->draftDegrees, *answer->certificate);
    } else if (request->state) {
        answer->analysis = analyzeDraft(*request->mesh, *request->state, request->draftDegrees, false);
    }
    if (!m_picker || m_picker->mesh() != request->mesh) {
        m_picker = std::make_shared<scene::SurfacePicker>(request->mesh);
        m_standIn = standInFor(*request->mesh);
    }
    answer->picker = m_picker;
    answer->standIn = m_standIn;
    if (m_standIn && request->state)
        answer->standInAnalysis = analyzeDraft(*m_standIn, *request->state, request->draftDegrees, false);
    QMetaObject::invokeMethod(this, [this, answer] { Q_EMIT answered(answer); });
}

} // namespace moldwright
