// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/pin_pages.h"

#include "project/edits.h"
#include "theme/theme.h"
#include "window/action_table.h"
#include "window/common_value.h"
#include "window/pin_offers.h"
#include "window/presentation.h"
#include "window/row_id.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PinPages)
};

const QString allId = u"pins"_s;
const QString suggestedId = u"suggested-pins"_s;
const QString placePrefix = u"pin-place-"_s; ///< then the axis
const QString wayPrefix = u"pin-way-"_s;     ///< then the pin's number
const std::array axes = {u"x"_s, u"y"_s, u"z"_s};

std::optional<double> wayToPlane(const Workbench& bench, int number) {
    const Project& project = bench.project();
    if (!project.state)
        return std::nullopt;
    return std::abs(project.state->plane.distance(project.pins[static_cast<std::size_t>(number)].point));
}

QString wayText(const Workbench& bench, int number) {
    const std::optional<double> way = wayToPlane(bench, number);
    return way ? u"%1 mm"_s.arg(*way, 0, 'f', 1) : u"–"_s;
}

bool isPin(const Workbench& bench, int number) {
    return number >= 0 && number < static_cast<int>(bench.project().pins.size());
}

/// The one of these pins that is farthest from the plane.
int farthestOf(const Workbench& bench, const std::vector<int>& numbers) {
    return *std::ranges::max_element(numbers, {}, [&](int number) { return wayToPlane(bench, number); });
}

PropertySection suggestedSection(const Workbench& bench, const Actions& actions) {
    PropertySection section{Words::tr("Suggested"), {}, {}, false};
    if (!bench.pinOffers().known()) {
        section.notes = {Words::tr("Ends of limbs, where limbs meet, and points along the body.")};
        section.buttons = {actions[u"suggest-pins"_s]};
        return section;
    }
    section.rows = {Property{u"pin-count"_s, Words::tr("Shown at most"),
                             Words::tr("The best ones at this plane; those taken are no longer shown."),
                             NumberProperty{{},
                                            static_cast<double>(PinOffers::fewest),
                                            static_cast<double>(PinOffers::most),
                                            1,
                                            0,
                                            true}},
                    Property{u"pin-tips"_s, Words::tr("Ends of limbs"), {}, ReadingProperty{}}};
    section.notes = {Words::tr("Click a faint ring in the view to take it.")};
    section.buttons = {actions[u"accept-tips"_s], actions[u"accept-lasso"_s]};
    return section;
}

QStringList pinNames(const Workbench& bench) {
    QStringList names;
    for (int i = 0; i < static_cast<int>(bench.project().pins.size()); ++i)
        names << bench.pinName(i);
    return names;
}

/// Each pin with its way to the plane.
PropertySection tableOfPins(const Workbench& bench) {
    PropertySection table{Words::tr("To the plane"), {}, {}, false};
    for (const QString& name : pinNames(bench))
        table.rows.push_back(Property{wayPrefix + QString::number(table.rows.size()), name,
                                      Words::tr("How far a run has to draw it, along the plane's normal."),
                                      ReadingProperty{}});
    return table;
}

PropertyPage allPage(const Workbench& bench, const Actions& actions) {
    PropertyPage page{allId,
                      u"guides"_s,
                      Words::tr("Pins"),
                      Words::tr("Hold points of the part on the parting plane."),
                      {}};
    page.layout = u"%1 %2"_s.arg(bench.pinOffers().known()).arg(pinNames(bench).join(u'\n'));
    PropertySection set{Words::tr("Set by hand"), {}, {actions[u"pin"_s], actions[u"pin-inside"_s]}, true};
    if (bench.project().pins.empty())
        set.notes = {Words::tr("No pins yet. Where limbs curl, pins at their ends unroll them.")};
    else
        set.rows = {Property{u"pin-number"_s, Words::tr("Pins"), {}, ReadingProperty{}},
                    Property{u"pin-farthest"_s, Words::tr("Farthest from the plane"), {}, ReadingProperty{}}};
    page.sections = {std::move(set)};
    if (!bench.project().pins.empty())
        page.sections.push_back(tableOfPins(bench));
    page.sections.push_back(suggestedSection(bench, actions));
    page.sections.push_back({Words::tr("All pins"),
                             {},
                             {actions[u"clear-pins"_s], actions[u"import-pins"_s], actions[u"export-pins"_s]},
                             false});
    return page;
}

} // namespace

QString pinId(int number) {
    return u"pin-%1"_s.arg(number);
}

int pinNumber(const QString& id) {
    return numberAfter(u"pin-"_s, id);
}

std::vector<int> pinNumbers(const QString& selected) {
    return numbersAfter(u"pin-"_s, selected);
}

bool pinsChosen(const QString& selected) {
    return selected == allId || selected == suggestedId || !pinNumbers(selected).empty();
}

void addPinRows(std::vector<ProjectRow>& rows, const Workbench& bench, const Visibility& visible) {
    const auto count = static_cast<int>(bench.project().pins.size());
    rows.push_back({.id = allId,
                    .iconName = u"guides"_s,
                    .name = Words::tr("Pins"),
                    .value = count == 0 ? Words::tr("none") : QString::number(count),
                    .visible = visible.pins,
                    .strong = true});
    const int parent = static_cast<int>(rows.size()) - 1;
    for (int i = 0; i < count; ++i)
        rows.push_back({.id = pinId(i),
                        .parent = parent,
                        .iconName = u"pin"_s,
                        .tint = toColor(theme().scene.pinLine),
                        .name = bench.pinName(i),
                        .value = wayText(bench, i),
                        .visible = visible.shows(pinId(i)),
                        .renamable = true});
    if (bench.pinOffers().known())
        rows.push_back({.id = suggestedId,
                        .parent = parent,
                        .iconName = u"pin"_s,
                        .name = Words::tr("Suggested pins"),
                        .value = QString::number(bench.pinOffers().inView().size()),
                        .visible = visible.suggestedPins});
}

PropertyPage pinPage(const QString& selected, const Workbench& bench, const Actions& actions) {
    const std::vector<int> numbers = pinNumbers(selected);
    if (numbers.empty() || !isPin(bench, numbers.back()))
        return allPage(bench, actions);
    const QString title =
        numbers.size() == 1 ? bench.pinName(numbers.front()) : Words::tr("%1 pins").arg(numbers.size());
    PropertyPage page{selected, u"pin"_s, title, Words::tr("Pins"), {}};
    page.layout = page.title;
    const NumberProperty place{u"mm"_s, -10000, 10000, 0.5, 2, false};
    PropertySection where{Words::tr("Place in the part"), {}, {actions[u"remove-guide"_s]}, false};
    for (const QString& axis : axes)
        where.rows.push_back(Property{placePrefix + axis, axis.toUpper(), {}, place});
    page.sections = {
        std::move(where),
        {Words::tr("Measured"),
         {Property{u"pin-way"_s,
                   numbers.size() == 1 ? Words::tr("To the plane") : Words::tr("Farthest from the plane"),
                   Words::tr("How far a run has to draw it, along the plane's normal."), ReadingProperty{}}},
         {},
         false}};
    return page;
}

void fillPinPage(PropertyPanel& panel, const Workbench& bench) {
    const auto reading = [&](const QString& id, const QString& value) {
        panel.setValue(id, QStringList{value, QString()});
    };
    const std::vector<NamedPin>& pins = bench.project().pins;
    if (panel.pageId() == allId) {
        std::vector<int> all(pins.size());
        std::iota(all.begin(), all.end(), 0);
        reading(u"pin-number"_s, QString::number(pins.size()));
        reading(u"pin-farthest"_s, pins.empty() ? u"–"_s : wayText(bench, farthestOf(bench, all)));
        for (int i = 0; i < static_cast<int>(pins.size()); ++i)
            reading(wayPrefix + QString::number(i), wayText(bench, i));
        panel.setValue(u"pin-count"_s, bench.pinOffers().count());
        const std::vector<SuggestedPin> suggested = bench.pinOffers().inView();
        reading(u"pin-tips"_s,
                QString::number(std::ranges::count(suggested, PinKind::Tip, &SuggestedPin::kind)));
        return;
    }
    const std::vector<int> numbers = pinNumbers(panel.pageId());
    if (numbers.empty() || !isPin(bench, numbers.back()))
        return;
    for (int axis = 0; axis < 3; ++axis)
        panel.setValue(placePrefix + axes[static_cast<std::size_t>(axis)], common(numbers, [&](int number) {
                           return pins[static_cast<std::size_t>(number)].point[axis];
                       }));
    reading(u"pin-way"_s, wayText(bench, farthestOf(bench, numbers)));
}

bool applyPinValue(Workbench& bench, const QString& id, const QString& page, double value, bool preview) {
    if (id == u"pin-count"_s) {
        bench.pinOffers().setCount(static_cast<int>(std::lround(value)));
        return true;
    }
    const std::vector<int> numbers = pinNumbers(page);
    if (!id.startsWith(placePrefix) || numbers.empty() || !isPin(bench, numbers.back()))
        return false;
    if (preview)
        return true;
    const Project& from = bench.document().committed();
    std::vector<NamedPin> pins = from.pins;
    const auto axis = std::ranges::find(axes, id.mid(placePrefix.size())) - axes.begin();
    for (const int number : numbers)
        pins[static_cast<std::size_t>(number)].point[static_cast<Eigen::Index>(axis)] = value;
    bench.document().edit(numbers.size() == 1 ? Words::tr("Move %1").arg(bench.pinName(numbers.front()))
                                              : Words::tr("Move %1 pins").arg(numbers.size()),
                          withPins(from, std::move(pins)), page + id);
    return true;
}

scene::ShownPins shownPins(const Workbench& bench, const QString& selected, bool suggested,
                           const Visibility& visible) {
    scene::ShownPins shown;
    const std::vector<int> chosen = pinNumbers(selected);
    const std::optional<MoldState> state = bench.shownState();
    const std::vector<Pin> pins = bench.pinsInView();
    for (int i = 0; i < static_cast<int>(pins.size()); ++i) {
        if (!visible.shows(pinId(i)))
            continue;
        const Pin& pin = pins[static_cast<std::size_t>(i)];
        scene::ShownPin it{
            .number = i, .place = pin.point, .onPlane = {}, .chosen = std::ranges::binary_search(chosen, i)};
        if (state)
            it.onPlane = pin.point - state->plane.distance(pin.point) * state->plane.normal;
        shown.pins.push_back(it);
    }
    if (suggested)
        for (const SuggestedPin& pin : bench.pinOffers().inView())
            shown.suggested.push_back(pin.point);
    return shown;
}

std::vector<scene::Chip> pinChips(const Workbench& bench, const QString& selected) {
    std::vector<scene::Chip> chips;
    for (const int number : pinNumbers(selected)) {
        if (!isPin(bench, number))
            continue;
        const std::string way = Words::tr("%1 to the plane").arg(wayText(bench, number)).toStdString();
        chips.push_back(
            {bench.project().pins[static_cast<std::size_t>(number)].point,
             {{},
              {{std::nullopt, {{bench.pinName(number).toStdString()}, {way, scene::Ink::Text, true}}, {}}}}});
    }
    return chips;
}

} // namespace moldwright
