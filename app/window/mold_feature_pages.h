// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/placed_feature.h"
#include "panels/project_tree.h"
#include "panels/property_panel.h"
#include "scene/feature_layer.h"
#include "scene/overlay.h"

#include <QString>

#include <optional>
#include <vector>

namespace moldwright {

class Actions;
class MoldPlacing;
class Workbench;

/// A feature by its kind and number.
struct FeatureName {
    Placeable kind = Placeable::Key;
    int number = 0;
};

/// The id of a feature in tree and panel, and back; none for the id of anything else.
[[nodiscard]] QString featureId(Placeable kind, int number);
[[nodiscard]] std::optional<FeatureName> featureOf(const QString& id);

/// Adds the features to the tree's rows, under the one at `parent`.
void addFeatureRows(std::vector<ProjectRow>& rows, int parent, const Workbench& bench);

/// The page of one feature. Precondition: the id of one.
[[nodiscard]] PropertyPage featurePage(const QString& id, const Workbench& bench, const Actions& actions);
void fillFeaturePage(PropertyPanel& panel, const Workbench& bench);
/// Takes a value of the page shown (pageId); false for the id of anything else.
bool applyFeatureValue(Workbench& bench, const QString& id, const QString& page, double value, bool preview);

/// What the views show of them in the part's frame, the chosen one marked. Its features are those of
/// MoldPlacing::rows(), in their order.
[[nodiscard]] scene::ShownPlan shownPlan(const Workbench& bench, const QString& selected);
/// A chip at the chosen feature and at all that break a limit, with the steel there.
[[nodiscard]] std::vector<scene::Chip> featureChips(const Workbench& bench, const QString& selected);

} // namespace moldwright
