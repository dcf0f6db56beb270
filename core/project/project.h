// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "design/design.h"
#include "mesh/indexed_mesh.h"
#include "mold/mold.h"
#include "mold/tray.h"
#include "project/importance.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

enum class Unit { Millimetre, Centimetre, Metre, Inch };

/// How the part was brought in and where it lies: part = placement · (scale · file).
struct Placement {
    Unit unit = Unit::Millimetre;
    double scale = 1;                                         ///< file's numbers to mm, unit included
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); ///< moved, turned, laid flat

    bool operator==(const Placement& o) const {
        return unit == o.unit && scale == o.scale && motion.matrix() == o.motion.matrix();
    }
};

/// What the designer decided; the input of design().
struct DesignSettings {
    double draftDegrees = 1;
    DirectionLimits limits;
    DirectionsChoice directionsChoice = DirectionsChoice::Automatic;
    DeformationMethod method = DeformationMethod::Default;
    FillChoice fill = FillChoice::Auto;
    unsigned seed = 1;
    double smoothing = 0.1;        ///< γ, see LiveSettings
    bool followDirections = false; ///< see LiveSettings

    bool operator==(const DesignSettings&) const = default;
};

/// What a design run made: kept in the project, since it cannot be recomputed in a blink.
struct CastResult : CertifiedCast {
    double draftDegrees = 1;
    Change change;
    std::vector<LimbMeasure> limbs;
    std::vector<RegionMeasure> regions; ///< one for each of the project's; none in files of old
    Points before; ///< n×3, mm: where each point of mesh was before it was bent; none in files of old
    int steps = 0; ///< that the run took; 0 where nobody counted them
};

/// A pin as the designer knows it.
struct NamedPin : Pin {
    std::string name; ///< empty: it goes by its number

    bool operator==(const NamedPin&) const = default;
};

/// One design of the part: what the designer decided, and what came of it.
struct Variant {
    std::string variantName = "A";
    std::optional<MoldState> state; ///< none until a plane was chosen
    bool planeChosenByHand = false;
    DesignSettings design;
    std::vector<NamedPin> pins;
    std::vector<UndercutChoice> undercuts;   ///< treated as chosen at the state's plane
    std::vector<ImportantRegion> importance; ///< where the part is to keep its shape
    std::shared_ptr<const CastResult> cast;  ///< none until a design finished
    MoldSettings mold;
    std::vector<TrayPart> furtherParts; ///< that the mold has cavities of besides this cast's

    /// Casts are equal where they are the same.
    bool operator==(const Variant&) const = default;
};

/// The whole document as one value. Heavy meshes are shared and immutable, so a copy is cheap, an edit is a
/// pure function Project → Project, and undo is exact. Derived things (draft analysis, mold, report) are not
/// in it. Of several variants the current one is the project itself: what knows nothing of the others works
/// on that one. See variants.h.
struct Project : Variant {
    std::string name;       ///< shown in the title; the part's name
    std::string number;     ///< the part's, as its drawing has it; may be empty
    std::string revision;   ///< the part's; may be empty
    std::string sourceFile; ///< where the part was read from, for people
    SharedMesh source;      ///< as read: the file's numbers
    Placement placement;
    SharedMesh part;             ///< source placed, mm; null while no part is open
    std::vector<Variant> others; ///< other designs of this part, in their order
    std::size_t place = 0;       ///< of the current one among all: how many of the others come before it

    /// Meshes and casts are equal where they are the same.
    bool operator==(const Project&) const = default;
};

} // namespace moldwright
