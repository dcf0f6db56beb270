// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/gates.h"

#include "castability/parting_curves.h"
#include "mesh/measures.h"

#include <algorithm>
#include <limits>
#include <map>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d plan(const IndexedMesh& mesh, int v) {
    return mesh.V.row(v).head<2>().transpose();
}

/// The least way down at which both corners of the channel's end lie inside; at most its width.
double dropInside(const PlanShape& outline, const Vector2d& tip, const Vector2d& up, double width) {
    const Vector2d across(up.y(), -up.x());
    constexpr int steps = 40;
    for (int step = 1; step < steps; ++step) {
        const double drop = width * step / steps;
        const Vector2d end = tip - drop * up;
        if (insidePlan(outline, end + across * width / 2) && insidePlan(outline, end - across * width / 2))
            return drop + width / 10;
    }
    return width;
}

/// Component of each point.
std::vector<int> componentOfPoints(const IndexedMesh& cast) {
    const Components components = connectedComponents(cast);
    std::vector<int> ofPoint(static_cast<std::size_t>(cast.vertexCount()), -1);
    for (int f = 0; f < cast.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            ofPoint[static_cast<std::size_t>(cast.F(f, k))] = components.ofFace[static_cast<std::size_t>(f)];
    return ofPoint;
}

/// Gates with a piece of another solid's outline above them.
int blockedGates(const IndexedMesh& cast, const std::vector<Gate>& gates, double width) {
    int blocked = 0;
    for (const Gate& gate : gates) {
        const Vector2d tip = plan(cast, gate.point);
        const auto isAbove = [&](const Vector2d& a, const Vector2d& b) {
            return std::max(a.y(), b.y()) > tip.y() && std::max(a.x(), b.x()) > tip.x() - width / 2 &&
                   std::min(a.x(), b.x()) < tip.x() + width / 2;
        };
        bool free = true;
        for (const Gate& other : gates)
            for (std::size_t k = 0; k < other.outline.size(); ++k)
                free = free && !isAbove(other.outline[k], other.outline[(k + 1) % other.outline.size()]);
        blocked += free ? 0 : 1;
    }
    return blocked;
}

} // namespace

std::vector<Gate> gatesOf(const IndexedMesh& cast, const SideLabels& labels, const Vector2d& up,
                          double width) {
    const std::vector<int> component = componentOfPoints(cast);
    std::map<int, Gate> highest;
    const auto curves = partingCurves(cast, labels);
    for (const PartingCurve& curve : *curves)
        for (const int v : curve) {
            Gate& gate = highest[component[static_cast<std::size_t>(v)]];
            if (gate.point >= 0 && plan(cast, v).dot(up) <= plan(cast, gate.point).dot(up))
                continue;
            gate.point = v;
            gate.outline.clear();
            for (const int w : curve)
                gate.outline.push_back(plan(cast, w));
        }
    std::vector<Gate> gates;
    for (auto& [number, gate] : highest) {
        gate.drop = dropInside(gate.outline, plan(cast, gate.point), up, width);
        gates.push_back(std::move(gate));
    }
    return gates;
}

std::vector<AirTrap> trapsOf(const IndexedMesh& cast, const std::vector<int>& drains, const Vector3d& up,
                             double smallest) {
    const std::vector<int> component = componentOfPoints(cast);
    std::vector<AirTrap> all;
    for (const int drain : drains) {
        // Points of other solids never meet this one's drain; theirs are found with their own.
        for (AirTrap& trap : airTraps(cast, up, drain, smallest))
            if (component[static_cast<std::size_t>(trap.point)] == component[static_cast<std::size_t>(drain)])
                all.push_back(std::move(trap));
    }
    return all;
}

std::vector<int> drainsOf(const std::vector<Gate>& gates) {
    std::vector<int> drains;
    for (const Gate& gate : gates)
        drains.push_back(gate.point);
    return drains;
}

int bestQuarterTurn(const IndexedMesh& cast, const SideLabels& labels, double width, double smallestTrap) {
    int best = 0;
    std::pair<int, double> least{std::numeric_limits<int>::max(), 0};
    for (int quarters = 0; quarters < 4; ++quarters) {
        const IndexedMesh turned = quarterTurned(cast, quarters);
        const std::vector<Gate> gates = gatesOf(turned, labels, Vector2d::UnitY(), width);
        std::pair<int, double> cost{blockedGates(turned, gates, width), 0};
        for (const AirTrap& trap : trapsOf(turned, drainsOf(gates), Vector3d::UnitY(), smallestTrap))
            cost.second += trap.volume;
        if (cost < least) {
            best = quarters;
            least = cost;
        }
    }
    return best;
}

IndexedMesh quarterTurned(const IndexedMesh& mesh, int quarters) {
    IndexedMesh turned = mesh;
    for (int turn = 0; turn < quarters; ++turn) {
        const Eigen::VectorXd x = turned.V.col(0);
        turned.V.col(0) = -turned.V.col(1);
        turned.V.col(1) = x;
    }
    return turned;
}

} // namespace moldwright
