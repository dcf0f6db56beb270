// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/nesting.h"

#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

struct Part {
    std::vector<int> faces;
    Eigen::AlignedBox3d box;
};

std::vector<Part> partsOf(const IndexedMesh& mesh, const Components& components) {
    std::vector<Part> parts(static_cast<std::size_t>(components.count));
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Part& part = parts[static_cast<std::size_t>(components.ofFace[static_cast<std::size_t>(f)])];
        part.faces.push_back(f);
        for (int k = 0; k < 3; ++k)
            part.box.extend(mesh.corner(f, k));
    }
    return parts;
}

/// Half the solid angle under which face abc is seen from the origin. [Van Oosterom and Strackee 1983]
double halfSolidAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    return std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

bool contains(const IndexedMesh& mesh, const Part& part, const Eigen::Vector3d& p) {
    // In units of the part's size, so that the products neither vanish nor overflow.
    const double size = part.box.diagonal().maxCoeff();
    double sum = 0;
    for (const int f : part.faces)
        sum += halfSolidAngle((mesh.corner(f, 0) - p) / size, (mesh.corner(f, 1) - p) / size,
                              (mesh.corner(f, 2) - p) / size);
    return std::abs(sum) > std::numbers::pi; // 2π inside, 0 outside
}

} // namespace

std::vector<double> componentVolumes(const IndexedMesh& mesh, const Components& components) {
    std::vector<double> volumes(static_cast<std::size_t>(components.count), 0);
    std::vector<int> firstFace(volumes.size(), -1);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const auto c = static_cast<std::size_t>(components.ofFace[static_cast<std::size_t>(f)]);
        if (firstFace[c] < 0)
            firstFace[c] = f;
        const Eigen::Vector3d origin = mesh.corner(firstFace[c], 0);
        volumes[c] +=
            (mesh.corner(f, 0) - origin).dot((mesh.corner(f, 1) - origin).cross(mesh.corner(f, 2) - origin)) /
            6;
    }
    return volumes;
}

std::vector<int> componentsInsideOthers(const IndexedMesh& mesh, const Components& components) {
    const std::vector<Part> parts = partsOf(mesh, components);
    std::vector<int> inside;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < parts.size(); ++j)
            if (i != j && parts[j].box.contains(parts[i].box) &&
                contains(mesh, parts[j], mesh.corner(parts[i].faces[0], 0))) {
                inside.push_back(static_cast<int>(i));
                break;
            }
    return inside;
}

} // namespace moldwright
