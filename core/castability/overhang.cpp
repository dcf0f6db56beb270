// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/overhang.h"

#include "base/stop_point.h"
#include "mesh/measures.h"

#include <algorithm>

namespace moldwright {

namespace {

std::vector<int> lookingAlong(const IndexedMesh& mesh, std::vector<int> faces, const Eigen::Vector3d& d) {
    std::erase_if(faces, [&](int f) {
        stopPointAt(f);
        return doubleAreaVector(mesh, f).dot(d) <= 0;
    });
    return faces;
}

} // namespace

Overhang::Overhang(const IndexedMesh& mesh, const std::vector<int>& faces, const Eigen::Vector3d& d)
    : m_faces(mesh, lookingAlong(mesh, faces, d), d) {}

double Overhang::above(const Eigen::Vector3d& p) const {
    thread_local std::vector<FacesAlong::Crossing> found;
    m_faces.crossings(p, found);
    double highest = 0;
    for (const FacesAlong::Crossing& crossing : found)
        highest = std::max(highest, crossing.way);
    return highest;
}

} // namespace moldwright
