// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/mold_settings.h"
#include "panels/property_panel.h"

#include <QVariant>

#include <functional>
#include <vector>

namespace moldwright {

/// A setting of the mold: its row, and how a value comes from the settings and goes into them.
struct MoldField {
    Property row;
    std::function<QVariant(const MoldSettings&)> read;
    std::function<void(MoldSettings&, const QVariant&)> write;
};

/// Settings that stand together under a heading.
struct MoldFieldSection {
    QString title;
    std::vector<MoldField> fields;
    bool folds = false; ///< seldom changed
};

/// What the mold's page sets, in its order, in the user's language.
[[nodiscard]] std::vector<MoldFieldSection> moldFieldSections();

/// What can be set of all features of a kind, for the page of one of them: sizes and clearances.
[[nodiscard]] MoldFieldSection fieldsOfKind(Placeable kind);

/// A row of the panel.
[[nodiscard]] PropertySection sectionOf(const MoldFieldSection& section);

/// Shows the fields' values.
void fillFields(PropertyPanel& panel, const MoldFieldSection& section, const MoldSettings& mold);

} // namespace moldwright
