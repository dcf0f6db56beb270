// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/plan_regions.h"

#include "mesh/closest_point.h"
#include "mesh/measures.h"

#include <limits>
#include <set>

namespace moldwright {

namespace {

bool isCovered(const ChoiceFace& face) {
    return face.made < 0 && face.covered >= 0;
}

} // namespace

std::vector<int> facesCovered(const FillPlan& plan, int region) {
    std::set<int> faces;
    for (const ChoiceFace& face : plan.choices.faces)
        if (isCovered(face) && face.covered == region)
            faces.insert(face.source);
    return {faces.begin(), faces.end()};
}

Triangles facesMade(const FillPlan& plan, int region) {
    std::vector<std::array<int, 3>> made;
    for (const ChoiceFace& face : plan.choices.faces)
        if (face.made == region)
            made.push_back(face.corners);
    Triangles faces(static_cast<Eigen::Index>(made.size()), 3);
    for (std::size_t f = 0; f < made.size(); ++f)
        faces.row(static_cast<Eigen::Index>(f)) << made[f][0], made[f][1], made[f][2];
    return faces;
}

int regionNearest(const FillPlan& plan, const Eigen::Vector3d& place) {
    double nearest = std::numeric_limits<double>::infinity();
    int found = -1;
    for (int region = 0; region < plan.choices.regions; ++region) {
        const std::vector<int> faces = facesCovered(plan, region);
        if (faces.empty())
            continue;
        IndexedMesh covered{plan.part.mesh.V, Triangles(static_cast<Eigen::Index>(faces.size()), 3)};
        for (std::size_t i = 0; i < faces.size(); ++i)
            covered.F.row(static_cast<Eigen::Index>(i)) = plan.part.mesh.F.row(faces[i]);
        if (const double distance = ClosestPoint(covered).distance(place); distance < nearest) {
            nearest = distance;
            found = region;
        }
    }
    return found;
}

std::vector<char> regionsThatJoin(const FillPlan& plan) {
    const Components pieces = connectedComponents(plan.part.mesh);
    std::vector<int> piece(plan.regions.size(), -1);
    std::vector<char> joins(plan.regions.size(), 0);
    for (const ChoiceFace& face : plan.choices.faces) {
        if (!isCovered(face))
            continue;
        const auto r = static_cast<std::size_t>(face.covered);
        const int own = pieces.ofFace[static_cast<std::size_t>(face.source)];
        joins[r] = joins[r] || (piece[r] >= 0 && piece[r] != own);
        piece[r] = own;
    }
    return joins;
}

std::vector<int> neededRegionsAt(const FillPlan& plan, const std::vector<int>& faces) {
    const std::set<int> asked(faces.begin(), faces.end());
    std::set<int> regions;
    for (const ChoiceFace& face : plan.choices.faces)
        if (isCovered(face) && asked.contains(face.source) &&
            plan.regions[static_cast<std::size_t>(face.covered)].needed)
            regions.insert(face.covered);
    return {regions.begin(), regions.end()};
}

} // namespace moldwright
