// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/chosen_features.h"

#include "window/action_table.h"
#include "window/mold_placing.h"
#include "window/selection.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ChosenFeatures)
};

} // namespace

std::vector<FeatureName> featuresOf(const QString& selected) {
    std::vector<FeatureName> features;
    for (const QString& id : chosenIds(selected))
        if (const auto feature = featureOf(id))
            features.push_back(*feature);
    return features;
}

PropertyPage featuresPage(const QString& selected, const Actions& actions) {
    const std::vector<FeatureName> features = featuresOf(selected);
    PropertyPage page{selected,
                      u"mold"_s,
                      Words::tr("%1 features of the mold").arg(features.size()),
                      Words::tr("Each is placed on its own; these are given back together."),
                      {}};
    PropertySection chosen{
        Words::tr("Chosen"), {}, {actions[u"place-automatically"_s], actions[u"fit-selection"_s]}, false};
    for (const FeatureName& feature : features)
        chosen.notes << featureName(feature.kind, feature.number);
    page.sections = {std::move(chosen)};
    return page;
}

scene::ShownPlan planWithChosen(const Workbench& bench, const QString& selected) {
    scene::ShownPlan plan = shownPlan(bench, selected);
    if (!severalChosen(selected))
        return plan;
    const QStringList ids = chosenIds(selected);
    const std::vector<PlacedRow>& rows = bench.placing().rows();
    for (std::size_t i = 0; i < plan.features.size(); ++i)
        plan.features[i].chosen = ids.contains(featureId(rows[i].stands.kind, rows[i].stands.number));
    return plan;
}

std::vector<scene::Chip> chipsOfChosen(const Workbench& bench, const QString& selected) {
    std::vector<scene::Chip> chips;
    for (const QString& id : chosenIds(selected))
        for (const scene::Chip& chip : featureChips(bench, id)) // those that fail are told of with each
            if (std::ranges::none_of(chips,
                                     [&](const scene::Chip& told) { return told.place == chip.place; }))
                chips.push_back(chip);
    return chips;
}

} // namespace moldwright
