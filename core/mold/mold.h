// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"
#include "base/task.h"
#include "castability/certificate.h"
#include "castability/mold_state.h"
#include "features/plan_shape.h"
#include "mesh/indexed_mesh.h"
#include "mold/mold_settings.h"
#include "mold/steel.h"
#include "mold/tray.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// One mold half in the mold's frame (parting plane z = 0 exactly, side 1 up), every coordinate a float.
struct MoldHalf {
    SharedMesh mesh;
    double volume = 0;                              ///< mm³
    Eigen::Vector3d size = Eigen::Vector3d::Zero(); ///< mm, bounding box
};

/// One feature as it was made: for mold.json, the report, and the places that a view points at.
struct MoldFeature {
    std::string kind; ///< "block", "cavity", "spout", "runner", "gate", "vent", "overflow", "key", "slit"
    std::string name; ///< English
    Eigen::Vector3d place = Eigen::Vector3d::Zero();     ///< mm, mold's frame
    std::vector<std::pair<std::string, double>> numbers; ///< by key of mold.json; mm, degrees, mm³
    Message note;                                        ///< what was corrected and why; no text as a rule
    /// What would put it by hand to where it stands; none for what follows from other features.
    std::optional<PlacedFeature> stands = {};
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< of the frame of `stands`, mm in the mold's
    bool byHand = false;                              ///< a hand put it there
    PlanShape outline = {}; ///< mm, mold's frame: of what can be placed, seen along the normal
    std::string part = {};  ///< of a cavity, where the tray has several parts: which one's
    int number = 0;         ///< of a cavity there, among all of them, from 1
};

/// What a mold has of one part of its tray.
struct PartOfMold {
    std::string name; ///< may be empty where it is the only one
    int cavities = 0;
    double volume = 0;      ///< mm³ of one cavity
    double shellVolume = 0; ///< mm³ of its walls when it is cast hollow; 0: cast solid
    /// Of the cast made larger by the shrink, to the first of its cavities.
    Eigen::Isometry3d toMold = Eigen::Isometry3d::Identity();
};

/// How a mold leans while it is filled, or had better.
struct LeaningMold {
    double degrees = 0;    ///< that its top leans
    double towards = 0;    ///< as PourTilt's
    double airUpright = 0; ///< mm³ that stay when it does not lean
    double air = 0;        ///< mm³ that stay when it does
    bool applied = false;  ///< traps and vents are those of the leaning mold; else a suggestion
};

/// Two halves, what solidifies in them, and the proof that they come off.
struct Mold {
    MoldHalf half1;
    MoldHalf half2;
    MoldSettings settings;         ///< what it was built with
    double draftDegrees = 1;       ///< what was to be proved
    SharedMesh cast;               ///< everything that solidifies, mold's frame, floats
    std::vector<PartOfMold> parts; ///< of the tray
    /// That of the first part.
    Eigen::Isometry3d partToMold = Eigen::Isometry3d::Identity();
    Eigen::Vector3d shrinkFactors = Eigen::Vector3d::Ones(); ///< along each part's axes
    int cavities = 1;
    Directions directions;    ///< in the mold's frame
    double cavityVolume = 0;  ///< mm³ of all cavities
    double channelVolume = 0; ///< mm³ of spout, runners, gates and vents as far as they fill
    double sprueVolume = 0;   ///< mm³ of that: what breaks off in spouts through half 1, not in `cast`
    SharedMesh sprues;        ///< what fills those spouts; null where there are none
    double shellVolume = 0;   ///< mm³ of all cavities' walls when they are cast hollow; 0: cast solid
    double otherVolume = 0;   ///< mm³ of the block that stays empty: slits, clearance of keys, mouths
    double blockVolume = 0;   ///< mm³
    Eigen::Vector3d blockSize = Eigen::Vector3d::Zero(); ///< mm, both halves closed
    double savedVolume = 0; ///< mm³ that a shell has less than the box it was cut from
    double partingArea = 0; ///< mm² enclosed by cavities and channels in the parting plane
    double clampForce = 0;  ///< kN along n: partingArea × pressure × 1.1
    double minWall = 0;     ///< mm, smallest steel between any two features or one and the outside
    Eigen::Vector3d minWallPlace = Eigen::Vector3d::Zero(); ///< mm, mold's frame: on the feature it is at
    std::vector<ThinSteel> steel;                           ///< by pair of names, thinnest first
    std::vector<ThinSteel> steelOfEach;                     ///< by pair of features, thinnest first
    std::vector<Hollow> hollows;                            ///< what the steel was measured between
    Block block;
    std::vector<MoldFeature> features;
    std::vector<double> pathLengths;    ///< mm from the spout's mouth to each cavity's gate
    double trappedAir = 0;              ///< mm³ that no vent serves
    std::optional<LeaningMold> leaning; ///< where it leans, or less air would stay if it did
    Certificate castCertificate;        ///< of `cast` as it stands in the mold's frame
    std::vector<std::string> problems;  ///< English; what of mold.md's list does not hold
    std::vector<Message> notes;         ///< what is proved but should be known

    [[nodiscard]] bool verified() const { return problems.empty() && castCertificate.holds(); }
};

/// Builds and proves the mold of certified casts. All are made larger by the same shrink and placed by their
/// own planes; all leave along the directions of the first, the others turned as that asks (furtherPart()).
/// Errors: BadInput when a cast is not certified; Impossible when a part cannot stand there or a feature
/// cannot be made, with the reason; Usage; Cancelled; Internal when a half could not be made sound.
[[nodiscard]] Result<Mold> buildMold(const Tray& tray, double draftDegrees, const MoldSettings& settings,
                                     const Task& task = {});

/// Width, depth and height of the block of that mold, mm, both halves together, without building it. Errors:
/// as those of buildMold() for casts and block.
[[nodiscard]] Result<Eigen::Vector3d> blockSize(const Tray& tray, double draftDegrees,
                                                const MoldSettings& settings);

} // namespace moldwright
