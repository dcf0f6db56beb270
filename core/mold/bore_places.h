// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/overhang.h"
#include "mold/free_place.h"
#include "mold/layout.h"

#include <optional>
#include <utility>
#include <vector>

namespace moldwright {

/// A place at which a hole along the removal direction can enter a cavity.
struct BorePlace {
    Eigen::Vector2d axis = Eigen::Vector2d::Zero(); ///< where its axis meets the parting plane, mm
    double tip = 0;                                 ///< height of the cavity over the plane there, mm
    double inside = 0;                              ///< a height at which its whole circle lies in the cast
};

/// What a hole asks of the ground that it enters.
struct BoreNeeds {
    int side = 2;
    double diameter = 4;
    double margin = 0;   ///< mm from the parting line
    double steepest = 0; ///< degrees from square to the hole
};

/// The ground of a cavity in one half, looked over once for all holes of one width.
class BoreGround {
public:
    /// `solid`: the piece of the cast, by its number; none: all of it. The kind must outlive this.
    BoreGround(const CavityKind& kind, const Directions& directions, const BoreNeeds& needs,
               std::optional<int> solid = {});

    [[nodiscard]] const BoreNeeds& needs() const { return m_needs; }
    /// Places all over the cavity, a third of the diameter apart or wider.
    [[nodiscard]] const std::vector<BorePlace>& candidates() const { return m_candidates; }
    /// A hole with its axis there; none where the ground is too steep or the parting line too near.
    [[nodiscard]] std::optional<BorePlace> at(const Eigen::Vector2d& axis) const;
    /// Where the cast is highest under the whole circle; of equals the one nearest to their middle.
    [[nodiscard]] std::optional<BorePlace> highest() const;

private:
    [[nodiscard]] double heightAt(const Eigen::Vector2d& p) const;

    BoreNeeds m_needs;
    double m_dz;
    Overhang m_over;
    std::vector<BorePlace> m_candidates;
};

/// The ground for ejector pins, flat within 35°, and for necks of spouts through half 1, one for each solid.
[[nodiscard]] BoreGround ejectorGround(const CavityKind& kind, const Directions& directions,
                                       const EjectorSettings& ejectors, double steel);
[[nodiscard]] std::vector<BoreGround> spoutGrounds(const CavityKind& kind, const Directions& directions,
                                                   double neck);

/// Places for `wishes.size()` pins of one kind of cavity: those by hand, the others where the cast reaches
/// deep into the half, deepest first, then far from each other. These keep `steel` mm from each other and
/// from `keepOff` (points of the plane, each with a radius). Errors: Impossible, with how many found a place
/// and why not more, or why one cannot stand where it was put.
[[nodiscard]] Result<std::vector<BorePlace>>
ejectorPlaces(const BoreGround& ground, double steel,
              const std::vector<std::pair<Eigen::Vector2d, double>>& keepOff, const Wishes& wishes);

/// For each ground its highest place, or the one wished for. Errors: Impossible.
[[nodiscard]] Result<std::vector<BorePlace>> spoutPlaces(const std::vector<BoreGround>& grounds,
                                                         const Wishes& wishes);

} // namespace moldwright
