// SPDX-License-Identifier: AGPL-3.0-or-later
// What becomes of a run: the cast, what stood in its way, and what to do next.
#include "window/workbench.h"

#include "project/design_request.h"
#include "project/edits.h"
#include "window/obstruction_words.h"
#include "window/sentence.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

Eigen::AlignedBox3d boxOf(const Obstruction& obstruction) {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(std::max(obstruction.size, 1.0) / 2);
    return {obstruction.place - half, obstruction.place + half};
}

} // namespace

const std::vector<Obstruction>& Workbench::obstructions() const {
    static const std::vector<Obstruction> none;
    const bool still = m_obstructedPart && project().part == m_obstructedPart && !project().cast &&
                       project().state == m_obstructedState;
    return still ? m_obstructions : none;
}

Eigen::AlignedBox3d Workbench::placeOf(int obstruction) const {
    return boxOf(obstructions().at(static_cast<std::size_t>(obstruction)));
}

void Workbench::takeResult(const Result<DesignResult>& result, const Project& from) {
    pullFrames();
    m_frameTimer.stop();
    m_stream.reset();
    if (m_branch) {
        // The Background is busy until this returns.
        QMetaObject::invokeMethod(this, &Workbench::goOnFromHere, Qt::QueuedConnection);
        return;
    }
    m_frame.reset();
    m_backTo = 0;
    if (!result) {
        complain(result.error(), tr("Deforming"));
        Q_EMIT changed();
        return;
    }
    for (const Message& warning : result->warnings)
        say(Standing::Warning, sentence(warning));
    if (result->cast)
        takeCast(*result, from);
    else if (result->cutShort)
        say(Standing::Info, tr("The run was stopped before it had a shape. The part is as it was."));
    else
        takeObstructions(*result, from);
    Q_EMIT changed();
}

void Workbench::takeCast(const DesignResult& result, const Project& from) {
    const Project& now = m_document.committed();
    const bool unfinished = result.cutShort && !result.castable;
    if (sameButLive(from, now) && liveSettings(now) == result.settings) {
        Project after = withCast(now, result, result.settings.draftDegrees);
        after.planeChosenByHand = now.planeChosenByHand || unfinished; // the next run need not search again
        m_document.edit(unfinished ? tr("Deform, stopped") : tr("Deform"), after);
    } else {
        takeLateCast(result, from);
        return;
    }
    if (result.castable)
        tellOfCast(result);
    else if (unfinished)
        tellOfStop(result);
    else
        say(Standing::Failing, tr("Not castable yet: %1").arg(sentence(result.certificate.reason)));
}

/// The cast belongs to what the run took up; what was changed too late for it comes after, as a step of its
/// own, so that nothing is lost.
void Workbench::takeLateCast(const DesignResult& result, const Project& from) {
    const Project now = m_document.committed();
    m_document.edit(tr("Deform"),
                    withCast(withLiveSettings(from, result.settings), result, result.settings.draftDegrees));
    m_document.edit(tr("Changed during the run"), now);
    const QString headline = tr("The run has ended without the last changes.");
    const QString text = tr("Run bends the part with them; Undo brings back the cast without them.");
    say(Standing::Warning, headline + u' ' + text);
    Q_EMIT advised({Standing::Warning, headline, text, QStringLiteral("run")});
}

void Workbench::tellOfCast(const DesignResult& result) {
    if (result.change.filledVolumeFraction > 0)
        say(Standing::Info, tr("Filled: %1 % of the part's volume, at places that no bending frees.")
                                .arg(100 * result.change.filledVolumeFraction, 0, 'f', 1));
    for (const Obstruction& obstruction : result.obstructions)
        say(Standing::Info,
            tr("%1 of %2 on side %3: filled.")
                .arg(kindName(obstruction.kind), sizeText(obstruction))
                .arg(obstruction.side),
            boxOf(obstruction));
    if (!result.pins.empty()) {
        const auto farthest = std::ranges::max_element(result.pins, {}, &PinnedPoint::distanceFromPlane);
        say(Standing::Info, tr("Pins: %1, at most %2 mm from the plane.")
                                .arg(result.pins.size())
                                .arg(farthest->distanceFromPlane, 0, 'f', 3));
    }
    tellOfRegions();
    say(Standing::Done, tr("Castable: proved at %1°, mean distance to the part %2 % of its diagonal.")
                            .arg(std::floor(10 * result.certificate.worstDraftDegrees) / 10, 0, 'f', 1)
                            .arg(100 * result.change.meanDistance, 0, 'f', 2));
}

void Workbench::tellOfStop(const DesignResult& result) {
    const QString headline = tr("The run was stopped. What it reached is kept, and not castable yet.");
    const QString text =
        tr("%1 % of the surface is below %2°. Run bends the part again, at the plane it had; "
           "Undo brings back what was before.")
            .arg(100 * result.violatingAreaFraction, 0, 'f', 1)
            .arg(project().design.draftDegrees, 0, 'f', 1);
    say(Standing::Warning, headline + u' ' + text);
    Q_EMIT advised({Standing::Warning, headline, text, QStringLiteral("run")});
}

void Workbench::takeObstructions(const DesignResult& result, const Project& from) {
    // They are those of this plane: it is shown with them.
    const Project& now = m_document.committed();
    m_document.edit(tr("Plane of the run"), withState(now, result.state, now.planeChosenByHand));
    m_obstructions = result.obstructions;
    m_obstructedPart = from.part;
    m_obstructedState = result.state;
    for (const Obstruction& obstruction : m_obstructions)
        say(Standing::Failing, sentence(obstruction.message), boxOf(obstruction));
    if (m_obstructions.empty()) {
        say(Standing::Failing, tr("Not castable yet: %1").arg(sentence(result.certificate.reason)));
        return;
    }
    const std::size_t count = m_obstructions.size();
    Q_EMIT advised(
        {Standing::Failing,
         count == 1 ? tr("At this plane one place stands in the way, however the part is bent.")
                    : tr("At this plane %1 places stand in the way, however the part is bent.").arg(count),
         sentence(m_obstructions.front().message), remedyFor(m_obstructions.front())});
    Q_EMIT obstructed();
}

} // namespace moldwright
