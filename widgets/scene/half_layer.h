// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "scene/mesh_layer.h"

#include <Eigen/Geometry>

namespace moldwright::scene {

/// One mold half in the view, made in the mold's frame and shown in the part's, moved along its direction
/// when the mold opens.
class HalfLayer {
public:
    explicit HalfLayer(vtkRenderer* renderer) : m_layer(renderer) {}

    /// `moldToPart` places the half about the part; `direction` is its removal direction in the part's frame.
    void set(const SharedDrawnMesh& half, const Eigen::Isometry3d& moldToPart,
             const Eigen::Vector3d& direction, Rgb colour);
    void clear() { m_layer.setMesh(nullptr, {}); }

    /// Opens by `way` mm along the direction, after it was moved in the mold's frame by `moved`.
    void open(double way, const Eigen::Isometry3d& moved);

    [[nodiscard]] double way() const { return m_way; } ///< mm

    [[nodiscard]] MeshLayer& layer() { return m_layer; }
    [[nodiscard]] const MeshLayer& layer() const { return m_layer; }

    /// Its box in the mold's frame; empty while nothing is shown.
    [[nodiscard]] Eigen::AlignedBox3d box() const;
    /// Corners of its box in the part's frame, opened as it is; none while nothing is shown.
    [[nodiscard]] std::vector<Eigen::Vector3d> corners() const;

private:
    MeshLayer m_layer;
    Eigen::Isometry3d m_moldToPart = Eigen::Isometry3d::Identity();
    Eigen::Vector3d m_direction = Eigen::Vector3d::UnitZ();
    double m_way = 0;
};

} // namespace moldwright::scene
