// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "contour.h"
#include "remesh.h"

#include <string>
#include <vector>

namespace moldwright::samples {

/// One bundled sample: what the start page says of it, and how it is made. Units mm; z is up, the front
/// looks along −y.
struct Sample {
    std::string name; ///< the file is name + ".ply"
    std::string title;
    std::string description;
    Solid solid;
    Fineness fineness;
};

[[nodiscard]] Sample goatHead();
[[nodiscard]] Sample rabbit();
[[nodiscard]] Sample goat();
[[nodiscard]] Sample hand();
[[nodiscard]] Sample fish();
[[nodiscard]] Sample bentBeam();
[[nodiscard]] Sample doorKnob();
[[nodiscard]] Sample praline();

/// All of them in the order in which they are shown.
[[nodiscard]] std::vector<Sample> allSamples();

/// The sample's surface as it is bundled.
[[nodiscard]] IndexedMesh makeMesh(const Sample& sample);

} // namespace moldwright::samples
