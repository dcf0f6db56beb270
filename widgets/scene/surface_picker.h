// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "mesh/indexed_mesh.h"
#include "scene/camera.h"

#include <memory>
#include <optional>

namespace moldwright::scene {

/// Finds what a ray meets on a surface. Building it takes about 0.5 µs a face, a ray about 0.01 ms.
class SurfacePicker {
public:
    struct Hit {
        int face = -1; ///< −1: of a section
        Eigen::Vector3d point;
    };

    explicit SurfacePicker(SharedMesh mesh);
    ~SurfacePicker();
    SurfacePicker(const SurfacePicker&) = delete;
    SurfacePicker& operator=(const SurfacePicker&) = delete;

    /// The first face along the ray's whole line, if any. With a cut, everything before that plane (n·x > o)
    /// is away, and a section that is met counts as a hit without a face.
    [[nodiscard]] std::optional<Hit> pick(const Ray& ray,
                                          const std::optional<PartingPlane>& cut = std::nullopt) const;

    /// The middle between a hit of the ray and where the ray leaves the solid again: of the points under the
    /// pointer the one farthest inside. None where it does not leave.
    [[nodiscard]] std::optional<Eigen::Vector3d> middleBelow(const Hit& hit, const Ray& ray) const;

    /// How far a point is from the surface, mm.
    [[nodiscard]] double distance(const Eigen::Vector3d& point) const;

    /// How thick the solid is below a hit on a face, square to the face, mm.
    [[nodiscard]] std::optional<double> thickness(const Hit& hit) const;

    [[nodiscard]] const SharedMesh& mesh() const { return m_mesh; }

private:
    struct Locator;
    /// The first face at or beyond `start` mm along the ray.
    [[nodiscard]] std::optional<Hit> firstFrom(const Ray& ray, double start) const;

    SharedMesh m_mesh;
    std::unique_ptr<Locator> m_locator;
};

} // namespace moldwright::scene
