// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_analysis.h"

#include "castability/cast_analysis.h"

#include <utility>

namespace moldwright {

namespace {

constexpr std::chrono::milliseconds quiet(120);

} // namespace

LiveAnalysis::LiveAnalysis(QObject* parent) : QObject(parent), m_thread(QStringLiteral("analysis")) {}

LiveAnalysis::~LiveAnalysis() {
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_asked.notify_all();
}

void LiveAnalysis::ask(const AnalysisRequest& request) {
    const std::lock_guard lock(m_mutex);
    const bool asleep = !m_waiting;
    m_waiting = request;
    m_asked.notify_all();
    if (asleep)
        m_thread.post([this] { work(); });
}

bool LiveAnalysis::somethingNewer() {
    std::unique_lock lock(m_mutex);
    // In the middle of a drag the next request is near, and the view wants the processor.
    return m_asked.wait_for(lock, quiet, [this] { return m_waiting || m_ending; });
}

void LiveAnalysis::answer(AnalysisAnswer answer) {
    auto shared = std::make_shared<const AnalysisAnswer>(std::move(answer));
    QMetaObject::invokeMethod(this, [this, shared] { Q_EMIT answered(shared); });
}

void LiveAnalysis::work() {
    std::optional<AnalysisRequest> request;
    {
        const std::lock_guard lock(m_mutex);
        request.swap(m_waiting);
    }
    if (!request)
        return;
    if (!m_drawn || m_drawn->mesh != request->mesh) {
        m_drawn = scene::sketchedMesh(request->mesh);
        m_picker.reset();
    }
    AnalysisAnswer found{*request, m_drawn, m_picker, false, {}, {}, {}};
    if (m_drawn->standIn) {
        if (request->state)
            found.standInAnalysis =
                analyzeDraft(*m_drawn->standIn->mesh, *request->state, request->draftDegrees, false);
        AnalysisAnswer first = found;
        first.coarse = true;
        first.analysis = found.standInAnalysis;
        answer(std::move(first));
        if (somethingNewer())
            return;
    }
    m_drawn = scene::completed(m_drawn);
    if (!m_picker)
        m_picker = std::make_shared<scene::SurfacePicker>(request->mesh);
    found.drawn = m_drawn;
    found.picker = m_picker;
    if (request->state && !request->labels.empty()) {
        found.certificate = certify(*request->mesh, request->labels, *request->state, request->draftDegrees);
        found.analysis = analyzeCast(*request->mesh, request->labels, *request->state, request->draftDegrees,
                                     *found.certificate);
    } else if (request->state) {
        found.analysis = analyzeDraft(*request->mesh, *request->state, request->draftDegrees, false);
    }
    answer(std::move(found));
}

} // namespace moldwright
