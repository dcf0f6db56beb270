// SPDX-License-Identifier: AGPL-3.0-or-later
// Pins: those set, and those suggested.
#include "window/workbench.h"

#include "project/edits.h"

#include <algorithm>
#include <functional>

namespace moldwright {

void Workbench::addPin(const Eigen::Vector3d& place) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    pins.push_back({{inPart(place)}, {}});
    setPins(std::move(pins), tr("Pin a point"));
}

void Workbench::movePin(int pin, const Eigen::Vector3d& place, const QString& mergeKey, bool preview) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    pins.at(static_cast<std::size_t>(pin)).point = place;
    if (preview) {
        m_document.preview(withPins(m_document.committed(), std::move(pins)));
        return;
    }
    setPins(std::move(pins), tr("Move %1").arg(pinName(pin)), mergeKey);
}

QString Workbench::pinName(int pin) const {
    const std::string& name = project().pins.at(static_cast<std::size_t>(pin)).name;
    return name.empty() ? tr("Pin %1").arg(pin + 1) : QString::fromStdString(name);
}

void Workbench::renamePin(int pin, const QString& name) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    const bool plain = name.trimmed() == tr("Pin %1").arg(pin + 1); // its number stays right, whatever goes
    pins.at(static_cast<std::size_t>(pin)).name = plain ? std::string() : name.trimmed().toStdString();
    setPins(std::move(pins), tr("Rename"));
}

void Workbench::removePins(const std::vector<int>& pins) {
    std::vector<NamedPin> kept;
    for (int i = 0; i < static_cast<int>(project().pins.size()); ++i)
        if (std::ranges::find(pins, i) == pins.end())
            kept.push_back(m_document.committed().pins[static_cast<std::size_t>(i)]);
    setPins(std::move(kept), pins.size() == 1 ? tr("Remove %1").arg(pinName(pins.front()))
                                              : tr("Remove %1 pins").arg(pins.size()));
}

void Workbench::clearPins() {
    setPins({}, tr("Remove all pins"));
}

void Workbench::setPins(std::vector<NamedPin> pins, const QString& words, const QString& mergeKey) {
    m_document.edit(words, withPins(m_document.committed(), std::move(pins)), mergeKey);
}

void Workbench::suggestPins() {
    const Project from = m_document.committed();
    m_background.start(tr("Looking for pins"), [=, this](const Task& task) -> Background::Finish {
        Result<PinSuggestions> found =
            moldwright::suggestPins(*from.part, {mostSuggestedPins, from.design.seed}, task);
        if (found && from.state)
            rankPins(*found, *from.part, *from.state, from.design.draftDegrees);
        return [=, this, found = std::move(found)] {
            if (!found) {
                complain(found.error(), tr("Looking for pins"));
                return;
            }
            m_suggested = std::make_shared<const PinSuggestions>(*found);
            m_rankedPins = m_suggested;
            m_suggestedPart = from.part;
            askRanks(); // the plane may be another by now
            say(Standing::Done,
                tr("%1 pins are suggested. Click a faint ring to take one.").arg(suggestionsInView().size()));
            Q_EMIT changed();
            Q_EMIT pinsSuggested();
        };
    });
}

bool Workbench::suggestionsKnown() const {
    return m_suggested && m_suggestedPart == project().part;
}

void Workbench::setSuggestionCount(int count) {
    m_suggestionCount = std::clamp(count, fewestSuggestedPins, mostSuggestedPins);
    Q_EMIT changed();
}

std::vector<SuggestedPin> Workbench::suggestionsInView() const {
    if (!suggestionsKnown())
        return {};
    std::vector<SuggestedPin> best = m_rankedPins->pins;
    std::ranges::stable_sort(best, std::greater(), &SuggestedPin::rank);
    best.resize(std::min<std::size_t>(best.size(), static_cast<std::size_t>(m_suggestionCount)));
    std::erase_if(best, [&](const SuggestedPin& pin) {
        return std::ranges::count(project().pins, pin.point, &NamedPin::point) > 0;
    });
    return best;
}

void Workbench::acceptSuggestion(int suggestion) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    pins.push_back({{suggestionsInView().at(static_cast<std::size_t>(suggestion)).point}, {}});
    setPins(std::move(pins), tr("Take a suggested pin"));
}

void Workbench::acceptTips() {
    acceptWhere([](const SuggestedPin& suggested) { return suggested.kind == PinKind::Tip; },
                tr("Pin the ends of limbs"));
}

void Workbench::acceptSuggestionsIn(const scene::Lasso& lasso) {
    const auto isInLasso = [&](const SuggestedPin& suggested) {
        return scene::isInside(lasso.line, lasso.camera.project(suggested.point, lasso.view).head<2>());
    };
    if (!acceptWhere(isInLasso, tr("Take suggested pins")))
        say(Standing::Info, tr("No suggested point is seen inside the lasso."));
}

bool Workbench::acceptWhere(const std::function<bool(const SuggestedPin&)>& wanted, const QString& words) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    const std::size_t before = pins.size();
    for (const SuggestedPin& suggested : suggestionsInView())
        if (wanted(suggested))
            pins.push_back({{suggested.point}, {}});
    if (pins.size() == before)
        return false;
    setPins(std::move(pins), words);
    return true;
}

void Workbench::askRanks() {
    if (!suggestionsKnown() || !project().state)
        return;
    const RankRequest request{m_suggested, project().part, *project().state, project().design.draftDegrees};
    if (request == m_ranked)
        return; // other edits change no rank
    m_ranked = request;
    m_ranks.ask(request);
}

void Workbench::takeRanks(const RankRequest& request, const std::shared_ptr<const PinSuggestions>& ranked) {
    if (request.pins != m_suggested)
        return; // of another search
    m_rankedPins = ranked;
    Q_EMIT changed();
}

} // namespace moldwright
