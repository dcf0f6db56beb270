// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/brush_layer.h"

#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace moldwright::scene {

void BrushLayer::addTo(vtkRenderer* renderer) {
    renderer->AddViewProp(m_edge.actor());
    renderer->AddViewProp(m_line.actor());
}

void BrushLayer::setScale(double scale) {
    m_edge.setLook(Rgb::hex(0xFFFFFF), 3.6 * scale);
    m_line.setLook(Rgb::hex(0x14181D), 1.6 * scale);
}

void BrushLayer::set(const std::vector<Eigen::Vector3d>& places) {
    m_places = places;
    m_edge.set(places);
    m_line.set(places);
}

std::vector<Eigen::Vector3d> circleAbout(const Eigen::Vector3d& middle, const Eigen::Vector3d& normal,
                                         double radius) {
    constexpr int points = 64;
    const Eigen::Vector3d u = normal.unitOrthogonal();
    const Eigen::Vector3d v = normal.cross(u);
    std::vector<Eigen::Vector3d> circle;
    for (int i = 0; i <= points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        circle.emplace_back(middle + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return circle;
}

} // namespace moldwright::scene
