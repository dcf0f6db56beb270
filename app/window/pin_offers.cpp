// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/pin_offers.h"

#include "project/edits.h"
#include "window/background.h"
#include "window/document.h"

#include <algorithm>
#include <utility>

namespace moldwright {

PinOffers::PinOffers(Document& document, Background& background, QObject* parent)
    : QObject(parent), m_document(document), m_background(background) {
    connect(&m_ranks, &LiveRanks::answered, this, &PinOffers::take);
}

void PinOffers::search() {
    const Project from = m_document.committed();
    m_background.start(tr("Looking for pins"), [=, this](const Task& task) -> Background::Finish {
        Result<PinSuggestions> pins = suggestPins(*from.part, {most, from.design.seed}, task);
        if (pins && from.state)
            rankPins(*pins, *from.part, *from.state, from.design.draftDegrees);
        return [=, this, pins = std::move(pins)] {
            if (!pins) {
                Q_EMIT failed(pins.error());
                return;
            }
            m_found = std::make_shared<const PinSuggestions>(*pins);
            m_ranked = m_found;
            m_part = from.part;
            follow(); // the plane may be another by now
            Q_EMIT changed();
            Q_EMIT found();
        };
    });
}

bool PinOffers::known() const {
    return m_found && m_part == m_document.project().part;
}

void PinOffers::setCount(int count) {
    m_count = std::clamp(count, fewest, most);
    Q_EMIT changed();
}

std::vector<SuggestedPin> PinOffers::inView() const {
    if (!known())
        return {};
    std::vector<SuggestedPin> best = m_ranked->pins;
    std::ranges::stable_sort(best, std::greater(), &SuggestedPin::rank);
    best.resize(std::min<std::size_t>(best.size(), static_cast<std::size_t>(m_count)));
    std::erase_if(best, [&](const SuggestedPin& pin) {
        return std::ranges::count(m_document.project().pins, pin.point, &NamedPin::point) > 0;
    });
    return best;
}

void PinOffers::accept(int pin) {
    const Eigen::Vector3d point = inView().at(static_cast<std::size_t>(pin)).point;
    acceptWhere([&](const SuggestedPin& offered) { return offered.point == point; },
                tr("Take a suggested pin"));
}

void PinOffers::acceptTips() {
    acceptWhere([](const SuggestedPin& offered) { return offered.kind == PinKind::Tip; },
                tr("Pin the ends of limbs"));
}

bool PinOffers::acceptIn(const scene::Lasso& lasso) {
    const auto isInLasso = [&](const SuggestedPin& offered) {
        return scene::isInside(lasso.line, lasso.camera.project(offered.point, lasso.view).head<2>());
    };
    return acceptWhere(isInLasso, tr("Take suggested pins"));
}

bool PinOffers::acceptWhere(const std::function<bool(const SuggestedPin&)>& wanted, const QString& words) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    const std::size_t before = pins.size();
    for (const SuggestedPin& offered : inView())
        if (wanted(offered))
            pins.push_back({{offered.point}, {}});
    if (pins.size() == before)
        return false;
    m_document.edit(words, withPins(m_document.committed(), std::move(pins)));
    return true;
}

void PinOffers::follow() {
    const Project& project = m_document.project();
    if (!known() || !project.state)
        return;
    const RankRequest request{m_found, project.part, *project.state, project.design.draftDegrees};
    if (request == m_asked)
        return; // other edits change no rank
    m_asked = request;
    m_ranks.ask(request);
}

void PinOffers::take(const RankRequest& request, const std::shared_ptr<const PinSuggestions>& ranked) {
    if (request.pins != m_found)
        return; // of another search
    m_ranked = ranked;
    Q_EMIT changed();
}

} // namespace moldwright
