// SPDX-License-Identifier: AGPL-3.0-or-later
#include "features/drafted_prism.h"

#include "features/cgal/constrained_triangulation.h"
#include "features/wall_slope.h"
#include "mesh/point_rows.h"
#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const DraftedPrism::Opening* openingAt(const std::vector<DraftedPrism::Opening>& openings, std::size_t edge) {
    const auto found = std::find_if(openings.begin(), openings.end(),
                                    [edge](const DraftedPrism::Opening& o) { return o.edge == edge; });
    return found == openings.end() ? nullptr : &*found;
}

Result<std::vector<double>> slopesOf(const PrismRequest& request, std::size_t side) {
    std::vector<double> slopes = request.slopes[side];
    if (!slopes.empty())
        return slopes;
    for (std::size_t edge = 0; edge < request.base.size(); ++edge) {
        if (const auto* opening = openingAt(request.openings, edge)) {
            slopes.push_back(-opening->slope[side]);
            continue;
        }
        const std::optional<double> slope =
            wallSlope(outwardNormal(request.base, edge), static_cast<int>(side) + 1, request.directions[side],
                      request.draftDegrees);
        if (!slope)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "A wall at the parting plane would have to lie flat to leave along "
                                   "the removal directions with {0}°."),
                           {readable(request.draftDegrees)});
        slopes.push_back(std::max(*slope, request.leastSlope));
    }
    return slopes;
}

/// Every edge of the lid keeps its way: else walls met below it.
bool keepsItsEdges(const PlanShape& base, const PlanShape& lid) {
    for (std::size_t k = 0; k < base.size(); ++k) {
        const std::size_t next = (k + 1) % base.size();
        constexpr double least = 0.02; // of the foot's length
        const Vector2d foot = base[next] - base[k];
        if ((lid[next] - lid[k]).dot(foot) <= least * foot.squaredNorm())
            return false;
    }
    return true;
}

void addFaces(std::vector<Eigen::RowVector3i>& faces, const Triangles& more, const std::vector<int>& numbers,
              bool turned) {
    for (const auto& t : more.rowwise()) {
        const auto n = [&](int k) { return numbers[static_cast<std::size_t>(t[k])]; };
        faces.emplace_back(n(0), turned ? n(2) : n(1), turned ? n(1) : n(2));
    }
}

/// Collects points and faces of a surface; equal points are welded at the end.
class Surface {
public:
    int point(const Vector3d& p) {
        m_points.push_back(p);
        return static_cast<int>(m_points.size()) - 1;
    }
    /// A flat polygon whose points in `flat` run counter-clockwise as seen from outside, or the mirror image.
    bool polygon(const std::vector<Vector3d>& corners, const std::vector<Vector2d>& flat, bool turned) {
        std::vector<int> numbers;
        std::vector<std::array<int, 2>> outline;
        const int count = static_cast<int>(corners.size());
        for (int k = 0; k < count; ++k) {
            numbers.push_back(point(corners[static_cast<std::size_t>(k)]));
            outline.push_back({k, (k + 1) % count});
        }
        const std::optional<Triangles> triangles = triangulateRegion(flat, outline);
        if (!triangles)
            return false;
        addFaces(m_faces, *triangles, numbers, turned);
        return true;
    }
    [[nodiscard]] IndexedMesh mesh() const {
        IndexedMesh mesh;
        mesh.V = pointRows(m_points);
        mesh.F.resize(static_cast<Eigen::Index>(m_faces.size()), 3);
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            mesh.F.row(static_cast<Eigen::Index>(f)) = m_faces[f];
        return weldEqualPoints(mesh).mesh;
    }

private:
    std::vector<Vector3d> m_points;
    std::vector<Eigen::RowVector3i> m_faces;
};

/// Those at one edge, in their order along it.
std::vector<Guest> guestsAlong(const DraftedPrism& prism, std::size_t edge,
                               const std::vector<Guest>& guests) {
    std::vector<Guest> along;
    for (const Guest& guest : guests)
        if (guest.edge == edge)
            along.push_back(guest);
    const Vector2d way = prism.base[(edge + 1) % prism.base.size()] - prism.base[edge];
    const auto place = [&](const Guest& guest) {
        return way.dot(guest.prism->base[guest.prism->openings.front().edge] + guest.moved);
    };
    std::sort(along.begin(), along.end(),
              [&](const Guest& a, const Guest& b) { return place(a) < place(b); });
    return along;
}

/// The flat foot on a side where nothing stands; guests' ends are points of its border.
void addFoot(Surface& surface, const DraftedPrism& prism, int side, const std::vector<Guest>& guests) {
    std::vector<Vector3d> corners;
    PlanShape flat;
    for (std::size_t edge = 0; edge < prism.base.size(); ++edge) {
        flat.push_back(prism.base[edge]);
        for (const Guest& guest : guestsAlong(prism, edge, guests)) {
            const std::size_t from = guest.prism->openings.front().edge;
            flat.push_back(guest.prism->base[(from + 1) % guest.prism->base.size()] + guest.moved);
            flat.push_back(guest.prism->base[from] + guest.moved);
        }
    }
    for (const Vector2d& p : flat)
        corners.emplace_back(p.x(), p.y(), 0);
    surface.polygon(corners, flat, side == 2);
}

/// A wall's polygon from its foot's start to its end, round the sections of the guests, and back along the
/// lid. False where guests overlap.
bool addWall(Surface& surface, const DraftedPrism& prism, int side, std::size_t edge,
             const std::vector<Guest>& guests) {
    const std::size_t next = (edge + 1) % prism.base.size();
    const Vector3d start = prism.foot(edge);
    const Vector3d along = (prism.foot(next) - start).normalized();
    std::vector<Vector3d> corners{start};
    for (const Guest& guest : guestsAlong(prism, edge, guests)) {
        const DraftedPrism& g = *guest.prism;
        const std::size_t from = g.openings.front().edge; // runs against the host's edge
        const std::size_t to = (from + 1) % g.base.size();
        const Vector3d by(guest.moved.x(), guest.moved.y(), 0);
        for (const Vector3d& p : std::array{g.foot(to), g.top(side, to), g.top(side, from), g.foot(from)})
            corners.push_back(p + by);
    }
    corners.insert(corners.end(), {prism.foot(next), prism.top(side, next), prism.top(side, edge)});
    std::vector<Vector2d> flat;
    for (const Vector3d& p : corners)
        flat.emplace_back((p - start).dot(along), std::abs(p.z()));
    return surface.polygon(corners, flat, side == 2);
}

void addLid(Surface& surface, const DraftedPrism& prism, int side) {
    std::vector<Vector3d> corners;
    for (std::size_t k = 0; k < prism.base.size(); ++k)
        corners.push_back(prism.top(side, k));
    surface.polygon(corners, prism.lid[side == 1 ? 0 : 1], side == 2);
}

bool addSide(Surface& surface, const DraftedPrism& prism, int side, const std::vector<Guest>& guests) {
    for (std::size_t edge = 0; edge < prism.base.size(); ++edge)
        if (openingAt(prism.openings, edge) == nullptr && !addWall(surface, prism, side, edge, guests))
            return false;
    addLid(surface, prism, side);
    return true;
}

/// The section at an opening, on both sides.
void addSection(Surface& surface, const DraftedPrism& prism, std::size_t from) {
    const std::size_t to = (from + 1) % prism.base.size();
    const Vector3d along = (prism.foot(to) - prism.foot(from)).normalized();
    for (const int side : {1, 2}) {
        if (!prism.stands(side))
            continue;
        const std::vector<Vector3d> section = {prism.foot(from), prism.foot(to), prism.top(side, to),
                                               prism.top(side, from)};
        std::vector<Vector2d> flat;
        for (const Vector3d& p : section)
            flat.emplace_back((p - section[0]).dot(along), std::abs(p.z()));
        surface.polygon(section, flat, side == 2);
    }
}

/// A lid that closes before its height is reached, in the words of what is being made.
std::unexpected<Error> closesEarly(const PrismRequest& request, double height) {
    if (!request.closed.text.empty())
        return failure(ErrorCode::Impossible, request.closed.text, request.closed.arguments);
    return failure(ErrorCode::Impossible,
                   MW_TEXT("Mold",
                           "A channel {0} mm deep closes before its floor: it is too narrow for the lean "
                           "that its walls need. Make it wider, or take less draft."),
                   {readable(height)});
}

} // namespace

double onGrid(double value, double grid) {
    return grid > 0 ? std::round(value / grid) * grid : value;
}

Vector3d DraftedPrism::top(int side, std::size_t k) const {
    const std::size_t i = side == 1 ? 0 : 1;
    return {lid[i][k].x(), lid[i][k].y(), side == 1 ? height[0] : -height[1]};
}

DraftedPrism movedPrism(DraftedPrism prism, const Vector2d& by) {
    prism.base = movedPlan(std::move(prism.base), by);
    for (PlanShape& lid : prism.lid)
        lid = movedPlan(std::move(lid), by);
    return prism;
}

Result<DraftedPrism> draftedPrism(const PrismRequest& request) {
    DraftedPrism prism;
    prism.grid = request.grid;
    for (const Vector2d& p : request.base)
        prism.base.emplace_back(onGrid(p.x(), request.grid), onGrid(p.y(), request.grid));
    prism.openings = request.openings;
    for (std::size_t side = 0; side < 2; ++side) {
        const double height = prism.height[side] = onGrid(request.height[side], request.grid);
        if (height <= 0)
            continue;
        Result<std::vector<double>> slopes = slopesOf(request, side);
        if (!slopes)
            return std::unexpected(slopes.error());
        std::vector<double> insets;
        for (const double slope : *slopes)
            insets.push_back(height * slope);
        for (const Vector2d& corner : insetShape(prism.base, insets))
            prism.lid[side].emplace_back(onGrid(corner.x(), request.grid), onGrid(corner.y(), request.grid));
        if (!keepsItsEdges(prism.base, prism.lid[side]))
            return closesEarly(request, height);
        prism.slope[side] = *std::move(slopes);
    }
    return prism;
}

Result<DraftedPrism> prismAsHighAsFits(PrismRequest request) {
    Result<DraftedPrism> prism = draftedPrism(request);
    constexpr int steps = 12;
    constexpr double lower = 0.8;
    for (int step = 0; step < steps && !prism; ++step) {
        for (double& height : request.height)
            height *= lower;
        prism = draftedPrism(request);
    }
    return prism;
}

std::optional<IndexedMesh> prismSurface(const DraftedPrism& prism, int side,
                                        const std::vector<Guest>& guests) {
    Surface surface;
    if (!prism.stands(side))
        addFoot(surface, prism, side, guests);
    else if (!addSide(surface, prism, side, guests))
        return std::nullopt;
    return surface.mesh();
}

std::optional<IndexedMesh> prismSolid(const DraftedPrism& prism) {
    Surface surface;
    for (const int side : {1, 2})
        if (prism.stands(side)) {
            if (!addSide(surface, prism, side, {}))
                return std::nullopt;
        } else {
            addFoot(surface, prism, side, {});
        }
    for (const DraftedPrism::Opening& opening : prism.openings)
        addSection(surface, prism, opening.edge);
    return surface.mesh();
}

std::vector<Vector3d> openingPoints(const DraftedPrism& prism) {
    std::vector<Vector3d> points;
    for (const DraftedPrism::Opening& opening : prism.openings)
        for (const std::size_t k : {opening.edge, (opening.edge + 1) % prism.base.size()}) {
            points.push_back(prism.foot(k));
            for (const int side : {1, 2})
                if (prism.stands(side))
                    points.push_back(prism.top(side, k));
        }
    return points;
}

} // namespace moldwright
