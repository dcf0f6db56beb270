// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "mold/mold_settings.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace moldwright {

/// A cast that is certified in its own plane and directions.
struct CertifiedCast {
    SharedMesh mesh; ///< mm, part's frame
    SideLabels labels;
    MoldState state;
};

/// A part that one mold has cavities of.
struct TrayPart {
    std::shared_ptr<const CertifiedCast> cast; ///< never null
    std::string name;                          ///< for people; may be empty
    std::string source;                        ///< where it was read from, for people; may be empty
    int count = 1;                             ///< of its cavities; of the first part's: at least

    /// Casts are equal where they are the same.
    bool operator==(const TrayPart&) const = default;
};

/// The most cavities that a mold can have of one part.
inline constexpr int mostCavities = 400;

/// What one mold is built for: one part or several, whose cavities share the parting plane and leave along
/// the directions of the first. Never empty.
using Tray = std::vector<TrayPart>;

/// A tray of one part.
[[nodiscard]] Tray trayOf(CertifiedCast cast, std::string name = {});

/// What a part of a tray is called: by its name, or by its number.
[[nodiscard]] std::string partName(const Tray& tray, std::size_t part);

/// The same with where it was read from, for refusals: two may have the same name.
[[nodiscard]] std::string nameAndSource(const Tray& tray, std::size_t part);

/// The names of all, commas between; of the only part its name as it is.
[[nodiscard]] std::string namesOf(const Tray& tray);

/// A layout in which each place has its part.
struct SeatedLayout {
    LayoutSettings layout;
    std::vector<std::size_t> partAt; ///< by place: which part of the tray; row by row, row 0 first
};

/// The parts in the order of the tray: the first takes all places that the others leave. Where rows and
/// columns have too few, columns are added; a free layout has the places that it has. Errors: Usage, where
/// these are too few, or a count is not from 1 to 400.
[[nodiscard]] Result<SeatedLayout> seated(const Tray& tray, const LayoutSettings& layout);

} // namespace moldwright
