// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <Eigen/Geometry>

#include <string>

namespace moldwright {

/// Edits of the document: pure functions from Project to Project. What an edit makes meaningless goes with
/// it.

/// How many millimetres one of these is.
[[nodiscard]] double millimetres(Unit unit);

/// A project with this mesh as its part; design and mold settings stay. `scale` takes the file's numbers to
/// mm. The part keeps the file's place.
[[nodiscard]] Project withPart(const Project& project, const std::string& name, const std::string& sourceFile,
                               const SharedMesh& source, Unit unit, double scale);

/// The part placed otherwise. Plane, directions and pins move with it; a cast, whose proof is for exact
/// coordinates, goes.
[[nodiscard]] Project withPlacement(const Project& project, const Placement& placement);

/// Another plane and directions. A cast stays; castIsCurrent() tells that it is out of date.
[[nodiscard]] Project withState(const Project& project, const MoldState& state, bool chosenByHand);

[[nodiscard]] Project withDesign(const Project& project, const DesignSettings& design);
[[nodiscard]] Project withMold(const Project& project, const MoldSettings& mold);
[[nodiscard]] Project withName(const Project& project, const std::string& name);

/// A finished cast; the project's plane and directions become the cast's.
[[nodiscard]] Project withCast(const Project& project, const CastResult& cast);

/// The undeformed part again; plane and pins stay.
[[nodiscard]] Project withoutCast(const Project& project);

/// The placement after moving the part as it lies by `motion` (in the part's frame).
[[nodiscard]] Placement moved(const Placement& placement, const Eigen::Isometry3d& motion);

/// The motion that lays the part down on a face with this outward normal: the normal looks down, the lowest
/// point is at z = 0.
[[nodiscard]] Eigen::Isometry3d layFlat(const IndexedMesh& part, const Eigen::Vector3d& normal);

/// Whether there is a cast made with the plane, directions and draft that the project asks for now.
[[nodiscard]] bool castIsCurrent(const Project& project);

} // namespace moldwright
