// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/colours.h"

#include <array>
#include <span>
#include <vector>

namespace moldwright::scene {

/// Seven classes of a value that counts from 0 up, each `step` wide; the last one also takes all that is
/// more.
struct ValueScale {
    static constexpr int classes = 7;
    double step = 1;

    [[nodiscard]] int classOf(double value) const;
    [[nodiscard]] Rgb colourOf(double value) const;
    bool operator==(const ValueScale&) const = default;
};

/// The colours of the classes, lowest first: ever darker, so that a grey print reads.
[[nodiscard]] const std::array<Rgb, ValueScale::classes>& valueColours();

/// Colours for steel, thinnest first: the colour of what is too thin, then ever lighter.
[[nodiscard]] std::array<Rgb, ValueScale::classes> steelColours(Rgb tooThin);

/// The scale with the least step of 1, 2 or 5 times a power of ten that keeps 99 of 100 of the values above 0
/// below its end.
[[nodiscard]] ValueScale scaleFor(std::span<const double> values);

/// For each face of `to`, a coarser mesh of the same surface, the face of `from` nearest to its middle.
/// O(m log m).
[[nodiscard]] std::vector<int> nearestFaces(const IndexedMesh& from, const IndexedMesh& to);

/// Values of `from`'s faces carried over to the faces of `to`, a coarser mesh of the same surface: each takes
/// that of the face nearest to its middle. O(m log m).
[[nodiscard]] std::vector<double> carriedOver(const IndexedMesh& from, std::span<const double> values,
                                              const IndexedMesh& to);

} // namespace moldwright::scene
