// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/half_layer.h"

#include "scene/camera.h"

namespace moldwright::scene {

void HalfLayer::set(const SharedDrawnMesh& half, const Eigen::Isometry3d& moldToPart,
                    const Eigen::Vector3d& direction, Rgb colour) {
    m_moldToPart = moldToPart;
    m_direction = direction;
    m_layer.setMesh(half, colour);
}

void HalfLayer::open(double way, const Eigen::Isometry3d& moved) {
    m_way = way;
    Eigen::Isometry3d placed = m_moldToPart * moved;
    placed.pretranslate(way * m_direction);
    m_layer.setPose(placed);
}

Eigen::AlignedBox3d HalfLayer::box() const {
    return m_layer.mesh() ? m_layer.mesh()->box : Eigen::AlignedBox3d();
}

std::vector<Eigen::Vector3d> HalfLayer::corners() const {
    std::vector<Eigen::Vector3d> corners = cornersOf(box());
    for (Eigen::Vector3d& corner : corners)
        corner = m_layer.pose() * corner;
    return corners;
}

} // namespace moldwright::scene
