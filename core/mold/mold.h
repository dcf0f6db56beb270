// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "castability/certificate.h"
#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace moldwright {

/// What a plain mold is made of: a block around the cast, parted at the plane. Lengths in mm. Walls of 5 mm
/// are what open mold generators use for printed molds (range 1.5 to 25 mm).
struct MoldSettings {
    double wall = 5;     ///< steel between cavity and each side face
    double floor = 5;    ///< under the cavity of half 2
    double ceiling = 5;  ///< over the cavity of half 1
    double step = 1;     ///< block sizes round up to a multiple of this; 0: not rounded
    double pressure = 4; ///< bar in the cavity while it fills, for the clamp force; set it to your process

    bool operator==(const MoldSettings&) const = default;
};

/// One mold half in the mold's frame (parting plane z = 0 exactly, side 1 up), every coordinate a float.
struct MoldHalf {
    SharedMesh mesh;
    double volume = 0;                              ///< mm³
    Eigen::Vector3d size = Eigen::Vector3d::Zero(); ///< mm, bounding box
};

/// Two halves, what solidifies in them, and the proof that they come off.
struct Mold {
    MoldHalf half1;
    MoldHalf half2;
    MoldSettings settings;   ///< what it was built with
    double draftDegrees = 1; ///< what was to be proved
    SharedMesh cast;         ///< everything that solidifies, mold's frame, floats
    Eigen::Isometry3d partToMold = Eigen::Isometry3d::Identity();
    Directions directions;    ///< in the mold's frame
    double cavityVolume = 0;  ///< mm³
    double channelVolume = 0; ///< mm³
    double partingArea = 0;   ///< mm² enclosed by cavities in the parting plane
    double clampForce = 0;    ///< kN along n: partingArea × pressure × 1.1
    double minWall = 0;       ///< mm, smallest steel between a cavity and the outside
    Eigen::Vector3d minWallPlace = Eigen::Vector3d::Zero(); ///< mm, mold's frame: the cavity point it is at
    Certificate castCertificate;                            ///< of `cast` as it stands in the mold's frame
    std::vector<std::string> problems;                      ///< English; what of mold.md's list does not hold

    [[nodiscard]] bool verified() const { return problems.empty() && castCertificate.holds(); }
};

/// Builds and proves the mold of a certified cast. Errors: BadInput when the cast is not certified;
/// Cancelled; Internal when a half could not be made sound.
[[nodiscard]] Result<Mold> buildMold(const IndexedMesh& cast, const SideLabels& labels,
                                     const MoldState& state, double draftDegrees,
                                     const MoldSettings& settings, const Task& task = {});

} // namespace moldwright
