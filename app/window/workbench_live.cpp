// SPDX-License-Identifier: AGPL-3.0-or-later
// What the designer changes while a design runs.
#include "window/workbench.h"

#include "design/carried_pins.h"
#include "project/design_request.h"
#include "project/edits.h"

#include <utility>

namespace moldwright {

namespace {

/// The part as a frame has it; null where filling changed it.
std::shared_ptr<const IndexedMesh> partIn(const DesignFrame& frame, const SharedMesh& part) {
    if (!frame.partPoints || frame.partPoints->rows() != part->V.rows())
        return nullptr;
    return std::make_shared<const IndexedMesh>(IndexedMesh{*frame.partPoints, part->F});
}

} // namespace

Project Workbench::projectInView() const {
    Project project = m_document.committed();
    if (m_frame)
        project.state = shownState();
    return project;
}

void Workbench::postLive() {
    if (!running())
        return;
    const Project& now = m_document.committed();
    const LiveSettings live = liveSettings(now);
    if (!(live == m_posted)) {
        m_control->post(live);
        m_posted = live;
        placePins();
    }
    if (!sameButLive(m_runFrom, now) && !m_toldOfLate)
        say(Standing::Warning, tr("A run cannot take this up while it goes on. The next run does."));
    m_toldOfLate = !sameButLive(m_runFrom, now);
}

void Workbench::placePins() {
    if (!m_frame)
        return;
    const Project& now = m_document.committed();
    const auto bent = partIn(m_frame->frame, now.part);
    m_frame->pins = bent ? carriedPins(liveSettings(now).pins, *now.part, *bent) : std::vector<Pin>();
}

std::vector<Pin> Workbench::pinsInView() const {
    return m_frame ? m_frame->pins : std::vector<Pin>(project().pins.begin(), project().pins.end());
}

void Workbench::setPicking(bool picking) {
    m_picking = picking;
    if (m_stream)
        m_stream->setPickers(picking);
    if (picking && m_frame && !m_frame->picker)
        m_liveFrames.ask(m_frame->frame.step, m_frame->frame, true);
}

void Workbench::stepOnce() {
    showNewest();
    m_control->stepOnce();
}

void Workbench::showNewest() {
    if (m_backTo != 0)
        showKept(static_cast<int>(m_kept.frames().size()) - 1);
}

void Workbench::showKept(int frame) {
    if (running() && !resting())
        m_control->rest();
    const DesignFrame& kept = m_kept.frames().at(static_cast<std::size_t>(frame));
    const bool newest = running() && kept.step == m_kept.frames().back().step;
    m_backTo = newest ? 0 : kept.step;
    m_liveFrames.ask(kept.step, kept, m_picking);
    Q_EMIT changed();
}

void Workbench::takeKept(int step, const ShownFrame& frame) {
    // A run that went on, or an edit, may have left the frames meanwhile.
    const int shown = m_backTo == 0 && resting() ? m_kept.frames().back().step : m_backTo;
    if (step != shown)
        return;
    m_frame = frame;
    placePins();
    Q_EMIT changed();
}

void Workbench::forgetKept() {
    if (project().part != m_keptPart)
        m_kept.clear();
    if (running() || m_backTo == 0)
        return;
    m_backTo = 0;
    m_frame.reset();
}

void Workbench::goOnFromHere() {
    if (!m_branch)
        m_branch = m_frame->frame;
    if (running()) {
        m_background.cancel(); // takeResult() comes back here
        return;
    }
    const DesignFrame from = *std::exchange(m_branch, std::nullopt);
    const Project at = withLiveSettings(m_document.committed(), from.settings);
    m_document.edit(tr("Go on from step %1").arg(from.step), withState(at, from.state, true));
    startRun(from.partPoints);
}

Eigen::Vector3d Workbench::inPart(const Eigen::Vector3d& inView) const {
    const auto bent = m_frame ? partIn(m_frame->frame, project().part) : nullptr;
    return bent ? carriedPins({{inView}}, *bent, *project().part).front().point : inView;
}

} // namespace moldwright
