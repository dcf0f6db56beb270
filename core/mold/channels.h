// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "features/drafted_prism.h"
#include "mold/gates.h"
#include "mold/layout.h"
#include "mold/mold_settings.h"

#include <deque>
#include <string>
#include <vector>

namespace moldwright {

/// What all channels of one mold share.
struct ChannelRules {
    Directions directions;
    double draftDegrees = 5;               ///< of their walls, against the directions
    std::array<bool, 2> sides{true, true}; ///< on which a channel stands: not where the cavity has no depth
    double grid = 0;

    /// Inset over height of a wall whose foot looks along m: what the draft needs, and never overhanging.
    [[nodiscard]] Result<std::array<double, 2>> slope(const Eigen::Vector2d& m) const;

    /// A prism with walls as these rules ask, `height` mm on each side or as high as fits.
    [[nodiscard]] Result<DraftedPrism> prism(PlanShape base, double height,
                                             std::vector<DraftedPrism::Opening> openings) const;
};

/// Of a channel, on each side of the plane: a section near to a circle's.
inline constexpr double heightOverWidth = 0.4;

/// Widths in the parting plane that follow from the spout's, mm.
struct ChannelWidths {
    double main = 0;   ///< spout and main runner
    double runner = 0; ///< of a row
    double gate = 0;
    double beside = 0; ///< that a host reaches beyond a guest's edge, so that its own end's lean has room
    /// Errors: Impossible.
    [[nodiscard]] static Result<ChannelWidths> of(const SpoutSettings& spout, const ChannelRules& rules);
    /// Room between the cavities for all this.
    /// Length of a straight piece whose lid keeps its length beside a funnel's.
    [[nodiscard]] double straight() const { return 1.5 * beside; }
    [[nodiscard]] RunnerRoom room() const { return {runner + 2 * beside, main + 2 * beside}; }
};

/// A channel from a cavity upwards, in its kind's coordinates. It crosses the cavity's wall, so it is joined
/// to it exactly; its other end opens into a runner or the block's face.
struct Stub {
    DraftedPrism prism;
    std::string name;
    bool vent = false;
    int number = 0;                                ///< among gates or vents, from 0
    Eigen::Vector2d tip = Eigen::Vector2d::Zero(); ///< where its axis meets the parting line, mm
    double width = 0;                              ///< mm, where it meets it
};

/// A channel of the mold and what opens into it.
struct Channel {
    DraftedPrism prism;
    std::vector<Guest> guests;
    std::string name;
};

/// What is filled from the spout to the cavities but for the cavities' own stubs. Guests point into it.
struct RunnerNet {
    std::deque<Channel> channels;
    std::vector<double> pathLengths; ///< mm from the spout's mouth to each cavity's gate, by copy
};

/// Where channels end in the block's face at +y, mm: there each goes on as a short straight tail.
struct FaceEnd {
    double face = 0; ///< y of the block's face
    double line = 0; ///< y where the tail begins
    std::array<double, 2> flare{0,
                                0}; ///< how far the face goes outwards on side 1 and 2, mm per mm of height
};

/// The polygon of the spout: from `bottom` upwards `width` wide, then its full diameter, then the funnel, and
/// `straight` mm with upright sides below the tail.
[[nodiscard]] PlanShape spoutShape(double axis, double bottom, double width, double neckEnd, double top,
                                   double straight, const SpoutSettings& spout);

/// Closes an outline with a spout: its last and first corner are those of a channel `widths.main` wide that
/// leads up, about `axis`, as far as the neck's end and on from there. The edge that is its mouth.
std::size_t addSpoutAbove(PlanShape& outline, double axis, double neckEnd, const SpoutSettings& spout,
                          const ChannelWidths& widths, const FaceEnd& end);

/// Whether a stub is low enough for the wall of the channel that it opens into. Errors: Impossible.
[[nodiscard]] Result<void> carries(const DraftedPrism& channel, const DraftedPrism& stub);

/// Way in y that the spout needs from its neck's end to the tail.
[[nodiscard]] double spoutLength(const SpoutSettings& spout, double width, double straight);

/// Runners of all rows and the main runner with its spout, joined: each row's opens into the main one, each
/// stub of each copy into its row's. Errors: Impossible.
[[nodiscard]] Result<RunnerNet> runnerNet(const Layout& layout,
                                          const std::vector<std::vector<Stub>>& stubsOfKind,
                                          const SpoutSettings& spout, const ChannelWidths& widths,
                                          const ChannelRules& rules, const FaceEnd& end);

/// The tail of a channel that opens by its first opening into the block's face. What solidifies ends a little
/// below the face with a drafted wall (`closed`), while the halves are cut through.
[[nodiscard]] Result<DraftedPrism> tailOf(const DraftedPrism& channel, const ChannelRules& rules,
                                          const FaceEnd& end, bool closed);

/// How long a tail must be so that its end has the draft.
[[nodiscard]] Result<double> tailLength(double height, const ChannelRules& rules);

} // namespace moldwright
