// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/analysis.h"

#include "castability/energy.h"
#include "castability/overhang.h"
#include "mesh/measures.h"

#include <algorithm>
#include <map>

namespace moldwright {

namespace {

/// A face's two pieces as the analysis sees them.
struct FacePieces {
    double area1 = 0;
    double area2 = 0;
    double sine1 = 0; ///< N·d1
    double sine2 = 0; ///< N·d2
};

FacePieces piecesOf(const IndexedMesh& mesh, int f, const MoldState& state) {
    const Eigen::Vector3d c = doubleAreaVector(mesh, f);
    const double length = c.norm();
    if (!(length > 0))
        return {};
    const Eigen::Vector3d N = c / length;
    Eigen::Vector3d distances;
    for (int k = 0; k < 3; ++k)
        distances[k] = state.plane.distance(mesh.corner(f, k));
    const double share1 = partArea(distances, N.dot(state.plane.normal) > 0 ? 1 : 2).share1;
    return {length / 2 * share1, length / 2 * (1 - share1), N.dot(state.directions.d1),
            N.dot(state.directions.d2)};
}

std::size_t histogramClass(double draft) {
    const auto& edges = DraftHistogram::edges;
    const auto above = std::upper_bound(edges.begin(), edges.end(), draft);
    const auto index = static_cast<std::size_t>(above - edges.begin());
    return std::clamp<std::size_t>(index, 1, edges.size() - 1) - 1;
}

/// Neighbours of each violating face across its edges, among the violating faces.
std::map<std::pair<int, int>, std::vector<int>> facesAtEdges(const IndexedMesh& mesh,
                                                             const std::vector<std::uint8_t>& violating) {
    std::map<std::pair<int, int>, std::vector<int>> at;
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; violating[static_cast<std::size_t>(f)] && k < 3; ++k)
            at[std::minmax(mesh.F(f, k), mesh.F(f, (k + 1) % 3))].push_back(f);
    return at;
}

std::vector<Undercut> gatherUndercuts(const IndexedMesh& mesh, const DraftAnalysis& analysis,
                                      const std::vector<int>& sideOf,
                                      const std::vector<double>& violatingArea) {
    const auto at = facesAtEdges(mesh, analysis.violating);
    std::vector<char> seen(sideOf.size(), 0);
    std::vector<Undercut> undercuts;
    for (int seed = 0; seed < mesh.faceCount(); ++seed) {
        if (!analysis.violating[static_cast<std::size_t>(seed)] || seen[static_cast<std::size_t>(seed)])
            continue;
        Undercut undercut;
        undercut.side = sideOf[static_cast<std::size_t>(seed)];
        undercut.faces = {seed};
        seen[static_cast<std::size_t>(seed)] = 1;
        for (std::size_t i = 0; i < undercut.faces.size(); ++i) {
            const int f = undercut.faces[i];
            const double area = violatingArea[static_cast<std::size_t>(f)];
            undercut.area += area;
            undercut.place += area * (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
            for (int k = 0; k < 3; ++k)
                for (const int g : at.at(std::minmax(mesh.F(f, k), mesh.F(f, (k + 1) % 3)))) {
                    if (seen[static_cast<std::size_t>(g)] ||
                        sideOf[static_cast<std::size_t>(g)] != undercut.side)
                        continue;
                    seen[static_cast<std::size_t>(g)] = 1;
                    undercut.faces.push_back(g);
                }
        }
        undercut.place /= undercut.area;
        std::sort(undercut.faces.begin(), undercut.faces.end());
        undercuts.push_back(std::move(undercut));
    }
    std::stable_sort(undercuts.begin(), undercuts.end(),
                     [](const Undercut& a, const Undercut& b) { return a.area > b.area; });
    return undercuts;
}

/// The way blocked over every face of every region.
std::vector<double> depthsOf(const IndexedMesh& mesh, const MoldState& state,
                             const std::vector<Undercut>& undercuts) {
    std::vector<double> depths(static_cast<std::size_t>(mesh.faceCount()), 0);
    for (const int side : {1, 2}) {
        std::vector<int> faces;
        for (int f = 0; f < mesh.faceCount(); ++f) {
            const FacePieces pieces = piecesOf(mesh, f, state);
            if ((side == 1 ? pieces.area1 : pieces.area2) > 0)
                faces.push_back(f);
        }
        const Overhang overhang(mesh, faces, state.directions.of(side));
        for (const Undercut& undercut : undercuts) {
            if (undercut.side != side)
                continue;
            for (const int f : undercut.faces)
                depths[static_cast<std::size_t>(f)] =
                    overhang.above((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3);
        }
    }
    return depths;
}

void measureDepths(const IndexedMesh& mesh, const MoldState& state, std::vector<Undercut>& undercuts) {
    const std::vector<double> depths = depthsOf(mesh, state, undercuts);
    for (Undercut& undercut : undercuts)
        for (const int f : undercut.faces)
            undercut.depth = std::max(undercut.depth, depths[static_cast<std::size_t>(f)]);
}

/// What is summed up face after face.
struct DraftSums {
    DraftSums(std::size_t faces, double requiredSine)
        : tau(requiredSine), sideOf(faces, 0), violatingArea(faces, 0) {
        result.faceDraft.resize(faces);
        result.violating.assign(faces, 0);
    }

    void add(int face, const FacePieces& pieces) {
        const auto f = static_cast<std::size_t>(face);
        double worst = 1;
        for (const int side : {1, 2}) {
            const double a = side == 1 ? pieces.area1 : pieces.area2;
            const double sine = side == 1 ? pieces.sine1 : pieces.sine2;
            if (!(a > 0))
                continue;
            area += a;
            result.histogram.areaFraction[histogramClass(draftDegrees(sine))] += a;
            if (sine < tau) {
                violatingArea[f] += a;
                energy += 0.5 * a * (sine - tau) * (sine - tau);
            }
            if (sine < worst) {
                worst = sine;
                sideOf[f] = side;
            }
        }
        result.violating[f] = violatingArea[f] > 0;
        result.violatingArea += violatingArea[f];
        result.faceDraft[f] = draftDegrees(worst);
        if (pieces.area1 + pieces.area2 > 0)
            result.worstDraftDegrees = std::min(result.worstDraftDegrees, result.faceDraft[f]);
    }

    /// Hands over all but the undercuts, of a mesh of this size.
    [[nodiscard]] DraftAnalysis take(double size) {
        if (area > 0) {
            result.energy = energy / (size * size);
            result.violatingAreaFraction = result.violatingArea / area;
            for (double& share : result.histogram.areaFraction)
                share /= area;
        }
        return std::move(result);
    }

    double tau;
    std::vector<int> sideOf;           ///< the side that a face has its worst draft on; 0: neither
    std::vector<double> violatingArea; ///< of each face
    DraftAnalysis result;
    double area = 0;
    double energy = 0;
};

} // namespace

DraftAnalysis analyzeDraft(const IndexedMesh& mesh, const MoldState& state, double requiredDraft,
                           bool withDepths) {
    DraftSums sums(static_cast<std::size_t>(mesh.faceCount()), std::sin(radians(requiredDraft)));
    for (int f = 0; f < mesh.faceCount(); ++f)
        sums.add(f, piecesOf(mesh, f, state));
    DraftAnalysis result = sums.take(diagonal(mesh));
    result.undercuts = gatherUndercuts(mesh, result, sums.sideOf, sums.violatingArea);
    if (withDepths)
        measureDepths(mesh, state, result.undercuts);
    return result;
}

std::vector<double> undercutDepths(const IndexedMesh& mesh, const MoldState& state, double requiredDraft) {
    return depthsOf(mesh, state, analyzeDraft(mesh, state, requiredDraft, false).undercuts);
}

} // namespace moldwright
