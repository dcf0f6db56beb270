// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/dislodge.h"

#include "deformation/surgery.h"

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

using Vertex = LabelledMesh::Vertex;
using Face = LabelledMesh::Face;
using Halfedge = LabelledMesh::Halfedge;
using Step = Surgery::Step;

constexpr int kRingsMended = 3;  ///< about a forced collapse
constexpr int kRingsOfPatch = 8; ///< about a stuck face: beyond what mending can reach

/// What a forced collapse and the mending after it come to.
struct Trial {
    std::vector<Step> steps;
    int freed; ///< stuck faces before, less those after
    bool operator<(const Trial& other) const {
        return std::pair(-freed, steps.size()) < std::pair(-other.freed, other.steps.size());
    }
};

/// All halfedges at the corners of f, to and from.
std::set<Halfedge> edgesAbout(const TriangleMesh& mesh, Face f) {
    std::set<Halfedge> edges;
    for (const auto v : mesh.fv_range(f))
        for (const auto h : mesh.voh_range(v)) {
            edges.insert(h);
            edges.insert(mesh.opposite_halfedge_handle(h));
        }
    return edges;
}

/// Collapses a onto b, mends what comes of it, and counts; `before`: stuck faces as it is.
Trial tryForcing(Surgery surgery, Vertex a, Vertex b, int before) {
    surgery.apply({Step::Kind::Collapse, a, b, {}});
    surgery.mend([&] {
        return surgery.mesh().topology().status(b).deleted() ? std::vector<Face>{}
                                                             : surgery.mesh().facesAbout(b, kRingsMended);
    });
    return {surgery.steps(), before - surgery.countStuck()};
}

/// Collapses an edge at f although that makes matters worse at first, and mends what comes of it. Of all
/// such collapses the one that leaves the fewest faces short; none where that is no fewer than now.
void force(Surgery& surgery, Face f, const CleanUpGoal& goal) {
    const TriangleMesh& topology = surgery.mesh().topology();
    const Vertex corner = *topology.cfv_begin(f);
    std::optional<LabelledPatch> patch = surgery.mesh().patchAbout(corner, kRingsOfPatch);
    if (!patch)
        return;
    const Surgery untouched(patch->mesh, goal);
    const int before = untouched.countStuck();
    std::optional<Trial> best;
    for (const Halfedge h : edgesAbout(topology, f)) {
        const Vertex a = patch->at(topology.from_vertex_handle(h));
        const Vertex b = patch->at(topology.to_vertex_handle(h));
        if (!patch->mesh.mayCollapse(patch->mesh.topology().find_halfedge(a, b)))
            continue;
        Trial trial = tryForcing(untouched, a, b, before);
        if (trial.freed > 0 && (!best || trial < *best))
            best.emplace(std::move(trial));
    }
    if (!best)
        return;
    const auto origin = [&](Vertex v) {
        return v.is_valid() ? patch->origin[static_cast<std::size_t>(v.idx())] : v;
    };
    for (const Step& step : best->steps)
        surgery.apply({step.kind, origin(step.a), origin(step.b), step.place});
}

} // namespace

int dislodge(LabelledSurface& surface, const CleanUpGoal& goal) {
    Surgery surgery(LabelledMesh(surface), goal);
    for (const Face f : surgery.facesToMend(surgery.allFaces()))
        if (surgery.isStuck(f))
            force(surgery, f, goal);
    if (!surgery.steps().empty())
        surface = surgery.mesh().surface();
    return static_cast<int>(surgery.steps().size());
}

} // namespace moldwright
