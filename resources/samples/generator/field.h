// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace moldwright::samples {

using Eigen::Vector3d;

/// A solid as a scalar field of space: negative inside, positive outside, about a distance in mm near the
/// surface (far outside only a lower bound of it). A value: small fields are composed into large ones.
using Field = std::function<double(const Vector3d&)>;

/// Value and derivatives of a field at a point.
struct Taylor {
    double value;
    Vector3d gradient;
    Eigen::Matrix3d hessian;
};

/// By central differences over `step` mm.
[[nodiscard]] Vector3d gradient(const Field& field, const Vector3d& p, double step = 1e-3);
[[nodiscard]] Taylor expand(const Field& field, const Vector3d& p, double step);

// --- Solids ---------------------------------------------------------------------------------------------

[[nodiscard]] Field ball(const Vector3d& centre, double radius);

/// Ellipsoid with semi-axes `radii` along the axes, turned by `turn` (radians about x, then y, then z).
[[nodiscard]] Field ellipsoid(const Vector3d& centre, const Vector3d& radii,
                              const Vector3d& turn = Vector3d::Zero());

/// Box of half extents `half` whose edges are rounded with `rounding` mm inside it.
[[nodiscard]] Field roundedBox(const Vector3d& centre, const Vector3d& half, double rounding);

/// About the distance of q from the ellipsoid with semi-axes `radii` at the origin: exact on the surface and
/// of unit slope there.
[[nodiscard]] double ellipticDistance(const Vector3d& q, const Vector3d& radii);

// --- Compositions ---------------------------------------------------------------------------------------

/// Smooth minimum of two distances: equal to the smaller where they differ by more than `blend`, twice
/// continuously differentiable between. blend ≥ 0, mm.
[[nodiscard]] double smoothMin(double a, double b, double blend);

/// All of the solids, with fillets of about `blend` mm where they meet.
[[nodiscard]] Field join(std::vector<Field> solids, double blend);

/// `solid` without `tool`, the new edge rounded by about `blend` mm.
[[nodiscard]] Field carve(Field solid, Field tool, double blend);

/// What both solids share, the new edge rounded by about `blend` mm.
[[nodiscard]] Field overlap(Field a, Field b, double blend);

/// The solid turned by `turn` (radians about x, then y, then z) about `pivot`.
[[nodiscard]] Field turned(Field solid, const Vector3d& turn, const Vector3d& pivot);

/// The solid moved by `offset`.
[[nodiscard]] Field moved(Field solid, const Vector3d& offset);

/// The solid's mirror image in the plane x = 0.
[[nodiscard]] Field mirrored(Field solid);

} // namespace moldwright::samples
