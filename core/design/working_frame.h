// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"

#include <Eigen/Geometry>

namespace moldwright {

/// Where the numerics live: the part centred and scaled to a diagonal of 1, the parting plane at z = 0, side
/// 1 up. x_work = R (x − centre)/scale + shift.
class WorkingFrame {
public:
    WorkingFrame(const IndexedMesh& part, const MoldState& state);

    [[nodiscard]] IndexedMesh toWork(const IndexedMesh& part) const;
    [[nodiscard]] IndexedMesh toPart(const IndexedMesh& work) const;
    [[nodiscard]] Eigen::Vector3d toWork(const Eigen::Vector3d& x) const;
    [[nodiscard]] Eigen::Vector3d toPart(const Eigen::Vector3d& x) const;
    [[nodiscard]] Directions directionsToWork(const Directions& d) const;

    /// mm per unit of length here.
    [[nodiscard]] double scale() const { return m_scale; }

private:
    Eigen::Vector3d m_centre;
    double m_scale;
    Eigen::Matrix3d m_rotation;
    Eigen::Vector3d m_shift;
};

} // namespace moldwright
