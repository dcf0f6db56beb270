// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace moldwright {

/// What the faces are painted by: red undercuts, classes of draft, a map of numbers, painted importance, or
/// the steel behind the walls of the mold's halves.
enum class DisplayMode {
    Undercuts,
    DraftMap,
    UndercutDepth,
    Deviation,
    Difference,
    Strain,
    Importance,
    Steel,
    Plain
};
inline constexpr int displayModeCount = 9;

/// What a view shows of the part: the newest shape (a run's, the cast, or the part while there is no other),
/// the part as it was opened, or the variant that is compared with the current one (while none is: the newest
/// shape).
enum class ViewContent { Newest, Part, Compared };

/// Where a view is cut open.
struct SectionCut {
    enum class Across { Plane, X, Y, Z, View };
    Across across = Across::Plane;
    double offset = 0; ///< mm, from the parting plane along its normal, or the coordinate
    /// What is beyond the section along that normal or axis stays, not what is before it. None: not decided
    /// yet; the side that the section hides from the eye is to stay.
    std::optional<bool> flipped = {};
    /// Of one that faces the eye, away from the part. None: not decided yet; that of the view is to be taken.
    std::optional<Eigen::Vector3d> normal = {};

    bool operator==(const SectionCut&) const = default;
};

/// The plane of a cut; what lies before it (n·x > o) goes. None where there is no parting plane to cut at, or
/// it is not decided how the cut lies.
[[nodiscard]] std::optional<PartingPlane> planeOf(const SectionCut& cut,
                                                  const std::optional<MoldState>& state);

/// How one view shows it.
struct ViewSettings {
    ViewContent content = ViewContent::Newest;
    DisplayMode mode = DisplayMode::Undercuts;
    bool edges = false;
    bool seeThrough = false;
    std::optional<SectionCut> cut = {}; ///< none: whole; not kept between sessions

    bool operator==(const ViewSettings&) const = default;
};

/// All modes in their order, as a list to choose from shows them.
[[nodiscard]] QStringList displayModeNames();

/// The command that chooses a mode in the active view, by its id; also its name in what is kept.
[[nodiscard]] QString displayModeCommand(DisplayMode mode);

} // namespace moldwright
