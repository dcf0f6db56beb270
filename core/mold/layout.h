// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "features/plan_shape.h"
#include "mesh/indexed_mesh.h"
#include "mold/channel_tree.h"
#include "mold/gates.h"
#include "mold/mold_settings.h"

#include <Eigen/Geometry>

#include <expected>
#include <optional>
#include <vector>

namespace moldwright {

/// One shape of cavity, centred where it was placed; copies of it are moved by multiples of 1/256 mm, so
/// they are the same to the bit.
struct CavityKind {
    IndexedMesh cast; ///< mold's frame, on the grid
    SideLabels labels;
    Eigen::AlignedBox3d box;             ///< round all of it
    double volume = 0;                   ///< mm³, of the cast
    PlanShape hull;                      ///< round all of it, seen along the plane's normal
    std::vector<CavityOutline> outlines; ///< its parting curves
    std::size_t part = 0;                ///< of the tray's, whose cavity it is
    bool mirrored = false;               ///< the opposite-handed part
    double turn = 0;                     ///< radians about the normal, from the cast as it was placed
    Eigen::Vector2d inlet = Eigen::Vector2d::UnitY(); ///< unit: the way from the cavity to what fills it

    /// A place of the plane turned so that the inlet is +y, and back; exact where it is already.
    [[nodiscard]] Eigen::Vector2d fromInlet(const Eigen::Vector2d& p) const {
        return {inlet.y() * p.x() - inlet.x() * p.y(), inlet.dot(p)};
    }
    [[nodiscard]] Eigen::Vector2d toInlet(const Eigen::Vector2d& p) const {
        return {inlet.y() * p.x() + inlet.x() * p.y(), inlet.y() * p.y() - inlet.x() * p.x()};
    }
    /// The outlines so turned.
    [[nodiscard]] std::vector<CavityOutline> outlinesFromInlet() const;
};

/// The gates of a kind as gatesOf() finds them in the inlet's direction. Tips and outlines are in the kind's
/// coordinates; `drop` and `exit` are along the inlet.
[[nodiscard]] std::vector<Gate> gatesAtInlet(const CavityKind& kind, double width);

/// A cavity: which kind, and where.
struct CavityCopy {
    std::size_t kind = 0;
    int row = 0;
    int column = 0;
    Eigen::Vector2d offset = Eigen::Vector2d::Zero(); ///< mm; multiples of 1/256
};

/// What a cavity of one mold must hold.
struct CavityRules {
    Directions directions; ///< mold's frame
    double draftDegrees = 1;
    double grid = 0; ///< all its coordinates are multiples of it
};

/// A kind of cavity of a cast that is certified as it is.
[[nodiscard]] CavityKind cavityKind(IndexedMesh cast, SideLabels labels);

/// The kind as it is and, where every second one is to be another, that one. A copy placed by a turn R is
/// allowed exactly when the cast leaves along R⁻¹d1 and R⁻¹d2. Errors: Impossible, with the draft it would
/// have.
[[nodiscard]] Result<std::vector<CavityKind>> withAlternate(const CavityKind& kind, const CavityRules& rules,
                                                            Alternation alternation);

/// The kind turned about the normal by an angle in radians, on the grid, or the draft in degrees that it
/// would have where the directions do not allow that: a turn R is allowed where the cast leaves along R⁻¹d1,
/// R⁻¹d2.
[[nodiscard]] std::expected<CavityKind, double> turnedKind(const CavityKind& kind, double angle,
                                                           const CavityRules& rules);

/// Room that runners take in a layout, mm; zero without.
struct RunnerRoom {
    double row = 0;    ///< between a row of cavities and the next: the runner that feeds it
    double main = 0;   ///< beside a column: the one that feeds the runners
    double column = 0; ///< beside each column: what leads from it to the spout, all of it
};

/// Where the cavities stand, the middle of all over the origin; row 0 lowest, column 0 leftmost. With runners
/// a row's cavities hang below theirs, and the main runner passes before column `mainColumn`.
struct Layout {
    std::vector<CavityCopy> copies;
    int mainColumn = 0;
    double mainAxis = 0;            ///< mm, x of the main runner
    std::vector<double> runnerAxes; ///< mm, y of the runner over each row
    /// On a circle: its middle, the ways from there to the copies, where the channels along them end, and how
    /// far each copy's gate is from the middle, mm.
    Eigen::Vector2d hub = Eigen::Vector2d::Zero();
    std::vector<Eigen::Vector2d> arms;
    double armEnd = 0;
    std::vector<double> tipRadii;
    /// In rows with runners, by kind: y of a row's runner less that of a cavity's offset, mm. Smaller kinds
    /// hang as near to their runner as larger ones.
    std::vector<double> runnerOverKind;
    /// Where all channels are of one length: those beside each column, x from its cavities' offset, and those
    /// over all columns, y; mm. The tree that they are.
    std::vector<double> besideColumns;
    std::vector<double> overColumns;
    std::optional<ChannelBranch> tree;
};

/// Kinds in rows and columns. `kindAt`: which kind each place has, row by row.
[[nodiscard]] Layout layoutOf(const std::vector<CavityKind>& kinds, const std::vector<std::size_t>& kindAt,
                              const LayoutSettings& settings, const RunnerRoom& room);

/// The nearest place where a copy may stand: a multiple of 1/256 mm, which is one of every grid.
[[nodiscard]] Eigen::Vector2d onCopyStep(const Eigen::Vector2d& place);

/// Moves all of a layout so that the middle of its cavities is over the origin.
void centreLayout(Layout& layout, const std::vector<CavityKind>& kinds);

/// A length as the next multiple of 1/16 mm.
[[nodiscard]] double upToSixteenth(double length);

} // namespace moldwright
