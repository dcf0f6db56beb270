// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/channels.h"

#include <vector>

namespace moldwright {

/// From the middle of a star to where each of its arms, `arm` mm wide, stands clear of the others and of the
/// spout, `main` mm wide, that leads straight up between the first and the last of `count`.
[[nodiscard]] double starHub(int count, double arm, double main);

/// The spout straight down to the middle of a circle, and from there an arm to each cavity, in one prism: all
/// ways are equally long. The stub of each copy opens into the end of its arm. Errors: Impossible.
[[nodiscard]] Result<RunnerNet> starNet(const Layout& layout,
                                        const std::vector<std::vector<Stub>>& stubsOfKind,
                                        const SpoutSettings& spout, const ChannelWidths& widths,
                                        const ChannelRules& rules, const FaceEnd& end);

} // namespace moldwright
