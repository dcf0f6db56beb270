// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/property_panel.h"
#include "window/mold_feature_pages.h"

#include <QString>

#include <vector>

namespace moldwright {

/// The features of the mold among what is chosen, in its order.
[[nodiscard]] std::vector<FeatureName> featuresOf(const QString& selected);

/// The page of several of them.
[[nodiscard]] PropertyPage featuresPage(const QString& selected, const Actions& actions);

/// What the views show, with all that are chosen marked; see shownPlan() and featureChips().
[[nodiscard]] scene::ShownPlan planWithChosen(const Workbench& bench, const QString& selected);
[[nodiscard]] std::vector<scene::Chip> chipsOfChosen(const Workbench& bench, const QString& selected);

} // namespace moldwright
