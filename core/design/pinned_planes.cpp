// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/pinned_planes.h"

#include "castability/energy.h"
#include "design/stopwatch.h"
#include "mesh/measures.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>

namespace moldwright {

namespace {

constexpr int kBestPlanes = 60;
constexpr double kPinsCount = 10; ///< beside the energy: a pin is what was asked for, undercuts can be bent
constexpr double kOneLine = 1e-3; ///< diagonals: pins no farther from a line leave the plane open

/// The plane of least squares through the pins; none where a line passes through all of them.
std::optional<PartingPlane> planeThrough(const std::vector<Pin>& pins, double size) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const Pin& pin : pins)
        centre += pin.point / static_cast<double>(pins.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Pin& pin : pins)
        spread += (pin.point - centre) * (pin.point - centre).transpose() / static_cast<double>(pins.size());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    if (!(std::sqrt(std::max(0.0, axes.eigenvalues()[1])) > kOneLine * size))
        return std::nullopt;
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    return PartingPlane{normal, normal.dot(centre)};
}

} // namespace

std::vector<PartingPlane> planesForPins(DesignRun& run, int count) {
    const IndexedMesh& part = *run.request().part;
    const std::vector<Pin>& pins = run.request().pins;
    const double size = diagonal(part);
    struct Judged {
        PartingPlane plane;
        double cost;
    };
    std::vector<Judged> judged;
    const auto judge = [&](const PartingPlane& plane, double energy) {
        double squares = 0;
        for (const Pin& pin : pins)
            squares += std::pow(plane.distance(pin.point) / size, 2) / static_cast<double>(pins.size());
        judged.push_back({plane, energy + kPinsCount * squares});
    };
    std::vector<PlaneCandidate> best;
    {
        const Stopwatch watch(run.seconds(), "plane");
        best = findPlanes(part, run.planeSearch(kBestPlanes), run.task().part(0, 0.1));
    }
    if (run.stopped())
        return {};
    for (const PlaneCandidate& candidate : best)
        judge(candidate.state.plane, candidate.energy);
    if (const std::optional<PartingPlane> through = planeThrough(pins, size)) {
        const MoldState state{*through, run.directionsFor(part, *through)};
        judge(*through,
              castabilityEnergy(part, state, std::sin(radians(run.request().draftDegrees))) / (size * size));
    }
    std::stable_sort(judged.begin(), judged.end(),
                     [](const Judged& a, const Judged& b) { return a.cost < b.cost; });
    std::vector<PartingPlane> planes;
    for (const Judged& j : judged)
        if (static_cast<int>(planes.size()) < count)
            planes.push_back(j.plane);
    return planes;
}

} // namespace moldwright
