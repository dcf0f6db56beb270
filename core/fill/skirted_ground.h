// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fill/face_grid.h"
#include "fill/skirts.h"

#include <optional>

namespace moldwright {

/// A filled half and the skirts that lean against it, to be asked for heights anywhere. Holds a reference to
/// the field.
class SkirtedGround {
public:
    /// Heights that differ by less (grid steps) count as the same.
    static constexpr double sameHeight = 2;

    SkirtedGround(const HeightField& field, const DraftCone& cone, const DraftCone& limit);

    [[nodiscard]] const HeightField& field() const { return m_field; }
    [[nodiscard]] const DraftCone& cone() const { return m_cone; }
    [[nodiscard]] const Skirts& skirts() const { return m_skirts; }

    /// Height of the field at p, the higher one at a wall.
    [[nodiscard]] double groundAt(const Eigen::Vector2d& p) const;

    /// The height of the skirts at p, or where they lie below it `ground`.
    [[nodiscard]] double leanedAt(const Eigen::Vector2d& p, double ground) const;
    [[nodiscard]] double leanedAt(const Eigen::Vector2d& p) const { return leanedAt(p, groundAt(p)); }

    /// Whether a skirt lies above `ground` at p.
    [[nodiscard]] bool coveredAt(const Eigen::Vector2d& p, double ground) const {
        return leanedAt(p, ground) > ground;
    }

    /// The face of the part that is seen at p, if it has this height there; else −1.
    [[nodiscard]] int seenAt(const Eigen::Vector2d& p, double height) const;

private:
    const HeightField& m_field;
    DraftCone m_cone;
    ProjectedHalf m_half; ///< the field's triangles, to be found by place
    FaceGrid m_grid;
    Skirts m_skirts;
};

/// Where the skirts' lines from a point of a rim reach the ground: square to its walls and down its steep
/// triangles, in fans about convex corners, along the middle of hollow ones. No nearer than `nearest`.
[[nodiscard]] std::vector<Eigen::Vector2d> feetOf(const SkirtedGround& ground, HeightField::Vertex v,
                                                  double nearest);

} // namespace moldwright
