// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/half_layer.h"

#include "scene/camera.h"

namespace moldwright::scene {

void HalfLayer::set(const SharedDrawnMesh& half, const Eigen::Isometry3d& moldToPart,
                    const Eigen::Vector3d& direction, Rgb colour) {
    m_moldToPart = moldToPart;
    m_direction = direction;
    m_layer.setMesh(half, colour);
    open(m_way);
}

void HalfLayer::open(double way) {
    m_way = way;
    Eigen::Isometry3d placed = m_moldToPart;
    placed.pretranslate(way * m_direction);
    m_layer.setPose(placed);
}

std::vector<Eigen::Vector3d> HalfLayer::corners() const {
    if (!m_layer.mesh())
        return {};
    std::vector<Eigen::Vector3d> corners = cornersOf(m_layer.mesh()->box);
    for (Eigen::Vector3d& corner : corners)
        corner = m_moldToPart * corner + m_way * m_direction;
    return corners;
}

} // namespace moldwright::scene
