// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "design/castable_shape.h"

#include <optional>
#include <vector>

namespace moldwright {

/// A coarse stand-in for a part: a few thousand faces, the same parting line point for point.
struct Proxy {
    PartedSolid solid;         ///< in the part's working frame
    std::vector<int> pointNow; ///< per point of the part: the point of the proxy that it was merged into
};

/// How much of the part's shape a stand-in keeps.
enum class ProxyDetail { Quick, Fine };

/// The stand-in for a parted part: decimated with the points of the plane kept, so that what hangs together,
/// the labels and the parting line stay; those of important faces too, unless they are many (`faceWeights`:
/// per face of the part, empty: all 1); and more finely where the part is so thin that it would cross itself.
/// None when the part has few faces itself, or when TetGen refuses what was found.
[[nodiscard]] std::optional<Proxy> proxyOf(const PartedPart& part, ProxyDetail detail,
                                           const std::vector<double>& faceWeights, const Task& task);

/// Bends the stand-in, see bend(); the part's own surface follows. What takes time grows with the stand-in,
/// not with the part. `from`: as of bend().
[[nodiscard]] BentShape bendByProxy(const PartedPart& part, const Proxy& proxy, const ShapeGoal& goal,
                                    const Task& task, const ShapeWatch& watch,
                                    const BentShape* from = nullptr);

} // namespace moldwright
