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
};

/// All that can be set of a mold, in the order of its page, in the user's language.
[[nodiscard]] std::vector<MoldFieldSection> moldFieldSections();

} // namespace moldwright
