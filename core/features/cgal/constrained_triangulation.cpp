// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/cgal/constrained_triangulation.h"

#include "base/stop_point.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <stack>

namespace moldwright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
// Per face: how many outlines lie round it; −1 until it was reached.
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Storage = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage, CGAL::No_constraint_intersection_tag>;

/// Counts, from the infinite face inwards, the outlines that each face lies in.
void countOutlines(Triangulation& triangulation) {
    for (const auto face : triangulation.all_face_handles())
        face->info() = -1;
    std::stack<Triangulation::Face_handle> open;
    triangulation.infinite_face()->info() = 0;
    open.push(triangulation.infinite_face());
    // Breadth does not matter: parity across a constraint is the same on every way.
    while (!open.empty()) {
        const auto face = open.top();
        open.pop();
        for (int k = 0; k < 3; ++k) {
            const auto neighbour = face->neighbor(k);
            if (neighbour->info() >= 0)
                continue;
            neighbour->info() = (face->info() + (face->is_constrained(k) ? 1 : 0)) % 2;
            open.push(neighbour);
        }
    }
}

std::optional<Triangles> trianglesInside(Triangulation& triangulation) {
    countOutlines(triangulation);
    std::vector<std::array<int, 3>> inside;
    for (const auto face : triangulation.finite_face_handles())
        if (face->info() == 1)
            inside.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    Triangles result(static_cast<Eigen::Index>(inside.size()), 3);
    for (std::size_t t = 0; t < inside.size(); ++t)
        result.row(static_cast<Eigen::Index>(t)) << inside[t][0], inside[t][1], inside[t][2];
    return result;
}

} // namespace

std::optional<Triangles> triangulateRegion(const std::vector<Eigen::Vector2d>& points,
                                           const std::vector<std::array<int, 2>>& outlineSegments) try {
    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> handles;
    Triangulation::Face_handle near; // outlines come in order: the next point is beside the last
    for (const Eigen::Vector2d& p : points) {
        stopPointAt(static_cast<std::ptrdiff_t>(handles.size()));
        const auto handle = triangulation.insert({p.x(), p.y()}, near);
        handle->info() = static_cast<int>(handles.size());
        near = handle->face();
        handles.push_back(handle);
    }
    if (triangulation.number_of_vertices() != points.size())
        return std::nullopt;
    for (const auto& [from, to] : outlineSegments) {
        stopPointAt(from);
        triangulation.insert_constraint(handles[static_cast<std::size_t>(from)],
                                        handles[static_cast<std::size_t>(to)]);
    }
    return trianglesInside(triangulation);
} catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
}

} // namespace moldwright
