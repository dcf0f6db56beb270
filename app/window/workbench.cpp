// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/workbench.h"

#include "mesh/measures.h"
#include "project/edits.h"
#include "project/placing.h"
#include "project/title.h"
#include "project/variants.h"
#include "window/mold_placing.h"
#include "window/pin_offers.h"
#include "window/sentence.h"

namespace moldwright {

namespace {

constexpr int frameMilliseconds = 33;

Eigen::AlignedBox3d boxAround(const std::vector<Eigen::Vector3d>& places) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : places)
        box.extend(place);
    return box;
}

/// Whether a run was told of another plane or other directions than it has heard of.
bool stateWaits(const LiveSettings& told, const LiveSettings& heard) {
    return told.plane && (told.plane != heard.plane || told.directionsChoice != heard.directionsChoice ||
                          told.directions != heard.directions);
}

} // namespace

Workbench::Workbench(QObject* parent)
    : QObject(parent), m_placing(new MoldPlacing(m_document, this)),
      m_pinOffers(new PinOffers(m_document, m_background, this)) {
    connect(&m_document, &Document::changed, this, [this] {
        postLive();
        forgetKept();
        m_variants.follow(m_document.committed());
        askAnalysis();
        askPart();
        forgetOldMaps();
        m_pinOffers->follow();
        m_placing->follow();
        Q_EMIT changed();
    });
    connect(m_placing, &MoldPlacing::changed, this, &Workbench::changed);
    connect(m_pinOffers, &PinOffers::changed, this, &Workbench::changed);
    connect(m_pinOffers, &PinOffers::failed, this,
            [this](const Error& error) { complain(error, tr("Looking for pins")); });
    connect(m_pinOffers, &PinOffers::found, this, [this] {
        say(Standing::Done,
            tr("%1 pins are suggested. Click a faint ring to take one.").arg(m_pinOffers->inView().size()));
    });
    connect(&m_liveFrames, &LiveFrames::answered, this, &Workbench::takeKept);
    connect(&m_origins, &LiveOrigins::answered, this, &Workbench::changed);
    connect(&m_document, &Document::historyChanged, this, &Workbench::changed);
    connect(&m_analysis, &LiveAnalysis::answered, this, [this](const auto& answer) {
        m_answer = answer;
        Q_EMIT changed();
    });
    connect(&m_partAnalysis, &LiveAnalysis::answered, this, [this](const auto& answer) {
        m_partAnswer = answer;
        Q_EMIT changed();
    });
    connect(&m_variants, &VariantComparison::changed, this, [this] {
        forgetOldMaps();
        Q_EMIT changed();
    });
    connect(&m_liveMaps, &LiveMaps::answered, this, [this](const auto& map) {
        m_maps[{map->request.content, map->request.mode}] = map;
        Q_EMIT changed();
    });
    connect(&m_background, &Background::started, this, &Workbench::changed);
    connect(&m_background, &Background::finished, this, &Workbench::changed);
    connect(&m_background, &Background::failed, this, [this](const QString& what) {
        Q_EMIT problem(tr("Something inside Moldwright broke; your work is as it was."), what);
        say(Standing::Failing, what);
    });
    m_frameTimer.setInterval(frameMilliseconds);
    connect(&m_frameTimer, &QTimer::timeout, this, &Workbench::pullFrames);
}

SharedMesh Workbench::shownMesh() const {
    if (m_frame && m_frame->frame.shape)
        return m_frame->frame.shape;
    return project().cast ? project().cast->mesh : project().part;
}

std::optional<MoldState> Workbench::shownState() const {
    // While the plane is dragged, or moved and not yet taken up by the run, it is seen where it will be.
    const bool dragged = project().state != m_document.committed().state;
    const bool waits = running() && m_frame && stateWaits(m_posted, m_frame->frame.settings);
    return m_frame && !dragged && !waits ? std::optional(m_frame->frame.state) : project().state;
}

void Workbench::askAnalysis() {
    const SharedMesh mesh = project().cast ? project().cast->mesh : project().part;
    const Project& shown = project();
    AnalysisRequest& asked = m_analysisAsked;
    const bool same =
        asked.mesh == mesh && asked.state == shown.state && asked.draftDegrees == shown.design.draftDegrees;
    if (!mesh || same)
        return; // other edits change nothing of it
    asked = {mesh, shown.state, shown.design.draftDegrees, {}};
    m_analysis.ask(
        {mesh, shown.state, shown.design.draftDegrees, shown.cast ? shown.cast->labels : SideLabels()});
}

bool Workbench::analysisIsCurrent() const {
    return m_answer && !m_answer->coarse && m_answer->request.mesh == shownMesh() &&
           m_answer->request.state == project().state &&
           m_answer->request.draftDegrees == project().design.draftDegrees;
}

const DraftAnalysis* Workbench::shownAnalysis() const {
    if (m_frame)
        return &m_frame->analysis;
    // While the plane is dragged the last answer stays in view until the next one comes: same mesh, so its
    // faces still fit.
    const bool fits = m_answer && m_answer->request.mesh == shownMesh() && m_answer->request.state;
    return fits ? &m_answer->analysis : nullptr;
}

bool Workbench::analysisIsCoarse() const {
    return m_frame ? m_frame->drawn && m_frame->drawn->sketched() : m_answer && m_answer->coarse;
}

scene::SharedDrawnMesh Workbench::drawnSurface() const {
    const scene::SharedDrawnMesh drawn = m_frame && m_frame->drawn ? m_frame->drawn
                                         : m_answer                ? m_answer->drawn
                                                                   : nullptr;
    return drawn && drawn->mesh == shownMesh() ? drawn : nullptr;
}

bool Workbench::castIsProved() const {
    return castShown() && analysisIsCurrent() && m_answer->certificate && m_answer->certificate->holds();
}

const BuiltMold& Workbench::built() const {
    static const BuiltMold none;
    const auto found = m_molds.find(project().variantName);
    return found != m_molds.end() ? found->second : none;
}

bool Workbench::moldIsCurrent() const {
    const BuiltMold& mold = built();
    return mold.mold && project().cast && mold.tray == trayOf(project(), project().name) &&
           mold.settings == moldAsBuilt(project());
}

void Workbench::say(Standing standing, const QString& text, const Eigen::AlignedBox3d& place) {
    m_messages.add({standing, QTime::currentTime(), text, place});
}

void Workbench::complain(const Error& error, const QString& what) {
    if (error.code == ErrorCode::Cancelled) {
        say(Standing::Info, tr("%1 was stopped.").arg(what));
        return;
    }
    const QString text = sentence(error.message);
    say(Standing::Failing, text, boxAround(error.places));
    const auto [headline, rest] = headAndRest(text);
    Q_EMIT problem(headline, rest);
}

void Workbench::setPlacement(const Placement& placement, const QString& words, const QString& mergeKey) {
    m_document.edit(words, withPlacement(m_document.committed(), placement), mergeKey);
}

void Workbench::quarterTurnPart(const Eigen::Vector3d& axis) {
    setPlacement(moved(project().placement, quarterTurn(*project().part, axis)), tr("Turn the part"));
}

void Workbench::turnPart(const Eigen::Vector3d& axis, double degrees, bool preview) {
    const Project& from = m_document.committed();
    const Placement turned = moved(from.placement, turnAbout(*from.part, axis, degrees));
    if (degrees == 0)
        m_document.endPreview();
    else if (preview)
        m_document.preview(withPlacement(from, turned));
    else
        setPlacement(turned, tr("Turn the part by %1°").arg(degrees));
}

void Workbench::layFlatOn(int face) {
    const Eigen::Vector3d normal = doubleAreaVector(*project().part, face);
    if (normal.norm() > 0)
        setPlacement(moved(project().placement, layFlat(*project().part, normal.normalized())),
                     tr("Lay the part flat"));
}

void Workbench::centrePart() {
    const Eigen::AlignedBox3d box = figures(project().part).box;
    Eigen::Vector3d way = -box.center();
    way.z() = -box.min().z();
    setPlacement(moved(project().placement, Eigen::Isometry3d(Eigen::Translation3d(way))),
                 tr("Move the part to the middle"));
}

void Workbench::setState(const MoldState& state, const QString& words, const QString& mergeKey) {
    m_document.edit(words, withState(m_document.committed(), state, true), mergeKey);
}

void Workbench::restoreShape() {
    Project project = m_document.committed();
    project.cast.reset();
    m_document.edit(tr("Restore the original shape"), project);
}

void Workbench::rename(const QString& name) {
    Project project = m_document.committed();
    project.name = name.toStdString();
    m_document.edit(tr("Rename"), project);
}

} // namespace moldwright
