// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/region_measure.h"

#include "design/comparison.h"
#include "design/strain.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

/// The points of `before` that its faces from those of the region use: 1 each.
std::vector<char> pointsOf(const KeptRegion& region, const IndexedMesh& before,
                           const std::vector<int>& sourceFace) {
    std::vector<int> faces = region.faces;
    std::sort(faces.begin(), faces.end());
    std::vector<char> points(static_cast<std::size_t>(before.vertexCount()), 0);
    for (int f = 0; f < before.faceCount(); ++f)
        if (std::binary_search(faces.begin(), faces.end(), sourceFace[static_cast<std::size_t>(f)]))
            for (int k = 0; k < 3; ++k)
                points[static_cast<std::size_t>(before.F(f, k))] = 1;
    return points;
}

/// The rows of V listed.
Points rowsOf(const Points& V, const std::vector<int>& rows) {
    Points picked(static_cast<Eigen::Index>(rows.size()), 3);
    for (std::size_t i = 0; i < rows.size(); ++i)
        picked.row(static_cast<Eigen::Index>(i)) = V.row(rows[i]);
    return picked;
}

/// The cast's faces with all points in the region, on all of its points.
IndexedMesh facesWithin(const IndexedMesh& cast, const std::vector<char>& inside) {
    std::vector<int> faces;
    for (int f = 0; f < cast.faceCount(); ++f)
        if (inside[static_cast<std::size_t>(cast.F(f, 0))] &&
            inside[static_cast<std::size_t>(cast.F(f, 1))] && inside[static_cast<std::size_t>(cast.F(f, 2))])
            faces.push_back(f);
    IndexedMesh part{cast.V, Triangles(static_cast<Eigen::Index>(faces.size()), 3)};
    for (std::size_t i = 0; i < faces.size(); ++i)
        part.F.row(static_cast<Eigen::Index>(i)) = cast.F.row(faces[i]);
    return part;
}

RegionMeasure measureRegion(const KeptRegion& region, const IndexedMesh& before,
                            const std::vector<int>& sourceFace, const IndexedMesh& cast,
                            const std::vector<int>& sourceVertex) {
    const std::vector<char> wanted = pointsOf(region, before, sourceFace);
    std::vector<char> inside(sourceVertex.size(), 0);
    std::vector<int> was;
    std::vector<int> is;
    for (std::size_t v = 0; v < sourceVertex.size(); ++v)
        if (sourceVertex[v] >= 0 && wanted[static_cast<std::size_t>(sourceVertex[v])]) {
            inside[v] = 1;
            was.push_back(sourceVertex[v]);
            is.push_back(static_cast<int>(v));
        }
    RegionMeasure measure{region.name};
    if (is.size() < 3)
        return measure;
    const Points from = rowsOf(before.V, was);
    const Points to = rowsOf(cast.V, is);
    const Eigen::Isometry3d fit = bestRigidFit(from, to);
    double squares = 0;
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
        const double distance = (fit * Eigen::Vector3d(from.row(i)) - to.row(i).transpose()).norm();
        measure.maxDistance = std::max(measure.maxDistance, distance);
        squares += distance * distance;
    }
    measure.rmsDistance = std::sqrt(squares / static_cast<double>(from.rows()));
    measure.strain = surfaceStrain(before, facesWithin(cast, inside), sourceVertex).rms;
    measure.kept = region.within <= 0 || measure.maxDistance <= region.within;
    return measure;
}

} // namespace

std::vector<RegionMeasure> measureRegions(const std::vector<KeptRegion>& regions, const IndexedMesh& before,
                                          const std::vector<int>& sourceFace, const IndexedMesh& cast,
                                          const std::vector<int>& sourceVertex) {
    std::vector<RegionMeasure> measures;
    for (const KeptRegion& region : regions)
        measures.push_back(measureRegion(region, before, sourceFace, cast, sourceVertex));
    return measures;
}

} // namespace moldwright
