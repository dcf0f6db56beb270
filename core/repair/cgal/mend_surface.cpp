// SPDX-License-Identifier: AGPL-3.0-or-later
#include "repair/mend_surface.h"

#include "repair/cgal/surface_mesh.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/linear_least_squares_fitting_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace moldwright {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Halfedge = RepairMesh::Halfedge_index;
using Face = RepairMesh::Face_index;
using Vertex = RepairMesh::Vertex_index;

constexpr double kScrap = 1e-3; ///< of the area: smaller open pieces are dropped
constexpr double kFlat = 0.02;  ///< of its size, that the rim of a flat hole leaves its plane by

RepairMesh manifoldOf(const IndexedMesh& mesh) {
    RepairSoup soup = toSoup(mesh);
    PMP::repair_polygon_soup(soup.points, soup.faces);
    PMP::orient_polygon_soup(soup.points, soup.faces);
    RepairMesh surface;
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, surface);
    return surface;
}

/// Open pieces of one face or next to no area: stray faces, fins that were cut off.
void dropScraps(RepairMesh& surface) {
    auto pieceOf = surface.add_property_map<Face, std::size_t>("f:piece", 0).first;
    const std::size_t pieces = PMP::connected_components(surface, pieceOf);
    std::vector<double> area(pieces, 0);
    std::vector<int> faces(pieces, 0);
    std::vector<char> open(pieces, 0);
    double whole = 0;
    for (const Face f : surface.faces()) {
        const double one = PMP::face_area(f, surface);
        area[pieceOf[f]] += one;
        ++faces[pieceOf[f]];
        whole += one;
        for (const Halfedge h : surface.halfedges_around_face(surface.halfedge(f)))
            open[pieceOf[f]] |= static_cast<char>(surface.is_border(surface.opposite(h)));
    }
    std::vector<std::size_t> dropped;
    for (std::size_t piece = 0; piece < pieces; ++piece)
        if (open[piece] && (faces[piece] == 1 || area[piece] < kScrap * whole))
            dropped.push_back(piece);
    PMP::remove_connected_components(surface, dropped, pieceOf);
    surface.remove_property_map(pieceOf);
}

std::vector<RepairPoint> rimOf(const RepairMesh& surface, Halfedge border) {
    std::vector<RepairPoint> rim;
    for (const Halfedge h : CGAL::halfedges_around_face(border, surface))
        rim.push_back(surface.point(surface.target(h)));
    return rim;
}

double sizeOf(const std::vector<RepairPoint>& rim) {
    const CGAL::Bbox_3 box = CGAL::bbox_3(rim.begin(), rim.end());
    return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

bool isFlat(const std::vector<RepairPoint>& rim, double size) {
    RepairKernel::Plane_3 plane;
    CGAL::linear_least_squares_fitting_3(rim.begin(), rim.end(), plane, CGAL::Dimension_tag<0>());
    return std::ranges::all_of(rim, [&](const RepairPoint& p) {
        return std::sqrt(CGAL::squared_distance(p, plane)) <= kFlat * size;
    });
}

/// The faces that fill one hole; none where it cannot be filled.
std::size_t fillHole(RepairMesh& surface, Halfedge border, bool flat) {
    std::vector<Face> faces;
    std::vector<Vertex> points;
    if (!flat)
        PMP::triangulate_refine_and_fair_hole(surface, border, std::back_inserter(faces),
                                              std::back_inserter(points));
    if (faces.empty() && surface.is_border(border))
        PMP::triangulate_hole(surface, border, std::back_inserter(faces));
    return faces.size();
}

void fillHoles(RepairMesh& surface, MendedSurface& mended) {
    std::vector<Halfedge> borders;
    PMP::extract_boundary_cycles(surface, std::back_inserter(borders));
    for (const Halfedge border : borders) {
        const std::vector<RepairPoint> rim = rimOf(surface, border);
        const double size = sizeOf(rim);
        const std::size_t faces = fillHole(surface, border, isFlat(rim, size));
        mended.holesFilled += faces > 0;
        mended.facesFilled += static_cast<int>(faces);
        mended.largestHole = std::max(mended.largestHole, size);
    }
}

int crossingsOf(const RepairMesh& surface) {
    std::vector<std::pair<Face, Face>> pairs;
    PMP::self_intersections(surface, std::back_inserter(pairs));
    return static_cast<int>(pairs.size());
}

} // namespace

MendedSurface mendSurface(const IndexedMesh& mesh) {
    MendedSurface mended;
    RepairMesh surface = manifoldOf(mesh);
    dropScraps(surface);
    PMP::stitch_borders(surface);
    PMP::duplicate_non_manifold_vertices(surface);
    PMP::remove_degenerate_faces(surface);
    mended.facesRemoved = mesh.faceCount() - static_cast<int>(surface.number_of_faces());
    fillHoles(surface, mended);
    mended.crossings = crossingsOf(surface);
    if (mended.crossings > 0) {
        PMP::experimental::remove_self_intersections(surface);
        fillHoles(surface, mended);
    }
    if (surface.number_of_faces() > 0 && CGAL::is_closed(surface))
        PMP::orient_to_bound_a_volume(surface);
    mended.mesh = toIndexed(surface);
    return mended;
}

} // namespace moldwright
