// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/gates.h"

#include "castability/parting_curves.h"
#include "mesh/measures.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d plan(const IndexedMesh& mesh, int v) {
    return mesh.V.row(v).head<2>().transpose();
}

/// The least way down at which both corners of the channel's end lie inside; none where that is more than
/// its width.
std::optional<double> dropInside(const PlanShape& outline, const Vector2d& tip, double width) {
    constexpr int steps = 40;
    for (int step = 1; step < steps; ++step) {
        const double drop = width * step / steps;
        const Vector2d end = tip - Vector2d(0, drop);
        const Vector2d half(width / 2, 0);
        if (insidePlan(outline, end + half) && insidePlan(outline, end - half))
            return drop + width / 10;
    }
    return std::nullopt;
}

/// How wide the outline is at a height, where a channel `width` mm wide about an axis meets it; 0 where it
/// does not.
double roomAt(const PlanShape& outline, const Vector2d& p, double width) {
    std::vector<double> crossings;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vector2d& a = outline[k];
        const Vector2d& b = outline[(k + 1) % outline.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()))
            crossings.push_back(a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    double room = 0;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        if (crossings[k] < p.x() + width / 2 && crossings[k + 1] > p.x() - width / 2)
            room = std::max(room, crossings[k + 1] - crossings[k]);
    return room;
}

/// The width itself, or the widest channel that ends inside the outline where that is nowhere near the tip
/// as wide: a gate round its cavity would reach what stands beside it, and could not be broken off.
double fittingWidth(const PlanShape& outline, const Vector2d& tip, double width) {
    constexpr int steps = 40;
    constexpr double narrower = 0.85; // steel stays on both sides of it
    double room = 0;
    for (int step = 1; step <= steps && room < width; ++step)
        room = std::max(room, roomAt(outline, tip - Vector2d(0, 2 * width * step / steps), width));
    if (room >= width)
        return width;
    for (int step = steps; step > steps / 3; --step)
        if (const double fits = narrower * room * step / steps; dropInside(outline, tip, fits))
            return fits;
    return narrower * room;
}

/// Where a curve is highest over x: the point between its corners, and the corner nearest to it.
std::optional<std::pair<Vector2d, int>> highestOver(const CavityOutline& outline, double x) {
    std::optional<std::pair<Vector2d, int>> highest;
    for (std::size_t k = 0; k < outline.shape.size(); ++k) {
        const std::size_t next = (k + 1) % outline.shape.size();
        const Vector2d& a = outline.shape[k];
        const Vector2d& b = outline.shape[next];
        if ((a.x() > x) == (b.x() > x))
            continue;
        const double t = (x - a.x()) / (b.x() - a.x());
        const Vector2d at(x, a.y() + t * (b.y() - a.y()));
        if (!highest || at.y() > highest->first.y())
            highest = {at, outline.points[t < 0.5 ? k : next]};
    }
    return highest;
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

std::vector<CavityOutline> outlinesOf(const IndexedMesh& cast, const SideLabels& labels) {
    const auto curves = partingCurves(cast, labels);
    if (!curves)
        return {};
    const std::vector<int> component = componentOfPoints(cast);
    std::vector<CavityOutline> outlines;
    for (const PartingCurve& curve : *curves) {
        CavityOutline outline{{}, curve, component[static_cast<std::size_t>(curve.front())]};
        for (const int v : curve)
            outline.shape.push_back(plan(cast, v));
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

std::vector<Gate> gatesOf(const std::vector<CavityOutline>& outlines, double width) {
    std::map<int, Gate> highest;
    for (const CavityOutline& outline : outlines) {
        Gate& gate = highest[outline.solid];
        for (std::size_t k = 0; k < outline.shape.size(); ++k)
            if (gate.point < 0 || outline.shape[k].y() > gate.tip.y()) {
                gate.point = outline.points[k];
                gate.tip = outline.shape[k];
                gate.outline = outline.shape;
            }
    }
    std::vector<Gate> gates;
    for (auto& [number, gate] : highest) {
        gate.width = fittingWidth(gate.outline, gate.tip, width);
        gate.drop = dropInside(gate.outline, gate.tip, gate.width).value_or(gate.width);
        gate.exit = gate.tip.y();
        gates.push_back(std::move(gate));
    }
    return gates;
}

Result<Gate> gateAt(const std::vector<CavityOutline>& outlines, int gate, double x, double width) {
    std::map<int, std::vector<const CavityOutline*>> solids;
    for (const CavityOutline& outline : outlines)
        solids[outline.solid].push_back(&outline);
    const auto& own = std::next(solids.begin(), gate)->second;
    Gate found;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const CavityOutline* outline : own) {
        for (const Vector2d& p : outline->shape) {
            low = std::min(low, p.x());
            high = std::max(high, p.x());
        }
        const auto over = highestOver(*outline, x);
        if (over && (found.point < 0 || over->first.y() > found.tip.y()))
            found = {over->second, over->first, outline->shape, 0, 0, 0, width};
    }
    std::optional<double> drop;
    if (found.point >= 0) {
        found.width = fittingWidth(found.outline, found.tip, width);
        drop = dropInside(found.outline, found.tip, found.width);
        found.exit = exitOf(found.outline, x, width, found.tip.y());
    }
    constexpr double steepest = 1.5; // widths that a slanting outline may rise within the channel
    if (!drop || found.exit - found.tip.y() > steepest * width)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "At x = {0} mm a spout {1} mm wide does not meet the cavity's parting "
                               "line from above, which reaches from {2} to {3} mm. Move it inwards, or "
                               "make its end narrower."),
                       {readable(x), readable(width), readable(low), readable(high)});
    found.drop = *drop;
    return found;
}

double exitOf(const PlanShape& outline, double x, double width, double low) {
    double highest = low;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vector2d& a = outline[k];
        const Vector2d& b = outline[(k + 1) % outline.size()];
        // The piece of the edge within the strip: its ends, and where the strip's sides cut it.
        const double from = std::max(std::min(a.x(), b.x()), x - width / 2);
        const double to = std::min(std::max(a.x(), b.x()), x + width / 2);
        if (from > to)
            continue;
        const auto heightAt = [&](double at) {
            return a.x() == b.x() ? std::max(a.y(), b.y())
                                  : a.y() + (at - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
        };
        highest = std::max({highest, heightAt(from), heightAt(to)});
    }
    return highest;
}

std::optional<Vector2d> topOver(const std::vector<CavityOutline>& outlines, double x,
                                const std::vector<int>& points) {
    std::optional<std::pair<Vector2d, int>> highest;
    for (const CavityOutline& outline : outlines) {
        const auto over = highestOver(outline, x);
        if (over && (!highest || over->first.y() > highest->first.y()))
            highest = over;
    }
    if (!highest || std::find(points.begin(), points.end(), highest->second) == points.end())
        return std::nullopt;
    return highest->first;
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
        const std::vector<Gate> gates = gatesOf(outlinesOf(turned, labels), width);
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
