// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/overlay.h"

#include <QString>

#include <optional>
#include <vector>

namespace moldwright {

/// A place on a surface, and what is known of the surface there.
struct MeasuredPoint {
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< mm
    std::optional<double> draftDegrees = {};         ///< none on a section, or while it is not measured
    std::optional<double> thickness = {};            ///< mm, square to the surface
    std::optional<QString> mapValue = {};            ///< what the colours show there, with its name and unit
};

/// Up to three places on one surface, and what lies between them; a fourth begins anew.
class Measurement {
public:
    void add(const SharedMesh& surface, const MeasuredPoint& point);
    void clear() { m_points.clear(); }

    [[nodiscard]] bool empty() const { return m_points.empty(); }
    [[nodiscard]] bool isOf(const SharedMesh& surface) const { return !empty() && surface == m_surface; }
    [[nodiscard]] std::vector<Eigen::Vector3d> path() const;

    /// From the first place to the second, mm.
    [[nodiscard]] std::optional<double> distance() const;
    /// At the second place, between the ways to the first and the third, degrees.
    [[nodiscard]] std::optional<double> angleDegrees() const;

    /// Chips at the places and between them, each place with a mark of this colour.
    [[nodiscard]] std::vector<scene::Chip> chips(scene::Rgb mark) const;
    /// All of it as lines of text, to be pasted elsewhere.
    [[nodiscard]] QString text() const;

private:
    SharedMesh m_surface;
    std::vector<MeasuredPoint> m_points;
};

/// "Draft 12.3°, thickness 4.50 mm", as far as it is known.
[[nodiscard]] QString surfaceText(const MeasuredPoint& point);

} // namespace moldwright
