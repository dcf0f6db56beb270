// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/comparison.h"

#include "base/parallel.h"
#include "mesh/closest_point.h"
#include "mesh/geodesic.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace moldwright {

namespace {

constexpr double kProminence = 0.025; ///< of the diagonal: less is no limb
constexpr double kFirstReach = 0.04;  ///< of the diagonal: a joint is not looked for nearer to the tip
constexpr double kLeastVolume = 1e-6; ///< of the diagonal cubed
constexpr double kLongestReach = 0.6;
constexpr double kReachStep = 0.01;
constexpr double kWidening = 2.6; ///< dA/dr over A/r: a tube has 1, a cone 2, a joint more

/// The distance from each of `from`'s points to `to`.
std::vector<double> pointDistances(const IndexedMesh& from, const IndexedMesh& to) {
    const ClosestPoint closest(to);
    std::vector<double> distance(static_cast<std::size_t>(from.vertexCount()));
    parallelFor(distance.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            distance[v] = closest.distance(from.point(static_cast<int>(v)));
    });
    return distance;
}

std::vector<double> faceDistances(const IndexedMesh& from, const IndexedMesh& to) {
    const std::vector<double> distance = pointDistances(from, to);
    std::vector<double> ofFace;
    ofFace.reserve(static_cast<std::size_t>(from.faceCount()));
    for (int f = 0; f < from.faceCount(); ++f)
        ofFace.push_back((distance[static_cast<std::size_t>(from.F(f, 0))] +
                          distance[static_cast<std::size_t>(from.F(f, 1))] +
                          distance[static_cast<std::size_t>(from.F(f, 2))]) /
                         3);
    return ofFace;
}

IndexedMesh movedBy(const Eigen::Isometry3d& motion, const IndexedMesh& mesh) {
    IndexedMesh result = mesh;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        result.V.row(v) = (motion * mesh.point(v)).transpose();
    return result;
}

/// The part laid over its cast: moved as the cast's points moved, in the least squares sense.
IndexedMesh fittedOver(const IndexedMesh& part, const Points& before, const IndexedMesh& cast) {
    return movedBy(bestRigidFit(before, cast.V), part);
}

/// Area of a surface, and the integral over it of what its points have; between a face's corners their mean.
std::pair<double, double> integralOver(const IndexedMesh& mesh, const std::vector<double>& values) {
    double area = 0;
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const double a = doubleAreaVector(mesh, f).norm() / 2;
        area += a;
        for (int k = 0; k < 3; ++k)
            sum += a / 3 * values[static_cast<std::size_t>(mesh.F(f, k))];
    }
    return {area, sum};
}

/// Area of `from`, and the integral over it of the squared distance to `to`.
std::pair<double, double> squaredDistance(const IndexedMesh& from, const IndexedMesh& to) {
    std::vector<double> squares = pointDistances(from, to);
    for (double& d : squares)
        d *= d;
    return integralOver(from, squares);
}

/// Mean over the surface, and largest, of the distance from `from`'s points to `to`.
std::pair<double, double> surfaceDistance(const IndexedMesh& from, const IndexedMesh& to) {
    const std::vector<double> distance = pointDistances(from, to);
    const auto [area, sum] = integralOver(from, distance);
    return {sum / area, *std::max_element(distance.begin(), distance.end())};
}

/// Where the limb at a tip ends: the first reach at which the surface within it grows much faster than a tube
/// or cone.
double jointReach(const IndexedMesh& mesh, const std::vector<double>& distance, double size) {
    std::vector<double> within(static_cast<std::size_t>(kLongestReach / kReachStep) + 2, 0);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const double reach = (distance[static_cast<std::size_t>(mesh.F(f, 0))] +
                              distance[static_cast<std::size_t>(mesh.F(f, 1))] +
                              distance[static_cast<std::size_t>(mesh.F(f, 2))]) /
                             3;
        const auto step = static_cast<std::size_t>(reach / (kReachStep * size));
        if (step + 1 < within.size())
            within[step + 1] += doubleAreaVector(mesh, f).norm() / 2;
    }
    for (std::size_t i = 1; i < within.size(); ++i)
        within[i] += within[i - 1];
    const auto first = static_cast<std::size_t>(kFirstReach / kReachStep);
    for (std::size_t i = first; i + 2 < within.size(); ++i) {
        const double growth = (within[i + 2] - within[i]) / 2;
        if (growth * static_cast<double>(i) > kWidening * within[i])
            return static_cast<double>(i) * kReachStep * size;
    }
    return kLongestReach * size;
}

/// Volume of the surface's part on `inside` points, closed by a cone to its rim's mean.
double capVolume(const IndexedMesh& mesh, const std::vector<char>& inside, const Eigen::Vector3d& apex) {
    double sum = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (!inside[static_cast<std::size_t>(mesh.F(f, 0))] ||
            !inside[static_cast<std::size_t>(mesh.F(f, 1))] ||
            !inside[static_cast<std::size_t>(mesh.F(f, 2))])
            continue;
        sum += (mesh.corner(f, 0) - apex).dot((mesh.corner(f, 1) - apex).cross(mesh.corner(f, 2) - apex)) / 6;
    }
    return sum;
}

/// Both shapes with their edge graphs, and which point of the cast each point of the part became (−1: none).
struct Before {
    const IndexedMesh& parted;
    double size;
    EdgeGraph graph;
    EdgeGraph castGraph;
    std::vector<int> castVertex;

    Before(const IndexedMesh& part, const IndexedMesh& cast, const std::vector<int>& sourceVertex)
        : parted(part), size(diagonal(part)), graph(part), castGraph(cast),
          castVertex(static_cast<std::size_t>(part.vertexCount()), -1) {
        for (std::size_t v = 0; v < sourceVertex.size(); ++v)
            castVertex[static_cast<std::size_t>(sourceVertex[v])] = static_cast<int>(v);
    }
};

std::vector<int> tipsOf(const Before& before, const std::vector<Eigen::Vector3d>& wanted) {
    if (wanted.empty())
        return limbTips(before.graph, kProminence * before.size);
    std::vector<int> tips;
    for (const Eigen::Vector3d& p : wanted) {
        Eigen::Index nearest = 0;
        (before.parted.V.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
        tips.push_back(static_cast<int>(nearest));
    }
    return tips;
}

/// The point of the cast that a point of the part became, or, where the clean-up took it, the nearest one
/// left.
int castPointNear(const Before& before, const std::vector<double>& distanceToIt) {
    int nearest = -1;
    for (std::size_t v = 0; v < distanceToIt.size(); ++v)
        if (before.castVertex[v] >= 0 &&
            (nearest < 0 || distanceToIt[v] < distanceToIt[static_cast<std::size_t>(nearest)]))
            nearest = static_cast<int>(v);
    return before.castVertex[static_cast<std::size_t>(nearest)];
}

/// One limb; none where it encloses next to nothing (the corner of a plate).
std::optional<LimbMeasure> measureLimb(const Before& before, const IndexedMesh& cast, int tip) {
    const std::vector<double> was = before.graph.distances({tip});
    const int castTip = castPointNear(before, was);
    const std::vector<double> is = before.castGraph.distances({castTip});
    const double reach = jointReach(before.parted, was, before.size);
    std::vector<char> inside(was.size(), 0);
    std::vector<char> castInside(is.size(), 0);
    double lengthWas = 0;
    double lengthIs = 0;
    int rim = 0;
    Eigen::Vector3d apexWas = Eigen::Vector3d::Zero();
    Eigen::Vector3d apexIs = Eigen::Vector3d::Zero();
    for (std::size_t v = 0; v < was.size(); ++v) {
        const int c = before.castVertex[v];
        inside[v] = was[v] <= reach;
        if (c < 0)
            continue;
        castInside[static_cast<std::size_t>(c)] = inside[v];
        if (std::abs(was[v] - reach) > kReachStep * before.size)
            continue;
        lengthWas += was[v];
        lengthIs += is[static_cast<std::size_t>(c)];
        apexWas += before.parted.point(static_cast<int>(v));
        apexIs += cast.point(c);
        ++rim;
    }
    if (rim == 0)
        return std::nullopt;
    const double volumeWas = capVolume(before.parted, inside, apexWas / rim);
    if (!(volumeWas > kLeastVolume * before.size * before.size * before.size))
        return std::nullopt;
    return LimbMeasure{before.parted.point(tip), lengthIs / lengthWas,
                       capVolume(cast, castInside, apexIs / rim) / volumeWas};
}

} // namespace

Eigen::Isometry3d bestRigidFit(const Points& from, const Points& to) {
    Eigen::Isometry3d fit = Eigen::Isometry3d::Identity();
    fit.matrix() = Eigen::umeyama(from.transpose(), to.transpose(), false);
    return fit;
}

Change measureChange(const IndexedMesh& part, const IndexedMesh& parted, const IndexedMesh& cast,
                     const std::vector<int>& sourceVertex) {
    Points before(cast.V.rows(), 3);
    for (std::size_t v = 0; v < sourceVertex.size(); ++v)
        before.row(static_cast<Eigen::Index>(v)) = parted.V.row(sourceVertex[v]);
    const IndexedMesh fitted = fittedOver(part, before, cast);
    const auto [meanThere, maxThere] = surfaceDistance(cast, fitted);
    const auto [meanBack, maxBack] = surfaceDistance(fitted, cast);
    const double size = diagonal(part);
    return {(meanThere + meanBack) / 2 / size, std::max(maxThere, maxBack) / size,
            volume(cast) / volume(part), 0};
}

Deviation deviation(const IndexedMesh& part, const IndexedMesh& cast, const Points& before) {
    const IndexedMesh fitted = fittedOver(part, before, cast);
    return {faceDistances(cast, fitted), faceDistances(fitted, cast)};
}

double rmsDistance(const IndexedMesh& part, const IndexedMesh& cast, const Points& before) {
    const IndexedMesh fitted = fittedOver(part, before, cast);
    const auto [areaThere, there] = squaredDistance(cast, fitted);
    const auto [areaBack, back] = squaredDistance(fitted, cast);
    return std::sqrt((there + back) / (areaThere + areaBack));
}

std::vector<double> castDifference(const IndexedMesh& cast, const Points& before, const IndexedMesh& other,
                                   const Points& otherBefore) {
    const auto fit = [](const Points& from, const IndexedMesh& to) {
        return from.rows() == 0 ? Eigen::Isometry3d::Identity() : bestRigidFit(from, to.V);
    };
    return faceDistances(cast, movedBy(fit(before, cast) * fit(otherBefore, other).inverse(), other));
}

std::vector<LimbMeasure> measureLimbs(const IndexedMesh& parted, const IndexedMesh& cast,
                                      const std::vector<int>& sourceVertex,
                                      const std::vector<Eigen::Vector3d>& wanted) {
    const Before before(parted, cast, sourceVertex);
    std::vector<LimbMeasure> limbs;
    for (const int tip : tipsOf(before, wanted))
        if (const std::optional<LimbMeasure> limb = measureLimb(before, cast, tip))
            limbs.push_back(*limb);
    return limbs;
}

} // namespace moldwright
