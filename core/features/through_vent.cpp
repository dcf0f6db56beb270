// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/through_vent.h"

#include "base/stop_point.h"
#include "castability/overhang.h"
#include "features/wall_slope.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Ways from a high point to where a vent's foot has room: first down again, as far as that is in the plane.
std::vector<Vector2d> waysFrom(const Vector3d& up) {
    const bool leans = up.head<2>().norm() > 0;
    const Vector2d down = leans ? Vector2d(-up.head<2>().normalized()) : Vector2d(Vector2d::UnitX());
    constexpr int count = 8;
    std::vector<Vector2d> ways = planCircle(Vector2d::Zero(), 1, count);
    for (Vector2d& way : ways)
        way = way.x() * down + way.y() * Vector2d(-down.y(), down.x());
    return ways;
}

std::optional<ThroughVent> ventAt(PlanShape base, double foot, int side, const Vector3d& d,
                                  const ThroughVentRequest& request) {
    PrismRequest prism;
    prism.base = std::move(base);
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

/// Whether points lie inside the cast on one side.
class ThroughVents::InsideSide {
public:
    InsideSide(const IndexedMesh& cast, const SideLabels& labels, int side, const Vector3d& d)
        : m_side(side), m_d(d), m_over(cast, facesOf(labels, side), d) {}

    [[nodiscard]] bool holds(const PlanShape& shape, double height, double margin) const {
        const double z = m_side == 1 ? height : -height;
        return std::all_of(shape.begin(), shape.end(),
                           [&](const Vector2d& p) { return m_over.above({p.x(), p.y(), z}) > margin; });
    }

    /// The highest point along `up` of where a circle and its centre, moved along d, leave the cast, mm.
    [[nodiscard]] double highest(PlanShape circle, const Vector2d& centre, double height,
                                 const Vector3d& up) const {
        circle.push_back(centre);
        double most = -std::numeric_limits<double>::infinity();
        for (const Vector2d& p : circle) {
            const Vector3d foot(p.x(), p.y(), m_side == 1 ? height : -height);
            most = std::max(most, (foot + m_over.above(foot) * m_d).dot(up));
        }
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
    Vector3d m_d;
    Overhang m_over;
};

IndexedMesh ThroughVent::solid() const {
    IndexedMesh mesh = *prismSolid(body);
    mesh.V.col(2).array() += side == 1 ? foot : -foot;
    return mesh;
}

ThroughVents::ThroughVents(const IndexedMesh& cast, const SideLabels& labels, const Directions& directions)
    : m_cast(cast), m_labels(labels), m_directions(directions) {}

ThroughVents::~ThroughVents() = default;

const ThroughVents::InsideSide& ThroughVents::inside(int side) {
    std::unique_ptr<InsideSide>& known = m_inside[side == 1 ? 0 : 1];
    if (!known)
        known = std::make_unique<InsideSide>(m_cast, m_labels, side, m_directions.of(side));
    return *known;
}

std::optional<ThroughVent> ThroughVents::from(int side, const Vector3d& highPoint, const Vector3d& up,
                                              const ThroughVentRequest& request) {
    const Vector3d& d = m_directions.of(side);
    const std::optional<double> wider = narrowing(side, d, request.draftDegrees);
    if (!wider)
        return std::nullopt;
    const InsideSide& inside = this->inside(side);
    const PlanShape unit = planCircle(Vector2d::Zero(), 1, corners);
    const std::vector<Vector2d> ways = waysFrom(up);
    const double top = std::abs(highPoint.z());
    constexpr int levels = 8;
    // Nearest to the point first: what lies above the foot's highest point stays as a bubble.
    for (int step = request.quartersAway; step <= request.quartersMost; ++step)
        for (const Vector2d& way : ways) {
            stopPoint();
            for (int level = 0; level < levels; ++level) {
                const double foot = onGrid(top * (levels - level) / (levels + 1), request.grid);
                const double radius = request.diameter / 2 + *wider * (request.end - foot) + 4 * request.grid;
                const Vector2d centre = highPoint.head<2>() + way * radius * 0.25 * step +
                                        d.head<2>() / d.z() * ((side == 1 ? foot : -foot) - highPoint.z());
                PlanShape circle = unit;
                for (Vector2d& p : circle)
                    p = centre + radius * p;
                if (foot <= 0 || !inside.holds(circle, foot, 0.1 * request.diameter))
                    continue;
                std::optional<ThroughVent> vent = ventAt(std::move(circle), foot, side, d, request);
                if (!vent)
                    continue;
                vent->reach = inside.highest(vent->body.base, centre, foot, up);
                return vent;
            }
        }
    return std::nullopt;
}

} // namespace moldwright
