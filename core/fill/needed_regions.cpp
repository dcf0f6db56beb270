// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/needed_regions.h"

#include "castability/topology.h"
#include "fill/necks.h"
#include "mesh/check.h"
#include "mesh/opposite_sides.h"
#include "mesh/union_find.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace moldwright {

namespace {

constexpr int kDragRounds = 8;              ///< in which regions are added that others drag along
constexpr std::array kLongest = {0.2, 0.4}; ///< of the size: how long a region may be that is needed

bool castable(const ChoiceMesh& choices, const std::vector<char>& filled) {
    std::vector<int> choiceOf;
    const PartedMesh surface = surfaceWith(choices, filled, choiceOf);
    return topologyAllowsCasting(surface.mesh, surface.labels) &&
           closedManifold(surface.mesh.F, surface.mesh.vertexCount());
}

/// Leaves out as many regions as it can: all of them at once, else the first half, then the second.
void leaveOut(const ChoiceMesh& choices, std::span<const int> regions, std::vector<char>& filled,
              const Task& task) {
    if (regions.empty() || task.stopped())
        return;
    for (const int region : regions)
        filled[static_cast<std::size_t>(region)] = 0;
    if (castable(choices, filled))
        return;
    for (const int region : regions)
        filled[static_cast<std::size_t>(region)] = 1;
    if (regions.size() == 1)
        return;
    leaveOut(choices, regions.first(regions.size() / 2), filled, task);
    leaveOut(choices, regions.subspan(regions.size() / 2), filled, task);
}

/// Of the regions filled, the largest are left out first.
void leaveOutWhatCanBe(const ChoiceMesh& choices, std::vector<char>& filled, const Task& task) {
    std::vector<int> regions;
    for (std::size_t r = 0; r < filled.size(); ++r)
        if (filled[r])
            regions.push_back(static_cast<int>(r));
    leaveOut(choices, regions, filled, task);
    // What one left out made superfluous: once more, one by one.
    for (const int region : regions)
        if (filled[static_cast<std::size_t>(region)])
            leaveOut(choices, std::span(&region, 1), filled, task);
}

/// Regions that hang together become one where they are alike: all needed, or none.
void joinAlike(ChoiceMesh& choices, std::vector<char>& needed) {
    UnionFind groups(choices.regions);
    for (const ChoiceFace& face : choices.faces)
        if (face.made >= 0 && face.covered >= 0 &&
            needed[static_cast<std::size_t>(face.made)] == needed[static_cast<std::size_t>(face.covered)])
            groups.unite(face.made, face.covered);
    std::vector<int> number;
    number.reserve(static_cast<std::size_t>(choices.regions));
    for (int r = 0; r < choices.regions; ++r)
        number.push_back(groups.rootOf(r));
    renumber(choices, number);
    std::erase_if(choices.faces,
                  [](const ChoiceFace& face) { return face.made >= 0 && face.made == face.covered; });
}

/// Divides those of the regions that are marked at their necks and leaves out what can be of them. Returns
/// whether what is left is a sound surface.
bool divideAndLeaveOut(ChoiceMesh& choices, std::vector<char>& marked, const Directions& directions,
                       double longest, double nothing, const Task& task) {
    const int undivided = choices.regions;
    for (int r = 0; r < undivided && !task.stopped(); ++r)
        if (marked[static_cast<std::size_t>(r)])
            divideAtNecks(choices, r, directions, longest, task);
    marked.resize(static_cast<std::size_t>(choices.regions), 1);
    numberByVolume(choices, marked, nothing);
    leaveOutWhatCanBe(choices, marked, task);
    if (task.stopped() || !dragAlong(choices, marked, task) || !castable(choices, marked))
        return false;
    joinAlike(choices, marked);
    numberByVolume(choices, marked, nothing);
    return true;
}

} // namespace

bool dragAlong(const ChoiceMesh& choices, std::vector<char>& filled, const Task& task) {
    for (int round = 0; round < kDragRounds && !task.stopped(); ++round) {
        std::vector<int> choiceOf;
        const auto crossings = selfIntersections(surfaceWith(choices, filled, choiceOf).mesh);
        if (crossings.empty())
            return true;
        for (const auto& [f, g] : crossings)
            for (const int face : {f, g}) {
                const int choice = choiceOf[static_cast<std::size_t>(face)];
                if (const int region = choices.faces[static_cast<std::size_t>(choice)].covered; region >= 0)
                    filled[static_cast<std::size_t>(region)] = 1;
            }
    }
    return false;
}

std::vector<char> neededRegions(ChoiceMesh& choices, const Directions& directions, double size,
                                double nothing, const Task& task) {
    std::vector<char> whole(static_cast<std::size_t>(choices.regions), 1);
    leaveOutWhatCanBe(choices, whole, task);
    if (std::ranges::count(whole, 1) == 0)
        return whole;
    for (const double longest : kLongest) {
        ChoiceMesh divided = choices;
        std::vector<char> needed = whole;
        if (!divideAndLeaveOut(divided, needed, directions, longest * size, nothing, task))
            continue;
        choices = std::move(divided);
        return needed;
    }
    return whole;
}

} // namespace moldwright
