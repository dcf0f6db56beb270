// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/opened_mold.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace moldwright::scene {

namespace {

constexpr double openShare = 0.5; ///< of the part's diagonal, each half
constexpr double besideGap = 0.1; ///< between the halves, of their width

/// The direction of the mold's plane that is up for one who looks at it with the part's z up: where the plane
/// lies level, the way to the spout.
Eigen::Vector3d upInPlane(const Eigen::Isometry3d& moldToPart) {
    const Eigen::Vector3d z = moldToPart.linear().row(2).transpose(); // in the mold's frame
    constexpr double level = 0.7;
    if (std::abs(z.z()) > level)
        return Eigen::Vector3d::UnitY();
    const int axis = std::abs(z.x()) > std::abs(z.y()) ? 0 : 1;
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
    up[axis] = z[axis] < 0 ? -1 : 1;
    return up;
}

} // namespace

Opening openingAt(double share) {
    return {std::min(2 * share, 1.0), std::max(2 * share - 1, 0.0)};
}

void OpenedMold::set(const std::array<SharedDrawnMesh, 2>& halves, const Eigen::Isometry3d& moldToPart,
                     const Directions& directions, const std::array<Rgb, 2>& colours) {
    for (const int side : {1, 2}) {
        const auto i = static_cast<std::size_t>(side - 1);
        if (halves[i])
            m_halves[i].set(halves[i], moldToPart, directions.of(side), colours[i]);
        else
            m_halves[i].clear();
    }
    m_spine = upInPlane(moldToPart);
    place();
}

void OpenedMold::open(const Opening& opening, double size) {
    m_opening = opening;
    m_size = size;
    place();
}

void OpenedMold::place() {
    const double way = m_opening.apart * (1 - m_opening.beside) * openShare * m_size;
    m_halves[0].open(way, turnedOverBy(m_opening.beside * std::numbers::pi));
    m_halves[1].open(way, Eigen::Isometry3d::Identity());
}

Eigen::Isometry3d OpenedMold::turnedOverBy(double angle) const {
    Eigen::AlignedBox3d box = m_halves[0].box();
    box.extend(m_halves[1].box());
    if (box.isEmpty())
        return Eigen::Isometry3d::Identity();
    // About a line in the parting plane a little beside the block: its own parting face is up then.
    const Eigen::Vector3d aside = m_spine.cross(Eigen::Vector3d::UnitZ());
    const double width = box.sizes().dot(aside.cwiseAbs());
    const double edge = box.center().dot(aside) + width / 2;
    const Eigen::Translation3d toSpine((edge + besideGap / 2 * width) * aside);
    return toSpine * Eigen::AngleAxisd(angle, m_spine) * toSpine.inverse();
}

std::vector<Eigen::Vector3d> OpenedMold::corners() const {
    std::vector<Eigen::Vector3d> corners = m_halves[0].corners();
    std::ranges::copy(m_halves[1].corners(), std::back_inserter(corners));
    return corners;
}

} // namespace moldwright::scene
