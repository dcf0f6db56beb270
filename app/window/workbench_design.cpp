// SPDX-License-Identifier: AGPL-3.0-or-later
// Plane, directions, the run that bends the part, and the mold.
#include "window/workbench.h"

#include "castability/directions.h"
#include "mold/way_out.h"
#include "project/design_request.h"
#include "project/edits.h"
#include "project/title.h"
#include "project/variants.h"
#include "theme/theme.h"
#include "window/sentence.h"

namespace moldwright {

void Workbench::findBestPlane() {
    const Project from = m_document.committed();
    const auto work = [=, this, colours = theme().scene](const Task& task) -> Background::Finish {
        const std::vector<OfferedPlane> found = offerPlanes(*from.part, from.design, colours, task);
        const bool stopped = task.stopped();
        return [=, this] {
            if (stopped || found.empty()) {
                say(Standing::Info, tr("The search for planes was stopped."));
                return;
            }
            m_offered = found;
            m_offeredPart = from.part;
            ++m_searchNumber;
            takeOffered(0);
            Q_EMIT planesFound();
        };
    };
    m_background.start(tr("Searching planes"), work);
}

const std::vector<OfferedPlane>& Workbench::offeredPlanes() const {
    static const std::vector<OfferedPlane> none;
    return m_offeredPart && m_offeredPart == project().part ? m_offered : none;
}

int Workbench::offeredPlane() const {
    const auto& offered = offeredPlanes();
    for (std::size_t i = 0; i < offered.size(); ++i)
        if (project().state == offered[i].plane.state)
            return static_cast<int>(i);
    return -1;
}

void Workbench::takeOffered(int plane) {
    const PlaneCandidate& taken = offeredPlanes().at(static_cast<std::size_t>(plane)).plane;
    if (project().state == taken.state && project().planeChosenByHand)
        return;
    setState(taken.state, plane == 0 ? tr("Best plane") : tr("Plane %1 of the search").arg(plane + 1),
             QStringLiteral("offered-plane"));
    say(Standing::Done, tr("Plane %1 of %2 taken: %3 % of the surface below %4°.")
                            .arg(plane + 1)
                            .arg(offeredPlanes().size())
                            .arg(100 * taken.violatingAreaFraction, 0, 'f', 1)
                            .arg(project().design.draftDegrees, 0, 'f', 1));
}

void Workbench::takeNextPlane() {
    if (offeredPlanes().empty())
        findBestPlane();
    else
        takeOffered((offeredPlane() + 1) % static_cast<int>(offeredPlanes().size()));
}

std::optional<MoldState> Workbench::suggestedPlane() const {
    for (const Obstruction& obstruction : obstructions())
        for (const Remedy& remedy : obstruction.remedies)
            if (remedy.state)
                return remedy.state;
    return std::nullopt;
}

void Workbench::takeSuggestedPlane() {
    setState(*suggestedPlane(), tr("Suggested plane"));
    say(Standing::Done,
        tr("Suggested plane taken: nothing is in the way of the mold there. Run bends the part."));
}

void Workbench::findBestDirections() {
    const Project from = m_document.committed();
    if (!allows(from.design.limits, from.state->plane.normal)) {
        say(Standing::Warning,
            tr("No direction keeps to the axis and to the tilt limit at this plane. Turn the "
               "plane, or allow more."));
        return;
    }
    m_background.start(tr("Searching directions"), [=, this](const Task&) -> Background::Finish {
        const Directions directions =
            bestDirections(*from.part, from.state->plane, from.design.draftDegrees, from.design.limits);
        return [=, this] { setState({from.state->plane, directions}, tr("Best directions")); };
    });
}

void Workbench::run() {
    startRun(nullptr);
}

void Workbench::startRun(const std::shared_ptr<const Points>& start) {
    const Project from = m_document.committed();
    m_stream = std::make_shared<FrameStream>();
    m_stream->setPickers(m_picking);
    m_control = std::make_shared<RunControl>();
    m_progress.clear();
    m_frame.reset();
    m_kept.clear();
    m_keptPart = from.part;
    m_backTo = 0;
    m_runFrom = from;
    m_posted = liveSettings(from);
    m_toldOfLate = false;
    m_frameTimer.start();
    const auto work = [=, this, stream = m_stream, control = m_control](const Task& task) {
        DesignRequest request = designRequest(from);
        request.start = start;
        request.keepUnfinished = true;
        request.finishNow = [control] { return control->takeFinish(); };
        request.newest = [control] { return control->takeNewest(); };
        request.bendMeanwhile = [control] { return !control->resting(); };
        const Result<DesignResult> result = design(request, task, [&](const DesignFrame& frame) {
            stream->put(frame);
            control->waitWhileResting(task);
        });
        return Background::Finish([=, this] { takeResult(result, from); });
    };
    m_background.start(tr("Deforming"), work);
}

void Workbench::fillAndRun() {
    DesignSettings settings = project().design;
    settings.fill = FillChoice::Auto;
    m_document.edit(tr("Fill where bending fails"), withDesignSettings(m_document.committed(), settings));
    run();
}

void Workbench::rest() {
    m_control->rest();
    Q_EMIT changed();
}

void Workbench::goOn() {
    showNewest();
    m_control->goOn();
    Q_EMIT changed();
}

void Workbench::finish() {
    m_control->finish();
    Q_EMIT changed();
}

void Workbench::pullFrames() {
    if (!m_stream)
        return;
    TakenFrames taken = m_stream->take();
    m_progress.insert(m_progress.end(), taken.points.begin(), taken.points.end());
    for (const DesignFrame& frame : taken.frames)
        m_kept.add(frame);
    if (!taken.newest)
        return;
    if (m_backTo == 0) {
        m_frame = std::move(taken.newest);
        placePins();
        setPicking(m_picking); // it may have been made before a tool was taken
    }
    Q_EMIT changed();
}

void Workbench::buildMoldNow() {
    const Project from = m_document.committed();
    m_background.start(tr("Building the mold"), [=, this](const Task& task) -> Background::Finish {
        const CastResult& cast = *from.cast;
        const Tray tray = trayOf(from, from.name);
        const MoldSettings settings = moldAsBuilt(from);
        auto built = buildMold(tray, cast.draftDegrees, settings, task);
        const auto drawn = [&](const MoldHalf Mold::* half) {
            return built ? scene::drawnMesh(((*built).*half).mesh) : nullptr;
        };
        const std::array halves{drawn(&Mold::half1), drawn(&Mold::half2)};
        const auto contacts = built ? contactsOnTheWayOut(*built, *cast.mesh) : std::array<ContactWays, 2>();
        return [=, this, built = std::make_shared<Result<Mold>>(std::move(built))] {
            if (!*built) {
                complain(built->error(), tr("Building the mold"));
                return;
            }
            const auto mold = std::make_shared<const Mold>(std::move(**built));
            m_molds[from.variantName] = {mold, halves, contacts, tray, settings};
            if (mold->verified())
                say(Standing::Done, tr("Mold built: both halves are proved to come off."));
            for (const std::string& what : mold->problems)
                say(Standing::Failing, sentence(what));
            for (const Message& what : mold->notes)
                say(Standing::Info, sentenceWithWords(what));
            Q_EMIT changed();
            Q_EMIT moldBuilt();
        };
    });
}

} // namespace moldwright
