// SPDX-License-Identifier: AGPL-3.0-or-later
// Undercuts that can be filled one by one, and what is chosen for each.
#include "window/workbench.h"

#include "mesh/measures.h"
#include "project/edits.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr double worthListing = 1e-5; ///< of the part's volume: smaller undercuts are left to the rule

/// Those that a designer would choose about: what must be filled, and what is more than a dent.
std::vector<FillableUndercut> worthyOf(std::vector<FillableUndercut> undercuts, double volume) {
    std::erase_if(undercuts, [&](const FillableUndercut& undercut) {
        return !undercut.needed && undercut.volume < worthListing * volume;
    });
    return undercuts;
}

} // namespace

void Workbench::findUndercuts() {
    const Project from = m_document.committed();
    m_background.start(tr("Looking for undercuts"), [=, this](const Task& task) -> Background::Finish {
        Result<std::vector<FillableUndercut>> found = fillableUndercuts(*from.part, *from.state, task);
        if (found)
            found = worthyOf(std::move(*found), volume(*from.part));
        return [=, this, found = std::move(found)] {
            if (!found) {
                complain(found.error(), tr("Looking for undercuts"));
                return;
            }
            m_undercuts = {from.part, from.state, *found, {}};
            for (const FillableUndercut& undercut : *found)
                m_undercuts.walls.push_back(std::make_shared<const IndexedMesh>(undercut.walls));
            const auto needed = std::ranges::count_if(*found, [](const auto& u) { return u.needed; });
            say(Standing::Done, found->empty() ? tr("No undercut at this plane.")
                                               : tr("%1 undercuts at this plane; %2 that no bending frees.")
                                                     .arg(found->size())
                                                     .arg(needed));
            Q_EMIT changed();
            Q_EMIT undercutsFound();
        };
    });
}

bool Workbench::undercutsKnown() const {
    return m_undercuts.part && m_undercuts.part == project().part && m_undercuts.state == project().state;
}

const std::vector<FillableUndercut>& Workbench::undercuts() const {
    static const std::vector<FillableUndercut> none;
    return undercutsKnown() ? m_undercuts.list : none;
}

Eigen::AlignedBox3d Workbench::placeOfUndercut(int undercut) const {
    const FillableUndercut& it = undercuts().at(static_cast<std::size_t>(undercut));
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(std::max(it.size, 1.0) / 2);
    return {it.place - half, it.place + half};
}

int Workbench::undercutOf(const UndercutChoice& choice) const {
    return undercutNearest(undercuts(), *project().part, choice.place);
}

std::optional<UndercutChoice::Treatment> Workbench::treatmentOf(int undercut) const {
    for (const UndercutChoice& choice : project().undercuts)
        if (undercutOf(choice) == undercut)
            return choice.treatment;
    return std::nullopt;
}

void Workbench::treat(int undercut, std::optional<UndercutChoice::Treatment> treatment) {
    Project after = m_document.committed();
    for (const UndercutChoice& choice : m_document.committed().undercuts)
        if (undercutOf(choice) == undercut)
            after = withUndercut(std::move(after), choice.place, std::nullopt);
    after = withUndercut(std::move(after), undercuts()[static_cast<std::size_t>(undercut)].place, treatment);
    m_document.edit(!treatment                                      ? tr("Undercut by the rule")
                    : *treatment == UndercutChoice::Treatment::Fill ? tr("Fill an undercut")
                                                                    : tr("Bend an undercut"),
                    after);
}

std::vector<Eigen::Vector3d> Workbench::placesToFill(int obstruction) const {
    if (obstruction >= 0 && obstruction < static_cast<int>(obstructions().size()))
        for (const Remedy& remedy : obstructions()[static_cast<std::size_t>(obstruction)].remedies)
            if (remedy.kind == Remedy::Kind::Fill || remedy.kind == Remedy::Kind::Merge)
                return remedy.places;
    return {};
}

bool Workbench::willBeFilled(int obstruction) const {
    const std::vector<Eigen::Vector3d> places = placesToFill(obstruction);
    return !places.empty() && std::ranges::all_of(places, [&](const Eigen::Vector3d& place) {
        const UndercutChoice fill{place, UndercutChoice::Treatment::Fill};
        return std::ranges::count(project().undercuts, fill) > 0;
    });
}

void Workbench::fillObstruction(int obstruction) {
    Project after = m_document.committed();
    for (const Eigen::Vector3d& place : placesToFill(obstruction))
        after = withUndercut(std::move(after), place, UndercutChoice::Treatment::Fill);
    m_document.edit(tr("Fill an obstruction"), after);
    const int left = obstructionsLeft();
    const QString headline =
        left == 0   ? tr("It will be filled. Nothing else stands in the way: Run bends the rest.")
        : left == 1 ? tr("It will be filled. One more place to decide on.")
                    : tr("It will be filled. %1 more places to decide on.").arg(left);
    say(Standing::Info, headline);
    Q_EMIT advised({Standing::Info, headline, {}, left == 0 ? QStringLiteral("run") : QString()});
}

int Workbench::obstructionsLeft() const {
    int left = 0;
    for (int i = 0; i < static_cast<int>(obstructions().size()); ++i)
        left += willBeFilled(i) ? 0 : 1;
    return left;
}

} // namespace moldwright
