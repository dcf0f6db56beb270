// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "features/drafted_prism.h"
#include "mold/free_place.h"
#include "mold/mold_settings.h"

#include <vector>

namespace moldwright {

/// A key and its socket: a frustum on half 2, and one in half 1 that is larger by the clearance.
struct RegistrationKey {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double diameter = 0;
    double leanDegrees = 0; ///< the most that its wall leans from the normal
    DraftedPrism key;       ///< stands on side 1
    DraftedPrism socket;
};

/// A notch at the block's outer edge.
struct WedgeSlit {
    DraftedPrism prism; ///< opens by its first opening into the block's face; mm, mold's frame
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
};

/// Places for `wishes.size()` keys: those by hand, the others as near as steel to everything else allows to
/// places round the block, the larger one first: each to the one that is farthest from all keys that stand,
/// or where there is no room to the next of placesRound(). So they do not crowd at the ends of a long block.
/// Fewer where there is no room there either: then the block must grow.
/// Obstacles hold what stands there by hand.
[[nodiscard]] std::vector<Eigen::Vector2d> keyPlaces(const KeySettings& keys, const Directions& directions,
                                                     const Block& block, const Obstacles& obstacles,
                                                     double steel, const Wishes& wishes, Pull pull);

/// The area that key `number` and its socket take, seen along the normal.
[[nodiscard]] PlanShape keyRoom(const KeySettings& keys, const Directions& directions, int number,
                                const Eigen::Vector2d& place);

/// A key at a place. Its walls leave along d1 and along −d2: so either half may be opened first, or both at
/// once. Errors: Impossible.
[[nodiscard]] Result<RegistrationKey> registrationKey(const KeySettings& keys, bool odd,
                                                      const Eigen::Vector2d& place,
                                                      const Directions& directions, double draftDegrees,
                                                      double grid);

/// Places for `wishes.size()` slits: those by hand, drawn onto their face, the others at the faces left and
/// right, in opposite pairs about the block's middle as far from the spout's end as from the other. Fewer
/// where there is no room. Obstacles hold what stands there by hand.
[[nodiscard]] std::vector<Eigen::Vector2d> slitPlaces(const SlitSettings& slits, const Block& block,
                                                      const Obstacles& obstacles, double steel,
                                                      const Wishes& wishes, Pull pull);

/// The mouth of a slit that was put to `wish`, on the face of the block that is meant.
[[nodiscard]] Eigen::Vector2d onFace(const Eigen::Vector2d& wish, const Block& block);

/// The area of a slit whose mouth's middle is at `place`, on the block's left or right face.
[[nodiscard]] PlanShape slitShape(const SlitSettings& slits, const Eigen::Vector2d& place);

/// A slit in both halves. Errors: Impossible.
[[nodiscard]] Result<WedgeSlit> wedgeSlit(const SlitSettings& slits, const Eigen::Vector2d& place,
                                          const Block& block, const Directions& directions,
                                          double draftDegrees, double grid);

} // namespace moldwright
