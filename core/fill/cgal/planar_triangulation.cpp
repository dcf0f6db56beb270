// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/cgal/planar_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>

namespace moldwright {

namespace {

constexpr int kUnnumbered = -1;

/// The number of a vertex or triangle in the answer.
struct Number {
    int value = kUnnumbered;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<Number, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Storage = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage, CGAL::Exact_predicates_tag>;
using WithChains = CGAL::Constrained_triangulation_plus_2<Triangulation>;

template <class T>
std::vector<typename T::Vertex_handle> insertPoints(T& triangulation,
                                                    const std::vector<Eigen::Vector2d>& given) {
    std::vector<Kernel::Point_2> points;
    points.reserve(given.size());
    for (const Eigen::Vector2d& p : given)
        points.emplace_back(p.x(), p.y());
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    using Map = CGAL::Pointer_property_map<Kernel::Point_2>::type;
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(CGAL::make_property_map(points)));
    std::vector<typename T::Vertex_handle> handles(points.size());
    typename T::Face_handle hint;
    for (const std::size_t i : order) {
        handles[i] = triangulation.insert(points[i], hint);
        handles[i]->info().value = static_cast<int>(i);
        hint = handles[i]->face();
    }
    return handles;
}

template <class T>
PlanarTriangulation asArrays(T& triangulation, const std::vector<Eigen::Vector2d>& given) {
    PlanarTriangulation result;
    result.points = given;
    for (const auto v : triangulation.finite_vertex_handles())
        if (v->info().value == kUnnumbered) {
            v->info().value = static_cast<int>(result.points.size());
            result.points.emplace_back(v->point().x(), v->point().y());
        }
    for (const auto f : triangulation.finite_face_handles()) {
        f->info().value = static_cast<int>(result.triangles.size());
        result.triangles.push_back(
            {f->vertex(0)->info().value, f->vertex(1)->info().value, f->vertex(2)->info().value});
    }
    for (const auto f : triangulation.finite_face_handles()) {
        std::array<int, 3> neighbours{};
        std::array<char, 3> onSegment{};
        for (int k = 0; k < 3; ++k) {
            const int opposite = (k + 2) % 3;
            neighbours[static_cast<std::size_t>(k)] = f->neighbor(opposite)->info().value;
            onSegment[static_cast<std::size_t>(k)] = f->is_constrained(opposite) ? 1 : 0;
        }
        result.neighbours.push_back(neighbours);
        result.onSegment.push_back(onSegment);
    }
    return result;
}

} // namespace

PlanarTriangulation triangulatePlane(const std::vector<Eigen::Vector2d>& points,
                                     const std::vector<std::array<int, 2>>& segments) {
    Triangulation triangulation;
    const auto handles = insertPoints(triangulation, points);
    for (const auto& [from, to] : segments)
        triangulation.insert_constraint(handles[static_cast<std::size_t>(from)],
                                        handles[static_cast<std::size_t>(to)]);
    return asArrays(triangulation, points);
}

CrossedSegments crossSegments(const std::vector<Eigen::Vector2d>& points,
                              const std::vector<std::array<int, 2>>& segments) {
    WithChains triangulation;
    const auto handles = insertPoints(triangulation, points);
    std::vector<WithChains::Constraint_id> ids;
    ids.reserve(segments.size());
    for (const auto& [from, to] : segments)
        ids.push_back(triangulation.insert_constraint(handles[static_cast<std::size_t>(from)],
                                                      handles[static_cast<std::size_t>(to)]));
    CrossedSegments result;
    result.triangulation = asArrays(triangulation, points);
    for (const auto id : ids) {
        std::vector<int> chain;
        for (const auto v : triangulation.vertices_in_constraint(id))
            chain.push_back(v->info().value);
        result.chains.push_back(std::move(chain));
    }
    return result;
}

} // namespace moldwright
