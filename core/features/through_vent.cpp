// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/through_vent.h"

#include "castability/overhang.h"
#include "features/wall_slope.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int corners = 16;

/// How much wider the foot is than the mouth, per mm of length: the vent narrows about its own axis.
std::optional<double> narrowing(int side, const Vector3d& d, double draft) {
    const Vector2d axis = d.head<2>() / std::abs(d.z());
    double most = 0;
    for (const Vector2d& m : planCircle(Vector2d::Zero(), 1, corners)) {
        const std::optional<double> slope = wallSlope(m, side, {d}, draft);
        if (!slope)
            return std::nullopt;
        most = std::max(most, *slope + m.dot(axis));
    }
    return most;
}

/// Whether points lie inside the cast on one side.
class InsideSide {
public:
    InsideSide(const IndexedMesh& cast, const SideLabels& labels, int side, const Vector3d& d)
        : m_side(side), m_along(std::abs(d.z())), m_over(cast, facesOf(labels, side), d) {}

    [[nodiscard]] bool holds(const PlanShape& shape, double height, double margin) const {
        const double z = m_side == 1 ? height : -height;
        return std::all_of(shape.begin(), shape.end(),
                           [&](const Vector2d& p) { return m_over.above({p.x(), p.y(), z}) > margin; });
    }

    /// The cast's highest point over a circle and its centre, mm.
    [[nodiscard]] double highest(PlanShape circle, const Vector2d& centre, double height) const {
        circle.push_back(centre);
        double most = 0;
        for (const Vector2d& p : circle)
            most = std::max(most, height + m_over.above({p.x(), p.y(), height}) * m_along);
        return most;
    }

private:
    static std::vector<int> facesOf(const SideLabels& labels, int side) {
        std::vector<int> faces;
        for (std::size_t f = 0; f < labels.size(); ++f)
            if (labels[f] == side)
                faces.push_back(static_cast<int>(f));
        return faces;
    }
    int m_side;
    double m_along; ///< height won along the direction
    Overhang m_over;
};

/// Ways from a high point to where a vent's foot has room: down again, or any way where that is into the
/// half.
std::vector<Vector2d> waysFrom(const Vector3d& up) {
    if (up.z() == 0)
        return {-up.head<2>().normalized()};
    constexpr int ways = 8;
    return planCircle(Vector2d::Zero(), 1, ways);
}

std::optional<ThroughVent> ventAt(const Vector2d& centre, double foot, int side, const Vector3d& d,
                                  double radius, const ThroughVentRequest& request) {
    PrismRequest prism;
    prism.base = planCircle(centre, radius, corners);
    prism.height[side == 1 ? 0 : 1] = request.end - foot;
    prism.directions[side == 1 ? 0 : 1] = {d};
    prism.draftDegrees = request.draftDegrees;
    prism.grid = request.grid;
    Result<DraftedPrism> body = draftedPrism(prism);
    if (!body)
        return std::nullopt;
    ThroughVent vent;
    vent.side = side;
    vent.body = *std::move(body);
    vent.foot = foot;
    Vector2d mouth = Vector2d::Zero();
    for (const Vector2d& p : vent.body.lid[side == 1 ? 0 : 1])
        mouth += p / corners;
    vent.mouth = {mouth.x(), mouth.y(), side == 1 ? request.end : -request.end};
    return vent;
}

} // namespace

IndexedMesh ThroughVent::solid() const {
    IndexedMesh mesh = *prismSolid(body);
    mesh.V.col(2).array() += side == 1 ? foot : -foot;
    return mesh;
}

std::optional<ThroughVent> throughVent(const IndexedMesh& cast, const SideLabels& labels,
                                       const Directions& directions, int side, const Vector3d& highPoint,
                                       const Vector3d& up, const ThroughVentRequest& request) {
    const Vector3d& d = directions.of(side);
    const std::optional<double> wider = narrowing(side, d, request.draftDegrees);
    if (!wider)
        return std::nullopt;
    const InsideSide inside(cast, labels, side, d);
    const double top = std::abs(highPoint.z());
    constexpr int levels = 8;
    constexpr int steps = 12;
    // Nearest to the point first: what lies above the foot's highest point stays as a bubble.
    for (int step = 0; step <= steps; ++step)
        for (const Vector2d& way : waysFrom(up))
            for (int level = 0; level < levels; ++level) {
                const double foot = onGrid(top * (levels - level) / (levels + 1), request.grid);
                const double radius = request.diameter / 2 + *wider * (request.end - foot) + 4 * request.grid;
                const bool upright = up.z() != 0;
                const Vector2d centre = highPoint.head<2>() +
                                        way * radius * ((upright ? 0 : 1) + 0.25 * step) +
                                        d.head<2>() / d.z() * ((side == 1 ? foot : -foot) - highPoint.z());
                const PlanShape circle = planCircle(centre, radius, corners);
                if (foot <= 0 || !inside.holds(circle, foot, 0.1 * request.diameter))
                    continue;
                std::optional<ThroughVent> vent = ventAt(centre, foot, side, d, radius, request);
                if (!vent)
                    continue;
                vent->reach =
                    upright ? inside.highest(circle, centre, foot) : centre.dot(up.head<2>()) + radius;
                return vent;
            }
    return std::nullopt;
}

} // namespace moldwright
