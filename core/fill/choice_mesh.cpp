// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/choice_mesh.h"

#include "fill/mesh_difference.h"
#include "mesh/point_rows.h"
#include "mesh/union_find.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>

namespace moldwright {

namespace {

double signedVolume(const ChoiceMesh& choices, const ChoiceFace& face, const Eigen::Vector3d& origin) {
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
        return choices.points[static_cast<std::size_t>(face.corners[k])] - origin;
    };
    return corner(0).dot(corner(1).cross(corner(2))) / 6;
}

/// A closed part of a region's boundary; a solid within the region has a negative volume.
struct Shell {
    Eigen::AlignedBox3d box;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double volume = 0;
    int region = -1;
};

/// Faces that share an edge hang together, whether both can be there at once or not.
UnionFind hangingTogether(const ChoiceMesh& choices, const std::vector<int>& faces) {
    UnionFind groups(static_cast<int>(faces.size()));
    std::vector<std::array<int, 3>> sides; ///< an edge's points, a face at it
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const ChoiceFace& face = choices.faces[static_cast<std::size_t>(faces[i])];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(face.corners[k], face.corners[(k + 1) % 3]);
            sides.push_back({a, b, static_cast<int>(i)});
        }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i)
        if (sides[i][0] == sides[i - 1][0] && sides[i][1] == sides[i - 1][1])
            groups.unite(sides[i][2], sides[i - 1][2]);
    return groups;
}

/// Takes out pairs of faces that lie back to back on the same points: what is between them has no space.
void dropDoubled(const ChoiceMesh& choices, std::vector<int>& surface) {
    std::map<std::array<int, 3>, int> open; ///< by the corners from the lowest on: the face's place
    std::vector<char> dropped(surface.size(), 0);
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const ChoiceFace& face = choices.faces[static_cast<std::size_t>(surface[i])];
        if (face.made < 0)
            continue;
        std::array<int, 3> c = face.corners;
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        if (const auto back = open.find({c[0], c[2], c[1]}); back != open.end()) {
            dropped[i] = dropped[static_cast<std::size_t>(back->second)] = 1;
            open.erase(back);
        } else {
            open.emplace(c, static_cast<int>(i));
        }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (!dropped[i])
            surface[kept++] = surface[i];
    surface.resize(kept);
}

} // namespace

ChoiceMesh choicesBetween(const PartedMesh& part, const PartedMesh& filled) {
    const MeshDifference difference = meshDifference(part, filled);
    ChoiceMesh choices;
    choices.regions = difference.patches;
    for (Eigen::Index v = 0; v < difference.points.rows(); ++v)
        choices.points.emplace_back(difference.points.row(v).transpose());
    choices.partPoint.assign(choices.points.size(), -1);
    for (int f = 0; f < part.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            choices.partPoint[static_cast<std::size_t>(difference.faces[0](f, k))] = part.mesh.F(f, k);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t f = 0; f < difference.patchOf[m].size(); ++f) {
            const int patch = difference.patchOf[m][f];
            if (patch < 0 && m == 1)
                continue;
            const Eigen::RowVector3i c = difference.faces[m].row(static_cast<Eigen::Index>(f));
            const PartedMesh& mesh = m == 0 ? part : filled;
            choices.faces.push_back({{c[0], c[1], c[2]},
                                     mesh.labels[f],
                                     m == 0 ? static_cast<int>(f) : mesh.sourceFace[f],
                                     m == 0 ? -1 : patch,
                                     m == 0 ? patch : -1});
        }
    return choices;
}

std::vector<double> volumesOf(const ChoiceMesh& choices) {
    std::vector<double> volumes(static_cast<std::size_t>(choices.regions), 0);
    // About a point of the region itself, so that small volumes far out do not cancel.
    std::vector<int> origin(volumes.size(), -1);
    for (const ChoiceFace& face : choices.faces)
        for (const int region : {face.made, face.covered}) {
            if (region < 0 || bounds(face, region) == 0)
                continue;
            int& first = origin[static_cast<std::size_t>(region)];
            first = first < 0 ? face.corners[0] : first;
            volumes[static_cast<std::size_t>(region)] +=
                bounds(face, region) *
                signedVolume(choices, face, choices.points[static_cast<std::size_t>(first)]);
        }
    return volumes;
}

void renumber(ChoiceMesh& choices, const std::vector<int>& number) {
    const auto isGone = [&](int region) {
        return region >= 0 && number[static_cast<std::size_t>(region)] < 0;
    };
    std::erase_if(choices.faces, [&](const ChoiceFace& face) { return isGone(face.made); });
    for (ChoiceFace& face : choices.faces)
        for (int* region : {&face.made, &face.covered})
            if (*region >= 0)
                *region = number[static_cast<std::size_t>(*region)];
    choices.regions = number.empty() ? 0 : std::max(*std::max_element(number.begin(), number.end()) + 1, 0);
}

std::vector<int> numberByVolume(ChoiceMesh& choices, double nothing) {
    const std::vector<double> volumes = volumesOf(choices);
    std::vector<int> order;
    for (std::size_t r = 0; r < volumes.size(); ++r)
        if (volumes[r] > nothing)
            order.push_back(static_cast<int>(r));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return volumes[static_cast<std::size_t>(a)] > volumes[static_cast<std::size_t>(b)];
    });
    std::vector<int> number(volumes.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i)
        number[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    renumber(choices, number);
    return number;
}

void numberByVolume(ChoiceMesh& choices, std::vector<char>& marks, double nothing) {
    const std::vector<int> number = numberByVolume(choices, nothing);
    std::vector<char> known(static_cast<std::size_t>(choices.regions), 0);
    for (std::size_t r = 0; r < number.size(); ++r)
        if (number[r] >= 0)
            known[static_cast<std::size_t>(number[r])] = marks[r];
    marks = std::move(known);
}

std::vector<int> separateShells(ChoiceMesh& choices, int region) {
    std::vector<int> faces;
    for (std::size_t f = 0; f < choices.faces.size(); ++f)
        if (choices.faces[f].made == region || choices.faces[f].covered == region)
            faces.push_back(static_cast<int>(f));
    UnionFind groups = hangingTogether(choices, faces);
    std::map<int, Shell> shells;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const ChoiceFace& face = choices.faces[static_cast<std::size_t>(faces[i])];
        Shell& shell = shells[groups.rootOf(static_cast<int>(i))];
        if (shell.box.isEmpty())
            shell.origin = choices.points[static_cast<std::size_t>(face.corners[0])];
        shell.volume += bounds(face, region) * signedVolume(choices, face, shell.origin);
        for (const int v : face.corners)
            shell.box.extend(choices.points[static_cast<std::size_t>(v)]);
    }
    const auto largest = std::max_element(shells.begin(), shells.end(), [](const auto& a, const auto& b) {
        return a.second.volume < b.second.volume;
    });
    largest->second.region = region;
    std::vector<int> regions{region};
    for (auto& [root, shell] : shells)
        if (shell.region < 0 && shell.volume > 0) {
            shell.region = choices.regions++;
            regions.push_back(shell.region);
        }
    // A solid within the space goes with what is about it.
    for (auto& [root, shell] : shells) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [other, about] : shells)
            if (shell.volume <= 0 && about.volume > 0 && about.box.contains(shell.box) &&
                about.volume < least) {
                least = about.volume;
                shell.region = about.region;
            }
        if (shell.region < 0)
            shell.region = region;
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
        ChoiceFace& face = choices.faces[static_cast<std::size_t>(faces[i])];
        (face.made == region ? face.made : face.covered) =
            shells.at(groups.rootOf(static_cast<int>(i))).region;
    }
    return regions;
}

PartedMesh surfaceWith(const ChoiceMesh& choices, const std::vector<char>& filled,
                       std::vector<int>& choiceOf) {
    choiceOf.clear();
    const auto isFilled = [&](int region) { return filled[static_cast<std::size_t>(region)] != 0; };
    for (std::size_t f = 0; f < choices.faces.size(); ++f) {
        const ChoiceFace& face = choices.faces[f];
        if ((face.made < 0 || isFilled(face.made)) && (face.covered < 0 || !isFilled(face.covered)))
            choiceOf.push_back(static_cast<int>(f));
    }
    dropDoubled(choices, choiceOf);
    PartedMesh surface;
    surface.mesh.V = pointRows(choices.points);
    surface.mesh.F.resize(static_cast<Eigen::Index>(choiceOf.size()), 3);
    for (std::size_t i = 0; i < choiceOf.size(); ++i) {
        const ChoiceFace& face = choices.faces[static_cast<std::size_t>(choiceOf[i])];
        surface.mesh.F.row(static_cast<Eigen::Index>(i)) << face.corners[0], face.corners[1], face.corners[2];
        surface.labels.push_back(face.label);
        surface.sourceFace.push_back(face.source);
    }
    return surface;
}

} // namespace moldwright
