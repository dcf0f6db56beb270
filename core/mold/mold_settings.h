// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "materials/material.h"
#include "mold/placed_feature.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// How a linear shrink S becomes a factor: both are in use, at 5 % they are 1.0500 and 1.0526.
enum class ShrinkFormula {
    Plus,  ///< 1 + S
    Divide ///< 1/(1 − S)
};

/// The cavity is made larger by what the material shrinks.
struct ShrinkSettings {
    Eigen::Vector3d percent =
        Eigen::Vector3d::Zero(); ///< linear, along x, y, z of the part's frame; < 0 expands
    ShrinkFormula formula = ShrinkFormula::Plus;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< mm, part's frame: the point that stays

    bool operator==(const ShrinkSettings&) const = default;
};

/// How the cavities of one mold are arranged.
enum class Arrangement {
    Grid,      ///< rows and columns
    Staggered, ///< every second row moved by half a column
    Packed,    ///< rows and columns as close as the outlines allow
    Circle,    ///< rows × columns of them on a circle; a spout in the plane fills all from its middle
    Free       ///< where `places` says; each has its own spout
};

/// Where a cavity of a free layout stands.
struct CavityPlace {
    double x = 0;    ///< mm in the parting plane, from any origin: the mold lies about all of them
    double y = 0;    ///< mm
    double turn = 0; ///< degrees about the plane's normal, counter-clockwise seen from side 1

    bool operator==(const CavityPlace&) const = default;
};

/// What every second cavity of a row is.
enum class Alternation {
    None,   ///< the same, moved: always allowed
    Turn,   ///< turned by 180° about the plane's normal
    Flip,   ///< turned over: the halves swap
    Mirror, ///< the opposite-handed part
};

struct LayoutSettings {
    int rows = 1;
    int columns = 1;
    Arrangement arrangement = Arrangement::Grid;
    Alternation alternation = Alternation::None;
    double spacing = 5;                ///< steel between cavities, and between them and channels, mm
    std::vector<CavityPlace> places{}; ///< of a free layout: one for each cavity

    bool operator==(const LayoutSettings&) const = default;
};

/// Which way is up while the mold is filled, as a turn of the cast about the normal of the parting plane: the
/// spout always leaves through the face at +y of the mold's frame.
enum class PourDirection {
    Automatic, ///< of four the one that traps the least air
    Turn0,
    Turn90,
    Turn180,
    Turn270,
};

/// How the mold rests while it is filled.
enum class Resting {
    Standing, ///< on its edge: the spout lies in the parting plane
    Lying     ///< flat, half 1 above: a spout through half 1 for each solid of each cavity
};

/// How the channels from one spout in the parting plane to several cavities in rows and columns are laid.
enum class Runners {
    Shortest, ///< one along each row, and one that feeds these: the ways differ
    Balanced  ///< parted in two again and again: all ways are equally long, so the cavities fill together
};

/// How the mold leans while it is filled, so that less air stays in it.
struct PourTilt {
    bool automatic = false; ///< as found best; the numbers are not asked
    double degrees = 0;     ///< that its top leans
    double towards = 0;     ///< degrees about its axis: 0 to the right (+x of the mold's frame), 90 where it
                            ///< stands to half 1 (+z), where it lies to the back (+y)

    bool operator==(const PourTilt&) const = default;
};

/// A spout in the parting plane with its funnel, and with several cavities the runners between them. Sections
/// are drafted trapezoids: half a circle would have no draft at its rim.
struct SpoutSettings {
    bool on = false;
    double diameter = 10; ///< width in the parting plane, mm
    double funnel = 16;   ///< width at the block's face, mm
    double gate = 6;      ///< width where it meets the cavity, mm
    double draft = 5;     ///< degrees
    PourDirection pour = PourDirection::Automatic;
    Resting resting = Resting::Standing;
    double neck = 4; ///< mm; a spout through a half widens outwards, so it must break off here
    PourTilt tilt;
    Runners runners = Runners::Shortest; ///< on a circle all ways are equally long in any case

    bool operator==(const SpoutSettings&) const = default;
};

/// Vents where air would stay.
struct VentSettings {
    bool on = false;
    double diameter = 1.5;   ///< mm, at the narrowest
    double smallestTrap = 5; ///< mm³ of air that may stay
    double depth = 0; ///< mm, of vents in the parting plane, both halves together; 0: as a spout's, by width

    bool operator==(const VentSettings&) const = default;
};

/// Closed wells in the parting plane beside the cavity, each joined to it by a thin channel: they take the
/// material that is cold or full of air by the time it gets there.
struct OverflowSettings {
    int count = 0;        ///< for each solid of each cavity
    double diameter = 6;  ///< mm, of the well in the parting plane
    double channel = 1.5; ///< mm, the channel's width there; 0.3 of the well's at most
    double length = 2.5;  ///< mm between the cavity and the well

    bool operator==(const OverflowSettings&) const = default;
};

/// Frusta on half 2 in sockets of half 1. The first is larger, so that the halves fit one way only.
struct KeySettings {
    int count = 0;
    double diameter = 6;    ///< mm at the plane
    double height = 3.5;    ///< mm
    double clearance = 0.2; ///< mm on all sides and in depth
    double draft = 5;       ///< degrees against both opening orders; raised where the mold's draft is more
    double oddBy = 1;       ///< mm that the first is larger

    bool operator==(const KeySettings&) const = default;
};

/// Notches at the outer edge of the plane in which a screwdriver finds hold ([Stein 2019], Fig. 17).
struct SlitSettings {
    int count = 0;
    double depth = 6.35; ///< mm into the block
    double width = 12;   ///< mm along its face
    double height = 1.5; ///< mm in each half

    bool operator==(const SlitSettings&) const = default;
};

/// Straight holes through both halves along the plane's normal, for bolts or clamps. Shop practice: a hole
/// keeps at least 1 mm of steel to the block's faces and to the cavities.
struct BoltSettings {
    int count = 0;
    double diameter = 6.6; ///< mm; an M6 bolt passes freely (ISO 273, medium)
    double wall = 3;       ///< mm of steel to the block's faces
    double clear = 3;      ///< mm of steel to all that stands in the parting plane

    bool operator==(const BoltSettings&) const = default;
};

/// Holes for pins that push the cast out of a half, along its removal direction.
struct EjectorSettings {
    int count = 0;       ///< for each cavity
    double diameter = 4; ///< mm
    int side = 2;        ///< the half that they pass through

    bool operator==(const EjectorSettings&) const = default;
};

/// What an insert looks like along the normal.
enum class PocketShape {
    Round,     ///< a magnet, a dowel
    Hexagon,   ///< a nut
    Rectangle, ///< a block magnet, a square nut
};

/// Pockets in the parting face in which inserts of metal are laid.
struct PocketSettings {
    int count = 0;
    PocketShape shape = PocketShape::Hexagon;
    double width = 10;      ///< mm; diameter, across flats, or along y; an M6 nut has 10 (ISO 4032)
    double length = 20;     ///< mm, of a rectangle, along x
    double depth = 5.5;     ///< mm
    double clearance = 0.1; ///< mm on all sides
    int side = 2;           ///< the half that they are in; 0: both, as a dowel asks

    [[nodiscard]] bool isIn(int half) const { return side == 0 || side == half; }
    bool operator==(const PocketSettings&) const = default;
};

/// Lettering engraved in the back of each half.
struct PlaqueSettings {
    /// Lines with '|' between; "{half}" and "{shrink}" stand for the half's number and the percentage. Empty:
    /// none.
    std::string text;
    double height = 0;  ///< mm of a capital; 0: as large as there is room for, up to 8
    double depth = 0.6; ///< mm

    bool operator==(const PlaqueSettings&) const = default;
};

/// Casting that is poured out again before it is solid all through, as chocolate shells are.
struct HollowSettings {
    double wall = 0; ///< mm that stay; 0: solid

    bool operator==(const HollowSettings&) const = default;
};

/// What the mold is made and closed by. 0: not known, and not compared with.
struct MachineSettings {
    Eigen::Vector3d bed = Eigen::Vector3d::Zero(); ///< mm, width, depth and height that the printer can make
    double clamp = 0;                              ///< kN that the press closes with

    bool operator==(const MachineSettings&) const = default;
};

/// The block's outline in the parting plane.
enum class BlockShape {
    Box,  ///< a rectangle
    Shell ///< cut down to what it holds: convex, with the walls' thickness all round
};

/// What a mold is made of. Lengths in mm. Walls of 5 mm are what open mold generators use for printed molds
/// (range 1.5 to 25 mm). As it stands: a block round one cavity, no features.
struct MoldSettings {
    double wall = 5;    ///< steel between cavities or channels and each side face
    double floor = 5;   ///< under the cavities of half 2
    double ceiling = 5; ///< over the cavities of half 1
    double step = 1;    ///< block sizes round up to a multiple of this; 0: not rounded
    BlockShape shape = BlockShape::Box;
    /// Degrees that the outer faces widen from the parting plane to the back, against the removal directions:
    /// a half that is cast itself then leaves its form. Below 0 they narrow: it leaves a frame the other way.
    double outerDraft = 0;
    double pressure = 4;   ///< bar in the cavity while it fills, for the clamp force; set it to your process
    double leastSteel = 2; ///< between any two features: what is placed automatically keeps it
    double density = 0;    ///< g/cm³ of what is cast; 0: not known
    double blockDensity = 0; ///< g/cm³ of the block; 0: not known
    LayoutSettings layout;
    ShrinkSettings shrink;
    SpoutSettings spout;
    VentSettings vents;
    OverflowSettings overflows;
    KeySettings keys;
    SlitSettings slits;
    BoltSettings bolts;
    EjectorSettings ejectors;
    PocketSettings pockets;
    PlaqueSettings plaque;
    HollowSettings hollow;
    MachineSettings machines;
    std::optional<Material> material; ///< that was chosen; what it asks for stands above, see withMaterial()
    PlacedFeatures placed;            ///< what stands where a hand put it; the rest finds its own place
    std::vector<double> stock;        ///< lengths and widths of blocks that are to be had, mm; empty: any

    bool operator==(const MoldSettings&) const = default;
};

} // namespace moldwright
