// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/balanced_runners.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace moldwright {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

std::size_t halvings(int count) {
    return static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(count)) - 1);
}

Result<void> checked(const LayoutSettings& settings) {
    for (const int count : {settings.rows, settings.columns})
        if (!std::has_single_bit(static_cast<unsigned>(count)))
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "Balanced runners part in two at each joint: rows and columns must "
                                   "each be 1, 2, 4, 8 or another power of two. Here there are {0} "
                                   "and {1}."),
                           {std::to_string(settings.rows), std::to_string(settings.columns)});
    if (settings.arrangement == Arrangement::Staggered)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold", "Balanced runners lead along straight columns: they need a grid, not "
                                       "rows that are moved against each other."));
    return {};
}

/// Where the gate of each kind is, in its own coordinates.
Result<std::vector<Vector2d>> tipsOf(const std::vector<CavityKind>& kinds, double gate) {
    std::vector<Vector2d> tips;
    for (const CavityKind& kind : kinds) {
        const std::vector<Gate> gates = gatesAtInlet(kind, gate);
        if (gates.size() != 1)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "Balanced runners fill each cavity at one place. This cast is of {0} "
                                   "solids: take the shortest runners, or fill it through half 1."),
                           {std::to_string(gates.size())});
        tips.push_back(gates.front().tip);
    }
    return tips;
}

/// How near a joint of two ways may stand to the end of either, mm.
double nearestJoint(const ChannelWidths& widths) {
    return widths.runner + widths.beside;
}

/// The same as it is laid out: gates are moved a little where a joint with the cavity asks for it.
double roomyJoint(const ChannelWidths& widths) {
    return nearestJoint(widths) + 0.2 * widths.gate;
}

/// What one column takes in x, from its cavities' origin; mm.
struct Column {
    double left = 0;
    double right = 0;
    std::vector<double> ways; ///< middles of the channels beside it, the one that leads up last
};

Column columnOf(const AlignedBox2d& box, const std::vector<Vector2d>& tips, const LayoutSettings& settings,
                const ChannelWidths& widths) {
    const double beyond = treeWidths(widths).beyond;
    Column column{box.min().x(), box.max().x(), {}};
    for (const Vector2d& tip : tips) {
        column.left = std::min(column.left, tip.x() - beyond);
        column.right = std::max(column.right, tip.x() + beyond);
    }
    // Small cavities stand so far apart that a channel has room between their gates.
    column.right = std::max(column.right, column.left + 2 * roomyJoint(widths) - settings.spacing);
    if (settings.rows == 1)
        return column;
    // A gate at a cavity's very edge stays clear of the first channel.
    const double first = std::max(box.max().x() + settings.spacing, column.right + 1) + widths.runner / 2;
    for (std::size_t k = 0; k <= halvings(settings.rows); ++k)
        column.ways.push_back(
            upToSixteenth(first + static_cast<double>(k) * (widths.runner + settings.spacing)));
    if (settings.columns == 1) // that is the spout's, and wider
        column.ways.back() += upToSixteenth((widths.main - widths.runner) / 2);
    column.right = column.ways.back() + widths.runner / 2;
    return column;
}

/// The channels of a layout whose gates are at `tips`.
Result<ChannelBranch> treeOver(const Layout& layout, const std::vector<Vector2d>& tips,
                               const ChannelWidths& widths) {
    const double least = nearestJoint(widths);
    const int columns = layout.copies.back().column + 1;
    std::optional<ChannelBranch> tree;
    std::vector<ChannelBranch> ends;
    for (int column = 0; column < columns; ++column) {
        std::vector<ChannelBranch> gates;
        double origin = 0;
        for (std::size_t i = 0; i < layout.copies.size(); ++i) {
            const CavityCopy& copy = layout.copies[i];
            if (copy.column != column)
                continue;
            const double axis = layout.runnerAxes[static_cast<std::size_t>(copy.row)];
            const Vector2d tip = tips[copy.kind] + copy.offset;
            gates.push_back({{tip.x(), axis}, axis - tip.y(), {}, i});
            origin = copy.offset.x();
        }
        std::vector<double> ways = layout.besideColumns;
        for (double& way : ways)
            way += origin;
        const std::optional<double> up = ways.empty() ? std::nullopt : std::optional(ways.back());
        if (up)
            ways.pop_back();
        tree = joinedInPairs(std::move(gates), Across::Y, ways, least);
        if (!tree)
            break;
        ends.push_back(up ? ledTo(*std::move(tree), Across::X, *up) : *std::move(tree));
    }
    if (tree)
        tree = joinedInPairs(std::move(ends), Across::X, layout.overColumns, least);
    if (!tree)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "The gates of every second cavity stand too far aside for runners of "
                               "one length. Take copies that are all alike, or the shortest runners."));
    return *std::move(tree);
}

} // namespace

TreeWidths treeWidths(const ChannelWidths& widths) {
    return {widths.runner, widths.main, widths.gate / 2 + widths.beside};
}

Result<Layout> balancedLayout(const std::vector<CavityKind>& kinds, const std::vector<std::size_t>& kindAt,
                              const LayoutSettings& settings, const ChannelWidths& widths) {
    if (Result<void> done = checked(settings); !done)
        return std::unexpected(done.error());
    const Result<std::vector<Vector2d>> tips = tipsOf(kinds, widths.gate);
    if (!tips)
        return std::unexpected(tips.error());
    AlignedBox2d box;
    for (const CavityKind& kind : kinds)
        for (const Vector2d& p : kind.hull)
            box.extend(p);
    const Column column = columnOf(box, *tips, settings, widths);
    LayoutSettings straight = settings;
    straight.arrangement = Arrangement::Grid;
    RunnerRoom room{widths.room().row, 0, box.min().x() - column.left + column.right - box.max().x()};
    if (settings.rows > 1)
        room.row = std::max(room.row, 2 * (roomyJoint(widths) - settings.spacing) - box.sizes().y());
    Layout layout = layoutOf(kinds, kindAt, straight, room);
    // The middle of all, channels included.
    const double low = layout.copies.front().offset.x() + column.left;
    const double high = layout.copies.back().offset.x() + column.right;
    for (CavityCopy& copy : layout.copies)
        copy.offset.x() -= upToSixteenth((low + high) / 2);
    layout.besideColumns = column.ways;
    const double pitch = widths.runner + settings.spacing;
    for (std::size_t k = 0; k < halvings(settings.columns); ++k)
        layout.overColumns.push_back(layout.runnerAxes.back() +
                                     static_cast<double>(settings.rows == 1 ? k : k + 1) * pitch);
    Result<ChannelBranch> tree = treeOver(layout, *tips, widths);
    if (!tree)
        return std::unexpected(tree.error());
    layout.tree = *std::move(tree);
    return layout;
}

Result<RunnerNet> balancedNet(const Layout& layout, const std::vector<std::vector<Stub>>& stubsOfKind,
                              const SpoutSettings& spout, const ChannelWidths& widths,
                              const ChannelRules& rules, const FaceEnd& end) {
    // Joints may have moved the gates a little: the ways are as long from where they are.
    std::vector<Vector2d> tips;
    for (const std::vector<Stub>& stubs : stubsOfKind) {
        AlignedBox2d box;
        for (const Vector2d& p : stubs.front().prism.base)
            box.extend(p);
        tips.emplace_back(box.center().x(), stubs.front().tip.y());
    }
    const Result<ChannelBranch> tree = treeOver(layout, tips, widths);
    if (!tree)
        return std::unexpected(tree.error());
    TreeOutline outline = outlineOf(*tree, treeWidths(widths), layout.copies.size());
    double top = -std::numeric_limits<double>::infinity();
    for (const Vector2d& p : outline.shape)
        top = std::max(top, p.y());
    const std::size_t mouth =
        addSpoutAbove(outline.shape, tree->at.x(), top + widths.beside, spout, widths, end);
    Result<DraftedPrism> prism =
        rules.prism(std::move(outline.shape), heightOverWidth * widths.main, {{mouth, {0, 0}}});
    if (!prism)
        return std::unexpected(prism.error());
    RunnerNet net;
    net.channels.push_back({*std::move(prism), {}, "Spout"});
    for (std::size_t i = 0; i < layout.copies.size(); ++i) {
        const CavityCopy& copy = layout.copies[i];
        const DraftedPrism& stub = stubsOfKind[copy.kind].front().prism;
        if (Result<void> done = carries(net.channels.front().prism, stub); !done)
            return std::unexpected(done.error());
        net.channels.front().guests.push_back({outline.edges[i], &stub, copy.offset});
        net.pathLengths.push_back(end.face - tree->at.y() + outline.lengths[i]);
    }
    return net;
}

} // namespace moldwright
