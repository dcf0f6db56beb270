// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/channels.h"

#include <vector>

namespace moldwright {

/// A grid with room for channels of one length to all cavities: `tree` of the result. From each gate a
/// channel leads aside, joined in pairs beside its column; those of the columns are joined in pairs over all
/// of them. Errors: Impossible, where rows or columns are no power of two or do not stand straight, where a
/// cavity has several gates, or those of cavities that are not alike stand too far apart.
/// `kindAt`: as layoutOf() takes it.
[[nodiscard]] Result<Layout> balancedLayout(const std::vector<CavityKind>& kinds,
                                            const std::vector<std::size_t>& kindAt,
                                            const LayoutSettings& settings, const ChannelWidths& widths);

/// Widths in such a tree.
[[nodiscard]] TreeWidths treeWidths(const ChannelWidths& widths);

/// The spout and the tree in one prism; the stub of each copy opens into the channel over it. Errors:
/// Impossible.
[[nodiscard]] Result<RunnerNet> balancedNet(const Layout& layout,
                                            const std::vector<std::vector<Stub>>& stubsOfKind,
                                            const SpoutSettings& spout, const ChannelWidths& widths,
                                            const ChannelRules& rules, const FaceEnd& end);

} // namespace moldwright
