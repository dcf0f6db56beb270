// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

namespace moldwright {

/// Edits of a project: pure functions Project → Project. Each also drops what it makes untrue: an edit of the
/// part, the plane, the directions, the pins, the importance, the undercuts or the design settings drops the
/// cast, which no longer follows from them. An edit that changes nothing returns an equal project.

/// The mesh as read, brought to millimetres and moved.
[[nodiscard]] IndexedMesh placed(const IndexedMesh& source, const Placement& placement);

/// A new project about a part; settings of design and mold are kept, everything about another part goes,
/// other variants too.
[[nodiscard]] Project withPart(Project project, std::string name, std::string sourceFile, SharedMesh source,
                               const Placement& placement);

/// The part placed anew; plane, directions, their axis, pins and places of undercuts move with it, those of
/// all variants.
[[nodiscard]] Project withPlacement(Project project, const Placement& placement);

/// Another mold state, chosen by hand (a drag) or found by the program.
[[nodiscard]] Project withState(Project project, const MoldState& state, bool byHand);

/// Directions chosen by hand: a run takes them as they are. Precondition: a state was chosen.
[[nodiscard]] Project withDirections(Project project, const Directions& directions);

/// Another plane. Directions stay where they still leave the plane, else they become normal to it.
[[nodiscard]] Project withPlane(Project project, const PartingPlane& plane, bool byHand);

[[nodiscard]] Project withDesignSettings(Project project, const DesignSettings& settings);
/// Pins with the names of those that are known at the same points.
[[nodiscard]] std::vector<NamedPin> named(const std::vector<Pin>& pins, const std::vector<NamedPin>& known);
/// Other pins. Names are no part of what a cast follows from.
[[nodiscard]] Project withPins(Project project, std::vector<NamedPin> pins);
/// Other regions that are to keep their shape. Names and limits are no part of what a cast follows from.
[[nodiscard]] Project withImportance(Project project, std::vector<ImportantRegion> regions);
/// An undercut, known by a place on it, to be treated as chosen; none: by the rule, as all others. A choice
/// at the same place is replaced.
[[nodiscard]] Project withUndercut(Project project, const Eigen::Vector3d& place,
                                   std::optional<UndercutChoice::Treatment> treatment);

[[nodiscard]] Project withMoldSettings(Project project, const MoldSettings& settings);

/// The project with what a design run made, and the mold state that it ended in.
[[nodiscard]] Project withCast(Project project, const DesignResult& result, double draftDegrees);

} // namespace moldwright
