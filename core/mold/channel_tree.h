// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "features/plan_shape.h"
#include "mold/mold_settings.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace moldwright {

/// A channel that leads from a place along a direction.
struct ChannelRay {
    Eigen::Vector2d way; ///< unit
    double half = 0;     ///< of its width, mm
};

/// Where the left side of one channel meets the right side of the next one, counter-clockwise, seen from
/// where both begin; none where the two sides are one line.
[[nodiscard]] std::optional<Eigen::Vector2d> cornerBetween(const ChannelRay& a, const ChannelRay& b);

/// A place where a channel turns, parts in two or ends over a gate, fed from where the spout is.
struct ChannelBranch {
    Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< mm
    double reach = 0;                             ///< mm from here to each of the gates that it feeds
    std::vector<ChannelBranch> feeds;             ///< none over a gate
    std::size_t copy = 0;                         ///< over a gate: of the layout's copies, whose it is
};

/// Which way channels of a tree lead on from their ends.
enum class Across { X = 0, Y = 1 };

/// Joins ends that stand beside each other along `across`, in pairs, then the pairs, level by level: `levels`
/// are the places of the channels between them, mm along the other axis, one for each time that their number
/// halves. Where two ways differ the joint stands nearer to the end of the longer one. None where that is
/// nearer than `least` mm to either end. Precondition: 2^levels ends, in order.
[[nodiscard]] std::optional<ChannelBranch> joinedInPairs(std::vector<ChannelBranch> ends, Across across,
                                                         const std::vector<double>& levels, double least);

/// That, and from there a straight piece along `across` to a place.
[[nodiscard]] ChannelBranch ledTo(ChannelBranch branch, Across across, double place);

/// Widths in a tree of channels, mm.
struct TreeWidths {
    double branch = 0;
    double trunk = 0;  ///< of what leads up from the root
    double beyond = 0; ///< that a channel goes on beyond a gate's middle
};

/// The strips of plane that a tree's channels take, without what leads up from the root.
[[nodiscard]] std::vector<PlanShape> stripsOf(const ChannelBranch& root, const TreeWidths& widths);

/// A tree of channels seen along the normal.
struct TreeOutline {
    /// Counter-clockwise from the left to the right side of what leads up from the root, which is missing.
    PlanShape shape;
    std::vector<std::size_t> edges; ///< by copy: the edge that looks down at its gate
    std::vector<double> lengths;    ///< by copy: mm from the root to the gate
};
/// `copies`: how many gates there are.
[[nodiscard]] TreeOutline outlineOf(const ChannelBranch& root, const TreeWidths& widths, std::size_t copies);

} // namespace moldwright
