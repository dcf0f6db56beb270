// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/mold_fields.h"

#include "window/mold_field_tables.h"

#include <utility>

namespace moldwright {

std::vector<MoldFieldSection> moldFieldSections() {
    std::vector<MoldFieldSection> sections = {blockFields(), shrinkFields(), cavityFields(), fillingFields(),
                                              closingFields()};
    const std::size_t always = sections.size();
    sections.push_back(tiltFields());
    for (const Placeable kind : {Placeable::Spout, Placeable::Vent, Placeable::Overflow, Placeable::Key,
                                 Placeable::Slit, Placeable::Bolt, Placeable::Ejector, Placeable::Pocket})
        sections.push_back(fieldsOfKind(kind));
    sections.push_back(plaqueFields());
    sections.push_back(machineFields());
    for (std::size_t i = always; i < sections.size(); ++i)
        sections[i].folds = true;
    return sections;
}

PropertySection sectionOf(const MoldFieldSection& section) {
    PropertySection rows{section.title, {}, {}, false};
    rows.folds = section.folds;
    for (const MoldField& field : section.fields)
        rows.rows.push_back(field.row);
    return rows;
}

void fillFields(PropertyPanel& panel, const MoldFieldSection& section, const MoldSettings& mold) {
    for (const MoldField& field : section.fields)
        panel.setValue(field.row.id, field.read(mold));
}

} // namespace moldwright
