// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/cgal/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Cell = Triangulation::Cell_handle;
using Numbered = std::pair<std::array<int, 4>, Cell>;

Triangulation triangulated(const Points& points) {
    std::vector<std::pair<Kernel::Point_3, int>> numbered;
    numbered.reserve(static_cast<std::size_t>(points.rows()));
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        numbered.emplace_back(Kernel::Point_3(points(i, 0), points(i, 1), points(i, 2)), static_cast<int>(i));
    return {numbered.begin(), numbered.end()};
}

/// The finite cells in the order of their corners: CGAL's own follows the order of insertion, which follows
/// the places.
std::vector<Numbered> inOrder(Triangulation& triangulation) {
    std::vector<Numbered> cells;
    for (const Cell cell : triangulation.all_cell_handles())
        cell->info() = -1;
    for (const Cell cell : triangulation.finite_cell_handles()) {
        std::array<int, 4> corners{};
        for (int k = 0; k < 4; ++k)
            corners[static_cast<std::size_t>(k)] = cell->vertex(k)->info();
        std::sort(corners.begin(), corners.end());
        cells.emplace_back(corners, cell);
    }
    std::sort(cells.begin(), cells.end(),
              [](const Numbered& a, const Numbered& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i].second->info() = static_cast<int>(i);
    return cells;
}

} // namespace

DelaunayCells delaunay(const Points& points) {
    Triangulation triangulation = triangulated(points);
    DelaunayCells result;
    if (triangulation.dimension() < 3)
        return result;
    for (const auto& [corners, cell] : inOrder(triangulation)) {
        std::array<int, 4> neighbours{};
        for (int k = 0; k < 4; ++k) {
            const auto at = std::find(corners.begin(), corners.end(), cell->vertex(k)->info());
            neighbours[static_cast<std::size_t>(at - corners.begin())] = cell->neighbor(k)->info();
        }
        result.corners.push_back(corners);
        result.neighbours.push_back(neighbours);
    }
    return result;
}

} // namespace moldwright
