// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "cli/insert_options.h"
#include "mold/mold_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// Options that say what a mold is made of. What is not given stays as the project has it.
struct MoldOptions {
    /// Declares --wall, --cavities, --spout, --vents, --keys, --slits, --shrink, --pockets, --plaque and
    /// those that refine them.
    void declare(CLI::App& app);

    /// The material that was named, if one was. Errors: Usage, with those there are; BadInput, naming a
    /// table.
    [[nodiscard]] Result<std::optional<Material>> material() const;

    /// `settings` with what was given: first the preset, then the material. Errors: Usage; BadInput.
    [[nodiscard]] Result<MoldSettings> applied(MoldSettings settings) const;

private:
    void declareBlock(CLI::App& app);
    void declareLayout(CLI::App& app);
    void declareChannels(CLI::App& app);
    void declareRegistration(CLI::App& app);
    void declareHoles(CLI::App& app);
    void declarePouring(CLI::App& app);
    [[nodiscard]] Result<void> applyLayout(LayoutSettings& layout) const;
    [[nodiscard]] Result<void> applyCavityPlaces(LayoutSettings& layout) const;
    [[nodiscard]] Result<void> applyCavities(LayoutSettings& layout) const;
    [[nodiscard]] Result<void> applyShrink(ShrinkSettings& shrink) const;
    [[nodiscard]] Result<void> applyPlaces(PlacedFeatures& placed) const;
    [[nodiscard]] Result<void> applyChannels(MoldSettings& settings) const;
    [[nodiscard]] Result<void> applyPouring(MoldSettings& settings) const;
    [[nodiscard]] Result<MoldSettings> afterPreset(MoldSettings settings) const;
    [[nodiscard]] Result<MoldSettings> afterMaterial(MoldSettings settings) const;
    void applyBlock(MoldSettings& settings) const;
    void applyRegistration(MoldSettings& settings) const;
    void applyHoles(MoldSettings& settings) const;

    std::optional<double> wall, side, floor, ceiling, step, outerDraft, pressure, leastSteel, density,
        blockDensity;
    std::optional<double> hollow, neck;
    std::string preset, materialName;
    std::optional<double> press;
    std::vector<double> stock, bed;
    std::string block;
    std::string cavities, arrangement, alternate, cavityPlaces, places;
    std::optional<double> spacing;
    std::vector<double> shrink, shrinkOrigin;
    std::string shrinkFormula;
    std::string spout, pour, vents, runners;
    std::optional<double> spoutDiameter, funnel, gate, spoutDraft, ventDiameter, ventDepth, smallestTrap;
    std::optional<int> keys, slits;
    std::optional<double> keyDiameter, keyHeight, keyClearance, keyLean, slitDepth, slitWidth, slitHeight;
    std::optional<int> bolts, ejectors, ejectorSide;
    std::optional<double> boltDiameter, boltWall, boltClear, ejectorDiameter;
    std::optional<int> overflows;
    std::string pourTilt;
    std::optional<double> pourTowards;
    std::optional<double> overflowDiameter, overflowChannel, overflowLength;
    InsertOptions inserts;
};

} // namespace moldwright::cli
