// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "features/drafted_prism.h"
#include "features/stencil_letters.h"
#include "mesh/indexed_mesh.h"
#include "mold/block.h"
#include "mold/free_place.h"
#include "mold/mold_settings.h"

#include <string>
#include <vector>

namespace moldwright {

/// Letters engraved in the back of one half, to be read from outside.
struct Plaque {
    std::string text;                                ///< as it reads, lines with " | " between
    Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< mm, mold's frame: its middle
    int side = 1;
    double back = 0;                   ///< z of the half's back
    double letterHeight = 0;           ///< mm, of a capital
    std::vector<DraftedPrism> strokes; ///< stand on the plane z = 0 instead of on the back, each a groove

    [[nodiscard]] double strokeWidth() const { return letterHeight * strokeOfHeight; }
    /// Walls and floors of the grooves, looking out of them; open at the back.
    [[nodiscard]] IndexedMesh surface() const;
    /// The grooves, closed.
    [[nodiscard]] IndexedMesh solid() const;
};

/// What a shop calls a part.
struct PartTitle {
    std::string name;
    std::string number;   ///< may be empty
    std::string revision; ///< may be empty
};

/// What was typed, with the part's title for "{part}", "{number}" and "{revision}"; "auto" stands for all of
/// the title that there is, half and shrink.
[[nodiscard]] std::string plaqueText(const std::string& typed, const PartTitle& title);

/// What a plaque says on a half: "{half}" and "{shrink}" replaced, its lines apart.
[[nodiscard]] std::vector<std::string> plaqueLines(const PlaqueSettings& settings,
                                                   const ShrinkSettings& shrink, int side);

/// The letters as near to the middle of the back as what opens there allows, `steel` mm from it and from the
/// edges; along x, or along y where the back is longer so. Errors: Usage for letters that there are not;
/// Impossible where there is no room, where strokes would be thinner than 0.4 mm, or where they would come
/// nearer than `steel` to cavities (`cover`: mm of steel over these).
[[nodiscard]] Result<Plaque> plaqueOn(const PlaqueSettings& settings, const std::vector<std::string>& lines,
                                      int side, const Block& block, const Obstacles& openings, double cover,
                                      double steel);

} // namespace moldwright
