// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/material_choice.h"

namespace moldwright {

namespace {

bool isOf(const ShrinkSettings& shrink, const Material& material) {
    return shrink.percent == Eigen::Vector3d::Constant(material.shrinkPercent.value) &&
           (shrink.formula == ShrinkFormula::Divide) == material.divide;
}

Message told(const Material& material, const MaterialSetting& setting) {
    const bool isSourced = setting.of.status == MaterialValue().status;
    return {!setting.isTaken ? MW_TEXT("Materials", "{0}: {1} is set otherwise here; usual is {2} ({3}).")
            : isSourced      ? MW_TEXT("Materials", "{0}: {1} {2} ({3}).")
                             : MW_TEXT("Materials", "{0}: {1} {2} ({3}; {4})."),
            {material.name, setting.name, readable(setting.of.value) + setting.unit, setting.of.source,
             setting.of.status}};
}

void addPreparation(std::vector<Message>& notes, const Preparation& steps) {
    const auto add = [&](const char* text, const std::string& step) {
        if (!step.empty())
            notes.push_back({text, {step}});
    };
    add(MW_TEXT("Materials", "Sealing the mold: {0}"), steps.sealing);
    add(MW_TEXT("Materials", "Release agent: {0}"), steps.release);
    add(MW_TEXT("Materials", "Filling: {0}"), steps.filling);
    add(MW_TEXT("Materials", "Setting: {0}"), steps.setting);
    if (!notes.empty())
        add(MW_TEXT("Materials", "Preparation by {0}."), steps.source);
}

} // namespace

MoldSettings withMaterial(MoldSettings settings, const Material& material) {
    const bool ventsOfFormer = settings.material && settings.material->ventDepth &&
                               settings.vents.depth == settings.material->ventDepth->value;
    settings.shrink.percent.setConstant(material.shrinkPercent.value);
    settings.shrink.formula = material.divide ? ShrinkFormula::Divide : ShrinkFormula::Plus;
    settings.density = material.density.value;
    if (material.ventDepth)
        settings.vents.depth = material.ventDepth->value;
    else if (ventsOfFormer)
        settings.vents.depth = VentSettings().depth;
    settings.material = material;
    return settings;
}

MoldSettings withoutMaterial(MoldSettings settings) {
    settings.material.reset();
    return settings;
}

std::vector<MaterialSetting> materialSettings(const MoldSettings& settings) {
    if (!settings.material)
        return {};
    const Material& m = *settings.material;
    std::vector<MaterialSetting> all = {{MW_TEXT("Materials", "Shrink"), " %", m.shrinkPercent,
                                         settings.shrink.percent.x(), isOf(settings.shrink, m)},
                                        {MW_TEXT("Materials", "Density"), " g/cm³", m.density,
                                         settings.density, settings.density == m.density.value}};
    if (m.ventDepth && settings.vents.on)
        all.push_back({MW_TEXT("Materials", "Depth of vents in the parting plane"), " mm", *m.ventDepth,
                       settings.vents.depth, settings.vents.depth == m.ventDepth->value});
    return all;
}

std::vector<Message> materialNotes(const MoldSettings& settings, double draftDegrees) {
    std::vector<Message> notes;
    if (!settings.material)
        return notes;
    const Material& material = *settings.material;
    for (const MaterialSetting& setting : materialSettings(settings))
        notes.push_back(told(material, setting));
    const MaterialValue& draft = material.draftDegrees;
    if (draft.value > draftDegrees)
        notes.push_back(
            {MW_TEXT("Materials", "The cast was designed with {0}° of draft; {1} usually asks for "
                                  "{2}° ({3})."),
             {readable(draftDegrees), material.name, readable(draft.value), draft.source}});
    if (!material.notes.empty())
        notes.push_back({material.notes, {}});
    addPreparation(notes, material.preparation);
    return notes;
}

} // namespace moldwright
