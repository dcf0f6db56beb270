// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace moldwright {

/// Exact answers about points and directions given as doubles: floating point with an error bound first,
/// rational arithmetic only where that cannot decide. Directions need not be unit.

/// Sign of det(b−a, c−a, d): +1 when a, b, c turn counter-clockwise for someone looking against d, that is,
/// when the face abc has its normal towards d; −1 clockwise; 0 when their images along d lie on one line.
[[nodiscard]] int turnAlong(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                            const Eigen::Vector3d& d);

/// Sign of q' − p' where ' is the position on one of two axes (0 or 1) of the image seen looking against d.
/// The image is sheared and scaled, which changes angles and sizes but neither turns nor what lies between.
[[nodiscard]] int compareAlong(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& d,
                               int axis);

/// The double values of those positions, for searching; off by at most 4e-16 × (sum of the magnitudes).
[[nodiscard]] Eigen::Vector2d positionAlong(const Eigen::Vector3d& p, const Eigen::Vector3d& d);

/// True when the face abc has N·d ≥ τ|d| and N·d > 0: with c = (b−a)×(c−a), c·d > 0 and
/// (c·d)² ≥ τ²|c|²|d|². False for a face of zero area.
[[nodiscard]] bool leavesAlong(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                               const Eigen::Vector3d& d, double tau);

/// (b−a)×(c−a), each component right to a few ulps of itself, however thin the face.
[[nodiscard]] Eigen::Vector3d accurateAreaVector(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                                 const Eigen::Vector3d& c);

} // namespace moldwright
