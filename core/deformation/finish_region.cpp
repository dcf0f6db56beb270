// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/finish_region.h"

#include "castability/parting_line.h"

#include <algorithm>
#include <limits>

namespace moldwright {

namespace {

/// Adds the faces that share a point with those marked.
void widen(const Triangles& F, std::vector<char>& faces, Eigen::Index points) {
    std::vector<char> touched(static_cast<std::size_t>(points), 0);
    for (Eigen::Index f = 0; f < F.rows(); ++f)
        for (int k = 0; k < 3 && faces[static_cast<std::size_t>(f)]; ++k)
            touched[static_cast<std::size_t>(F(f, k))] = 1;
    for (Eigen::Index f = 0; f < F.rows(); ++f)
        for (int k = 0; k < 3; ++k)
            if (touched[static_cast<std::size_t>(F(f, k))])
                faces[static_cast<std::size_t>(f)] = 1;
}

/// Points of faces that are not marked.
std::vector<char> pointsBeyond(const IndexedMesh& mesh, const std::vector<char>& marked) {
    std::vector<char> beyond(static_cast<std::size_t>(mesh.vertexCount()), 0);
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3 && !marked[static_cast<std::size_t>(f)]; ++k)
            beyond[static_cast<std::size_t>(mesh.F(f, k))] = 1;
    return beyond;
}

/// Gives the region's points their places, and says which of them may move how.
void takePoints(FinishRegion& region, const Points& V, const std::vector<char>& beyond) {
    LabelledBody& body = region.body;
    body.shape.V.resize(static_cast<Eigen::Index>(region.points.size()), 3);
    for (std::size_t i = 0; i < region.points.size(); ++i) {
        const int v = region.points[i];
        body.shape.V.row(static_cast<Eigen::Index>(i)) = V.row(v);
        body.fixed.push_back(beyond[static_cast<std::size_t>(v)]);
        // A face that was laid in the plane (a flat back) stays there, like the line.
        body.held.push_back(V(v, 2) == 0);
    }
    for (const auto& edge : body.line)
        for (const int v : edge)
            body.held[static_cast<std::size_t>(v)] = 1;
}

double leastImportance(const LabelledSurface& surface, int face, const std::vector<double>& importance) {
    double least = std::numeric_limits<double>::infinity();
    for (const int v : surface.mesh.F.row(face)) {
        const int source = surface.sourceVertex[static_cast<std::size_t>(v)];
        least = std::min(least, source < 0 ? 1.0 : importance[static_cast<std::size_t>(source)]);
    }
    return least;
}

/// The body of the faces marked, with the points of `line` even where no such face has them.
FinishRegion regionOf(const LabelledSurface& surface, const std::vector<char>& marked,
                      const std::vector<std::array<int, 2>>& line, const Directions& directions,
                      const std::vector<double>& importance) {
    FinishRegion region;
    const IndexedMesh& mesh = surface.mesh;
    for (int f = 0; f < mesh.faceCount(); ++f)
        if (marked[static_cast<std::size_t>(f)])
            region.faces.push_back(f);
    std::vector<int> placeOf(static_cast<std::size_t>(mesh.vertexCount()), -1);
    const auto place = [&](int v) {
        int& at = placeOf[static_cast<std::size_t>(v)];
        if (at < 0) {
            at = static_cast<int>(region.points.size());
            region.points.push_back(v);
        }
        return at;
    };
    LabelledBody& body = region.body;
    body.directions = directions;
    body.shape.membrane = 1;
    body.shape.F.resize(static_cast<Eigen::Index>(region.faces.size()), 3);
    for (std::size_t i = 0; i < region.faces.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            body.shape.F(static_cast<Eigen::Index>(i), k) = place(mesh.F(region.faces[i], k));
        body.labels.push_back(surface.labels[static_cast<std::size_t>(region.faces[i])]);
        if (!importance.empty())
            body.shape.faceWeights.push_back(leastImportance(surface, region.faces[i], importance));
    }
    for (const auto& [a, b] : line)
        body.line.push_back({place(a), place(b)});
    takePoints(region, mesh.V, pointsBeyond(mesh, marked));
    return region;
}

} // namespace

FinishRegion regionAround(const LabelledSurface& surface, std::vector<char> faces, int rings,
                          const Directions& directions, const std::vector<double>& importance) {
    for (int ring = 0; ring < rings; ++ring)
        widen(surface.mesh.F, faces, surface.mesh.V.rows());
    return regionOf(surface, faces, partingEdges(surface.mesh, surface.labels), directions, importance);
}

FinishRegion wholeRegion(const LabelledSurface& surface, const Directions& directions,
                         const std::vector<double>& importance) {
    return regionAround(surface, std::vector<char>(surface.labels.size(), 1), 0, directions, importance);
}

} // namespace moldwright
