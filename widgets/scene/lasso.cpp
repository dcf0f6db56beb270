// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/lasso.h"

#include "base/task.h"
#include "mesh/measures.h"
#include "scene/surface_picker.h"

namespace moldwright::scene {

bool isInside(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& pixel) {
    bool inside = false;
    for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
        const Eigen::Vector2d& a = line[i];
        const Eigen::Vector2d& b = line[j];
        if ((a.y() > pixel.y()) != (b.y() > pixel.y()) &&
            pixel.x() < a.x() + (b.x() - a.x()) * (pixel.y() - a.y()) / (b.y() - a.y()))
            inside = !inside;
    }
    return inside;
}

std::vector<int> facesIn(const Lasso& lasso, const SharedMesh& mesh, const Task& task) {
    // A picker of its own: one that a view uses meanwhile must not be shared between threads.
    const SurfacePicker picker(mesh);
    std::vector<int> faces;
    for (int f = 0; f < mesh->faceCount(); ++f) {
        if (f % 1024 == 0 && task.stopped())
            return {};
        const Eigen::Vector3d middle = (mesh->corner(f, 0) + mesh->corner(f, 1) + mesh->corner(f, 2)) / 3;
        const Eigen::Vector2d pixel = lasso.camera.project(middle, lasso.view).head<2>();
        if (!isInside(lasso.line, pixel))
            continue;
        const Ray ray = lasso.camera.rayAt(pixel.x(), pixel.y(), lasso.view);
        if (doubleAreaVector(*mesh, f).dot(ray.direction) >= 0)
            continue;
        if (const auto hit = picker.pick(ray, lasso.cut); hit && hit->face == f)
            faces.push_back(f);
    }
    return faces;
}

} // namespace moldwright::scene
