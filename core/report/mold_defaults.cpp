// SPDX-License-Identifier: AGPL-3.0-or-later
#include "report/mold_defaults.h"

#include "mold/material_choice.h"

#include <utility>

namespace moldwright {

namespace {

constexpr const char* kOwn = MW_TEXT("Report", "own choice");
constexpr const char* kOpen = MW_TEXT("Report", "open mold generators");
constexpr const char* kShop = MW_TEXT("Report", "shop practice");

/// Rows for values that are as they come.
class Defaults {
public:
    explicit Defaults(const Phrases& say) : m_say(say) {}

    void add(const char* name, double value, double usual, const char* unit, const char* source) {
        if (value == usual)
            always(name, readable(value) + unit, source);
    }
    void always(const char* name, const std::string& value, const char* source) {
        m_used.push_back({m_say(name), value, m_say(source)});
    }
    [[nodiscard]] std::vector<ReportDefault> used() && { return std::move(m_used); }

private:
    const Phrases& m_say;
    std::vector<ReportDefault> m_used;
};

void addFilling(Defaults& defaults, const MoldSettings& mold) {
    const MoldSettings usual;
    const SpoutSettings& spout = mold.spout;
    if (spout.on) {
        defaults.add(MW_TEXT("Report", "Spout, diameter"), spout.diameter, usual.spout.diameter, " mm",
                     kOpen);
        defaults.add(MW_TEXT("Report", "Spout, at the block’s face"), spout.funnel, usual.spout.funnel, " mm",
                     kOwn);
        defaults.add(MW_TEXT("Report", "Gate, width"), spout.gate, usual.spout.gate, " mm", kOwn);
        defaults.add(MW_TEXT("Report", "Channels, draft"), spout.draft, usual.spout.draft, "°", kOpen);
    }
    if (spout.on && spout.resting == Resting::Lying)
        defaults.add(MW_TEXT("Report", "Neck of the spout"), spout.neck, usual.spout.neck, " mm", kOwn);
    if (mold.vents.on) {
        defaults.add(MW_TEXT("Report", "Vents, at the narrowest"), mold.vents.diameter, usual.vents.diameter,
                     " mm", MW_TEXT("Report", "gravity pour, shop practice"));
        defaults.add(MW_TEXT("Report", "Air that may stay"), mold.vents.smallestTrap,
                     usual.vents.smallestTrap, " mm³", kOwn);
    }
}

void addKeys(Defaults& defaults, const KeySettings& keys) {
    const KeySettings usual;
    defaults.add(MW_TEXT("Report", "Keys, diameter"), keys.diameter, usual.diameter, " mm", kOpen);
    defaults.add(MW_TEXT("Report", "Keys, height"), keys.height, usual.height, " mm", kOpen);
    defaults.add(MW_TEXT("Report", "Keys, clearance"), keys.clearance, usual.clearance, " mm", kOpen);
    defaults.add(MW_TEXT("Report", "Keys, draft at least"), keys.draft, usual.draft, "°", kOpen);
    defaults.add(MW_TEXT("Report", "First key larger by"), keys.oddBy, usual.oddBy, " mm", kOpen);
}

void addSlits(Defaults& defaults, const SlitSettings& slits) {
    const SlitSettings usual;
    defaults.add(MW_TEXT("Report", "Wedge slits, depth"), slits.depth, usual.depth, " mm",
                 MW_TEXT("Report", "mold makers"));
    defaults.add(MW_TEXT("Report", "Wedge slits, width"), slits.width, usual.width, " mm", kOwn);
    defaults.add(MW_TEXT("Report", "Wedge slits, height in each half"), slits.height, usual.height, " mm",
                 kOwn);
}

void addBolts(Defaults& defaults, const BoltSettings& bolts) {
    const BoltSettings usual;
    defaults.add(MW_TEXT("Report", "Bolt holes, diameter"), bolts.diameter, usual.diameter, " mm",
                 MW_TEXT("Report", "M6, ISO 273 medium"));
    defaults.add(MW_TEXT("Report", "Bolt holes, steel to faces"), bolts.wall, usual.wall, " mm", kShop);
    defaults.add(MW_TEXT("Report", "Bolt holes, steel to the rest"), bolts.clear, usual.clear, " mm", kOwn);
}

/// Where a material's value comes from, and what to beware of.
std::string citation(const MaterialValue& value, const Phrases& say) {
    const std::string source = say(value.source);
    return value.status == MaterialValue().status ? source : source + "; " + say(value.status);
}

} // namespace

std::vector<ReportDefault> blockDefaults(const MoldSettings& settings, const Phrases& say) {
    const MoldSettings usual;
    Defaults defaults(say);
    defaults.add(MW_TEXT("Report", "Wall"), settings.wall, usual.wall, " mm",
                 MW_TEXT("Report", "open mold generators, 1.5 to 25 mm"));
    defaults.add(MW_TEXT("Report", "Floor"), settings.floor, usual.floor, " mm",
                 MW_TEXT("Report", "as the wall"));
    defaults.add(MW_TEXT("Report", "Ceiling"), settings.ceiling, usual.ceiling, " mm",
                 MW_TEXT("Report", "as the wall"));
    defaults.add(MW_TEXT("Report", "Sizes round up to"), settings.step, usual.step, " mm", kOwn);
    defaults.add(MW_TEXT("Report", "Cavity pressure"), settings.pressure, usual.pressure, " bar",
                 MW_TEXT("Report", "no source: set it to your process"));
    defaults.always(MW_TEXT("Report", "Clamp allowance"), "× 1.1",
                    MW_TEXT("Report", "1.1 to 1.2 in shop practice"));
    defaults.always(MW_TEXT("Report", "Mix allowance"), "10 %", kShop);
    return std::move(defaults).used();
}

std::vector<ReportDefault> materialValues(const MoldSettings& settings, const Phrases& say) {
    Defaults taken(say);
    for (const MaterialSetting& setting : materialSettings(settings))
        if (setting.isTaken)
            taken.always(setting.name, readable(setting.set) + setting.unit,
                         citation(setting.of, say).c_str());
    return std::move(taken).used();
}

std::vector<ReportDefault> featureDefaults(const MoldSettings& settings, const Phrases& say) {
    Defaults defaults(say);
    addFilling(defaults, settings);
    if (settings.keys.count > 0)
        addKeys(defaults, settings.keys);
    if (settings.slits.count > 0)
        addSlits(defaults, settings.slits);
    if (settings.bolts.count > 0)
        addBolts(defaults, settings.bolts);
    if (settings.ejectors.count > 0)
        defaults.add(MW_TEXT("Report", "Ejector holes, diameter"), settings.ejectors.diameter,
                     EjectorSettings().diameter, " mm", kOwn);
    return std::move(defaults).used();
}

} // namespace moldwright
