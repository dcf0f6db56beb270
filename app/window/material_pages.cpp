// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/material_pages.h"

#include "materials/material_table.h"
#include "mold/material_choice.h"
#include "project/edits.h"
#include "window/action_table.h"
#include "window/document.h"
#include "window/material_dialog.h"
#include "window/presentation.h"
#include "window/sentence.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MaterialPages)
};

/// What the row offers after its first choice, "none"; which one the settings have: 0 for none.
struct Offered {
    std::vector<Material> materials;
    int current = 0;
    bool lastIsOfProject = false; ///< the last is the settings' own: the table says otherwise
    QString trouble;              ///< why the user's own are missing; empty: they are there
};

Offered offered(const MoldSettings& settings) {
    Offered all;
    const MaterialPlaces places = MaterialPlaces::usual();
    Result<std::vector<Material>> table = materialTable(places);
    if (!table) {
        all.trouble = sentence(table.error().message);
        table = materialTable({places.bundled, std::nullopt});
    }
    all.materials = std::move(table).value_or(std::vector<Material>());
    if (!settings.material)
        return all;
    auto found = std::ranges::find(all.materials, *settings.material);
    all.lastIsOfProject = found == all.materials.end();
    if (all.lastIsOfProject)
        found = all.materials.insert(found, *settings.material);
    all.current = static_cast<int>(found - all.materials.begin()) + 1;
    return all;
}

QStringList namesOf(const Offered& all) {
    QStringList names(Words::tr("Not chosen"));
    for (const Material& material : all.materials)
        names += sentence(material.name);
    if (all.lastIsOfProject)
        names.back() = Words::tr("%1, as in this project").arg(names.back());
    return names;
}

/// What the material says, whatever the settings are by now.
QStringList paragraphs(const Project& project, const Offered& all) {
    QStringList notes;
    if (!all.trouble.isEmpty())
        notes += all.trouble;
    if (!project.mold.material)
        return notes;
    const Material& material = *project.mold.material;
    // What it says of draft stands in a row of its own.
    for (const Message& note :
         materialNotes(withMaterial(project.mold, material), material.draftDegrees.value))
        notes += sentenceWithWords(note);
    return notes;
}

/// The project designed with the draft that its material asks for; as it is where none is chosen.
Project withDraftOfMaterial(const Project& project) {
    DesignSettings design = project.design;
    if (project.mold.material)
        design.draftDegrees = project.mold.material->draftDegrees.value;
    return withDesignSettings(project, design);
}

} // namespace

PropertySection materialSection(const Project& project, const Actions& actions) {
    const Offered all = offered(project.mold);
    PropertySection section{
        Words::tr("Material"),
        {{materialRow(), Words::tr("Material"),
          Words::tr("Sets shrink, its formula, density and the depth of vents; all can be changed below."),
          ChoiceProperty{namesOf(all)}},
         {u"material-draft"_s, Words::tr("Draft here"), Words::tr("And what is usual for the material."),
          ReadingProperty{true}}},
        {actions[u"edit-materials"_s]},
        false};
    if (project.mold.material)
        section.buttons.insert(section.buttons.begin(), actions[u"take-material-draft"_s]);
    section.notes = paragraphs(project, all);
    return section;
}

QString materialRow() {
    return u"material"_s;
}

QString materialLayout(const Project& project) {
    const Offered all = offered(project.mold);
    const QString chosen = project.mold.material ? u"chosen"_s : u"none"_s;
    return (QStringList(chosen) + namesOf(all) + paragraphs(project, all)).join(u'\n');
}

void fillMaterialSection(PropertyPanel& panel, const Project& project) {
    panel.setValue(materialRow(), offered(project.mold).current);
    const double draft = project.design.draftDegrees;
    const bool chosen = project.mold.material.has_value();
    const double usual = chosen ? project.mold.material->draftDegrees.value : 0;
    panel.setValue(u"material-draft"_s,
                   QStringList{angleText(draft), chosen ? u"≥ "_s + angleText(usual) : QString()});
    panel.setMissesGoal(u"material-draft"_s, draft < usual);
}

MoldSettings withMaterialShown(const MoldSettings& settings, int choice) {
    const Offered all = offered(settings);
    if (choice < 1 || choice > static_cast<int>(all.materials.size()))
        return withoutMaterial(settings);
    return withMaterial(settings, all.materials[static_cast<std::size_t>(choice - 1)]);
}

void connectMaterials(Actions& actions, Workbench& bench, QWidget* window) {
    actions.on(u"take-material-draft"_s, [&bench] {
        const Project& from = bench.document().committed();
        if (!from.mold.material)
            return bench.say(Standing::Failing, Words::tr("Choose a material first."));
        bench.document().edit(Words::tr("Take the material's draft"), withDraftOfMaterial(from));
    });
    actions.on(u"edit-materials"_s, [&bench, window] {
        auto* dialog = new MaterialDialog(MaterialPlaces::usual(), window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        QObject::connect(dialog, &MaterialDialog::tableChanged, &bench, &Workbench::changed);
        dialog->open();
    });
}

} // namespace moldwright
