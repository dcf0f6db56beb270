// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/proxy.h"

#include "deformation/surface_binding.h"
#include "exchange/tetrahedralize.h"
#include "mesh/check.h"
#include "mesh/decimate.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr int kQuickFaces = 2500; ///< away from the parting line
constexpr int kFineFaces = 8000;  ///< the same where the quick one was not enough
constexpr int kFacesAtPoint = 3;  ///< more for each point of the parting line, all of which stay
/// TetGen's switches: for the quick one a third fewer tetrahedra than a part that bends itself gets.
constexpr const char* kQuickSwitches = "pYq2";
constexpr const char* kFineSwitches = "pYq1.414";
constexpr double kWorthIt = 1.5;     ///< times a proxy's faces: smaller parts are as fast themselves
constexpr int kAttempts = 4;         ///< with ever more detail kept where the proxy would cross itself
constexpr double kLeastHeight = 0.1; ///< share of its height that a point keeps on its own side

/// A face on one side by its points' heights; in the plane by the way it looks.
std::uint8_t sideOf(const IndexedMesh& mesh, int f) {
    double sum = 0;
    for (int k = 0; k < 3; ++k)
        sum += mesh.corner(f, k).z();
    return (sum != 0 ? sum : doubleAreaVector(mesh, f).z()) > 0 ? 1 : 2;
}

PartedMesh labelled(IndexedMesh mesh) {
    PartedMesh surface{std::move(mesh), {}, {}};
    for (int f = 0; f < surface.mesh.faceCount(); ++f) {
        surface.labels.push_back(sideOf(surface.mesh, f));
        surface.sourceFace.push_back(f);
    }
    return surface;
}

/// Keeps the points that were merged into those of crossing faces: there the part is too thin for less
/// detail.
void keepDetailAt(const std::vector<std::pair<int, int>>& crossing, const Reduction& reduction,
                  std::vector<char>& kept) {
    std::vector<char> thin(static_cast<std::size_t>(reduction.mesh.vertexCount()), 0);
    for (const auto& pair : crossing)
        for (const int f : {pair.first, pair.second})
            for (int k = 0; k < 3; ++k)
                thin[static_cast<std::size_t>(reduction.mesh.F(f, k))] = 1;
    for (std::size_t v = 0; v < kept.size(); ++v)
        kept[v] = kept[v] || thin[static_cast<std::size_t>(reduction.pointNow[v])];
}

/// Points of the plane stay in it, others on their side.
void keepSides(Points& X, const Points& rest) {
    for (Eigen::Index v = 0; v < X.rows(); ++v) {
        const double z = rest(v, 2);
        const int side = (z > 0) - (z < 0);
        X(v, 2) = side * std::max(side * X(v, 2), kLeastHeight * std::abs(z));
    }
}

/// Importance of each face of the proxy: the least of its points', each of which has the most that faces of
/// the part about the points merged into it have.
std::vector<double> proxyWeights(const PartedPart& part, const Proxy& proxy,
                                 const std::vector<double>& partWeights) {
    if (partWeights.empty())
        return {};
    const IndexedMesh& coarse = proxy.solid.surface.mesh;
    std::vector<double> ofPoint(static_cast<std::size_t>(coarse.vertexCount()), 0);
    const std::vector<double> ofFine = importanceOfPoints(part, partWeights);
    for (std::size_t v = 0; v < ofFine.size(); ++v) {
        double& most = ofPoint[static_cast<std::size_t>(proxy.pointNow[v])];
        most = std::max(most, ofFine[v]);
    }
    std::vector<double> weights;
    weights.reserve(static_cast<std::size_t>(coarse.faceCount()));
    for (int f = 0; f < coarse.faceCount(); ++f)
        weights.push_back(std::min({ofPoint[static_cast<std::size_t>(coarse.F(f, 0))],
                                    ofPoint[static_cast<std::size_t>(coarse.F(f, 1))],
                                    ofPoint[static_cast<std::size_t>(coarse.F(f, 2))]}));
    return weights;
}

/// The points of the plane, and those of important faces while they are few: a region is as stiff as it is
/// meant to be only where the stand-in has it as it is.
std::vector<char> pointsToKeep(const PartedPart& part, const std::vector<double>& faceWeights, int faces) {
    std::vector<char> kept(static_cast<std::size_t>(part.surface.mesh.vertexCount()));
    for (std::size_t v = 0; v < kept.size(); ++v)
        kept[v] = part.surface.mesh.V(static_cast<Eigen::Index>(v), 2) == 0;
    const std::vector<double> importance = importanceOfPoints(part, faceWeights);
    const auto important = std::ranges::count_if(importance, [](double weight) { return weight > 1; });
    if (kFacesAtPoint * important <= faces)
        for (std::size_t v = 0; v < importance.size(); ++v)
            kept[v] = kept[v] || importance[v] > 1;
    return kept;
}

} // namespace

std::optional<Proxy> proxyOf(const PartedPart& part, ProxyDetail detail,
                             const std::vector<double>& faceWeights, const Task& task) {
    const IndexedMesh& fine = part.surface.mesh;
    const bool quick = detail == ProxyDetail::Quick;
    int faces = quick ? kQuickFaces : kFineFaces;
    std::vector<char> kept = pointsToKeep(part, faceWeights, faces);
    faces += kFacesAtPoint * static_cast<int>(std::count(kept.begin(), kept.end(), 1));
    if (fine.faceCount() < kWorthIt * faces)
        return std::nullopt;
    for (int attempt = 0; attempt < kAttempts && !task.stopped(); ++attempt) {
        Reduction reduction = reduce(fine, faces, kept);
        const auto crossing = selfIntersections(reduction.mesh);
        if (!crossing.empty()) {
            keepDetailAt(crossing, reduction, kept);
            continue;
        }
        Result<TetMesh> tets = tetrahedralize(reduction.mesh, task, quick ? kQuickSwitches : kFineSwitches,
                                              innerPlaces(part.pins));
        if (!tets)
            return std::nullopt;
        std::vector<PlacedPin> pins = part.pins;
        for (PlacedPin& pin : pins)
            if (pin.surfacePoint >= 0)
                pin.surfacePoint = reduction.pointNow[static_cast<std::size_t>(pin.surfacePoint)];
        return Proxy{
            {{part.state, part.frame, labelled(std::move(reduction.mesh)), 0, false, std::move(pins), {}},
             std::move(*tets)},
            std::move(reduction.pointNow)};
    }
    return std::nullopt;
}

BentShape bendByProxy(const PartedPart& part, const Proxy& proxy, const ShapeGoal& goal, const Task& task,
                      const ShapeWatch& watch, const BentShape* from) {
    const Points& rest = part.surface.mesh.V;
    const SurfaceBinding binding(proxy.solid.surface.mesh, rest, proxy.pointNow);
    const auto follow = [&](const Points& X) {
        Points carried = binding.carry(X);
        keepSides(carried, rest);
        return carried;
    };
    ShapeGoal coarse = goal;
    coarse.faceWeights = proxyWeights(part, proxy, goal.faceWeights);
    ShapeWatch watchPart;
    if (watch)
        watchPart = [&](const char* stage, const LabelledSurface& now) {
            watch(stage, surfaceAt(part, follow(now.mesh.V)));
        };
    const BentShape bent = bend(proxy.solid, coarse, task, watchPart, from);
    std::vector<PlacedPin> pins = bent.pins;
    for (std::size_t i = 0; i < pins.size(); ++i)
        pins[i].surfacePoint = part.pins[i].surfacePoint;
    return {surfaceAt(part, follow(bent.surface.mesh.V)),
            bent.iterations,
            true,
            std::move(pins),
            bent.points,
            bent.round};
}

} // namespace moldwright
