// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/block.h"

#include "features/wall_slope.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moldwright {

namespace {

using Eigen::AlignedBox2d;
using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// `length` rounded up to a multiple of `step`, and to one of the grid.
double roundedUp(double length, double step, double grid) {
    const double rounded = step > 0 ? std::ceil(length / step - 1e-9) * step : length;
    return grid > 0 ? std::ceil(rounded / grid - 1e-9) * grid : rounded;
}

/// What a length lacks to the next of the stock; none where it is longer than all.
std::optional<double> missingToStock(double length, const std::vector<double>& stock) {
    if (stock.empty())
        return 0;
    std::optional<double> least;
    for (const double has : stock)
        if (has >= length - 1e-9 && (!least || has - length < *least))
            least = std::max(0.0, has - length);
    return least;
}

/// Inset over height of an outer wall whose foot looks along m. The half, or the form about it, leaves along
/// d: so with draft its walls widen from the plane, and with less than 0 they narrow.
Result<double> outerSlope(const Vector2d& m, int side, const MoldSettings& settings,
                          const Directions& directions) {
    const double draft = settings.outerDraft;
    if (draft == 0)
        return 0;
    constexpr double margin = 0.01; // degrees; rounding to the grid takes less
    const std::optional<double> lean =
        wallSlope(draft > 0 ? Vector2d(-m) : m, side, {directions.of(side)}, std::abs(draft) + margin);
    if (!lean)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "An outer face of the block would have to lie flat to have {0}° of draft "
                               "along the removal directions."),
                       {readable(draft)});
    return draft > 0 ? std::min(0.0, -*lean) : std::max(0.0, *lean);
}

Result<Block> blockOn(PlanShape outline, const std::array<double, 2>& height, const MoldSettings& settings,
                      const BlockRules& rules) {
    PrismRequest request;
    request.base = std::move(outline);
    request.height = height;
    request.grid = rules.grid;
    for (const int side : {1, 2})
        for (std::size_t edge = 0; edge < request.base.size(); ++edge) {
            const Result<double> slope =
                outerSlope(outwardNormal(request.base, edge), side, settings, rules.directions);
            if (!slope)
                return std::unexpected(slope.error());
            request.slopes[side == 1 ? 0 : 1].push_back(*slope);
        }
    Result<DraftedPrism> body = draftedPrism(request);
    if (!body)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold", "The block's outer faces meet before its back: take less draft."));
    return Block{*std::move(body)};
}

/// Distance of a point from the plane of a wall on `side` of the parting plane; below 0 outside.
double behindWall(const DraftedPrism& body, std::size_t edge, int side, const Vector3d& p) {
    const double slope = body.slope[side == 1 ? 0 : 1][edge];
    const double along = outwardNormal(body.base, edge).dot(body.base[edge] - p.head<2>());
    return (along - slope * std::abs(p.z())) / std::hypot(1, slope);
}

int sideOf(const Vector3d& p) {
    return p.z() >= 0 ? 1 : 2;
}

/// The corner of a box on `side` of the parting plane that is nearest to a wall: what a wall's distance is
/// made from only grows away from there, rounding included.
Vector3d cornerTowards(const DraftedPrism& body, std::size_t edge, int side, const AlignedBox3d& box) {
    const Vector2d outwards = outwardNormal(body.base, edge);
    const bool narrows = body.slope[side == 1 ? 0 : 1][edge] > 0;
    const double far = side == 1 ? box.max().z() : box.min().z();
    const double near = side == 1 ? std::max(0.0, box.min().z()) : std::min(0.0, box.max().z());
    return {outwards.x() > 0 ? box.max().x() : box.min().x(),
            outwards.y() > 0 ? box.max().y() : box.min().y(), narrows ? far : near};
}

/// How far an outer face that looks along m comes in up to the block's back.
double narrowing(const DraftedPrism& body, std::size_t edge) {
    double most = 0;
    for (const std::size_t i : {0UL, 1UL})
        most = std::max(most, body.slope[i][edge] * body.height[i]);
    return most;
}

/// What of a convex outline lies where m·p ≤ reach.
PlanShape clipped(const PlanShape& outline, const Vector2d& m, double reach) {
    PlanShape kept;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vector2d& a = outline[k];
        const Vector2d& b = outline[(k + 1) % outline.size()];
        const double beyondA = m.dot(a) - reach;
        const double beyondB = m.dot(b) - reach;
        if (beyondA <= 0)
            kept.push_back(a);
        if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0))
            kept.emplace_back(a + beyondA / (beyondA - beyondB) * (b - a));
    }
    return kept;
}

double shortestEdge(const PlanShape& outline) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < outline.size(); ++k)
        least = std::min(least, (outline[(k + 1) % outline.size()] - outline[k]).norm());
    return least;
}

} // namespace

AlignedBox2d Block::plan() const {
    AlignedBox2d box;
    for (const Vector2d& p : body.base)
        box.extend(p);
    return box;
}

AlignedBox3d Block::box() const {
    AlignedBox3d box;
    for (std::size_t k = 0; k < body.base.size(); ++k) {
        box.extend(body.foot(k));
        for (const int side : {1, 2})
            box.extend(body.top(side, k));
    }
    return box;
}

double Block::volume() const {
    return moldwright::volume(*prismSolid(body));
}

double Block::depthOf(const Vector3d& p) const {
    double least = std::min(end(1) - p.z(), p.z() - end(2));
    for (std::size_t edge = 0; edge < body.base.size(); ++edge)
        least = std::min(least, behindWall(body, edge, sideOf(p), p));
    return least;
}

double Block::depthOf(const AlignedBox3d& box) const {
    double least = std::min(end(1) - box.max().z(), box.min().z() - end(2));
    for (const int side : {1, 2}) {
        if (side == 1 ? box.max().z() < 0 : box.min().z() >= 0)
            continue;
        for (std::size_t edge = 0; edge < body.base.size(); ++edge)
            least = std::min(least, behindWall(body, edge, side, cornerTowards(body, edge, side, box)));
    }
    return least;
}

std::optional<std::size_t> Block::wallWith(const std::array<Vector3d, 3>& points, double tolerance) const {
    for (std::size_t edge = 0; edge < body.base.size(); ++edge)
        if (std::all_of(points.begin(), points.end(), [&](const Vector3d& p) {
                return std::abs(behindWall(body, edge, sideOf(p), p)) <= tolerance;
            }))
            return edge;
    return std::nullopt;
}

double Block::depthOf(const Vector2d& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t edge = 0; edge < body.base.size(); ++edge)
        least =
            std::min(least, outwardNormal(body.base, edge).dot(body.base[edge] - p) - narrowing(body, edge));
    return least;
}

std::array<double, 2> Block::flare(const Vector2d& m) const {
    std::size_t facing = 0;
    for (std::size_t edge = 1; edge < body.base.size(); ++edge)
        if (outwardNormal(body.base, edge).dot(m) > outwardNormal(body.base, facing).dot(m))
            facing = edge;
    return {-body.slope[0][facing], -body.slope[1][facing]};
}

Result<std::array<double, 2>> outerFlare(const Vector2d& m, const MoldSettings& settings,
                                         const Directions& directions) {
    std::array<double, 2> flare{0, 0};
    for (const int side : {1, 2}) {
        const Result<double> slope = outerSlope(m, side, settings, directions);
        if (!slope)
            return std::unexpected(slope.error());
        flare[side == 1 ? 0 : 1] = -*slope;
    }
    return flare;
}

Block uprightBlock(const AlignedBox3d& box) {
    PrismRequest request;
    request.base = planRectangle(box.min().head<2>(), box.max().head<2>());
    request.height = {box.max().z(), -box.min().z()};
    request.slopes = {std::vector<double>(4, 0), std::vector<double>(4, 0)};
    return {*draftedPrism(request)};
}

Result<Block> blockAround(const BlockContent& content, const MoldSettings& settings,
                          const BlockRules& rules) {
    const AlignedBox3d& cast = content.cavities;
    const double step = settings.step;
    const double grid = rules.grid;
    const auto reaching = [&](double cavity, double steel, double channel) {
        return roundedUp(std::max(std::max(cavity, 0.0) + steel, channel + settings.leastSteel), step, grid);
    };
    const std::array<double, 2> height = {reaching(cast.max().z(), settings.ceiling, content.channels[0]),
                                          reaching(-cast.min().z(), settings.floor, content.channels[1])};
    // Walls that narrow keep their thickness at the back.
    std::array<double, 2> more{0, 0};
    for (const std::size_t axis : {0UL, 1UL})
        for (const double way : {-1.0, 1.0}) {
            const Result<std::array<double, 2>> flare =
                outerFlare(way * Vector2d::Unit(static_cast<Eigen::Index>(axis)), settings, rules.directions);
            if (!flare)
                return std::unexpected(flare.error());
            for (const std::size_t side : {0UL, 1UL})
                more[axis] = std::max(more[axis], -(*flare)[side] * height[side]);
        }
    const auto half = [&](int axis, double wall) {
        const double reach = std::max(-cast.min()[axis], cast.max()[axis]);
        return roundedUp(roundedUp(2 * (reach + wall), step, 0) / 2, 0, grid);
    };
    const auto forHand = [&](double reach) {
        return content.byHand.isEmpty() ? 0 : roundedUp(roundedUp(2 * reach, step, 0) / 2, 0, grid);
    };
    const AlignedBox2d& byHand = content.byHand;
    const double x = std::max({half(0, content.wallX + more[0]), forHand(more[0] - byHand.min().x()),
                               forHand(more[0] + byHand.max().x())});
    const double y = half(1, content.wallY + more[1]);
    Vector2d low(-x, -std::max(y, forHand(more[1] - byHand.min().y())));
    Vector2d high(
        x, std::max({y, roundedUp(content.spoutTop, step, grid), forHand(more[1] + byHand.max().y())}));
    for (const int axis : {0, 1}) {
        const std::optional<double> lacks = missingToStock(high[axis] - low[axis], settings.stock);
        if (!lacks)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "No block of the stock is large enough: the longest has {0} mm."),
                           {readable(*std::max_element(settings.stock.begin(), settings.stock.end()))});
        // On both sides in x, so that the origin stays in the middle; away from the spout's mouth in y.
        low[axis] -= roundedUp(axis == 0 ? *lacks / 2 : *lacks, 0, grid);
        high[axis] += axis == 0 ? roundedUp(*lacks / 2, 0, grid) : 0;
    }
    return blockOn(planRectangle(low, high), height, settings, rules);
}

Result<Block> shellOf(const Block& block, const std::vector<KeptInside>& content,
                      const MoldSettings& settings, const BlockRules& rules) {
    constexpr int directions = 32;
    constexpr double shortest = 3; // mm: shorter edges are no walls
    const AlignedBox2d box = block.plan();
    std::vector<KeptInside> kept = content;
    const double quarter = box.sizes().x() / 4;
    kept.push_back(
        {{{box.center().x() - quarter, box.min().y()}, {box.center().x() + quarter, box.min().y()}}, 0});
    Block shell = block;
    // Every fourth direction first: those in between must leave edges long enough.
    for (const int stride : {4, 2, 1})
        for (int i = stride; i < directions; i += stride) {
            if (i % (directions / 4) == 0 || (stride < 4 && i % (2 * stride) == 0))
                continue;
            const double angle = 2 * std::numbers::pi * i / directions;
            const Vector2d m(std::cos(angle), std::sin(angle));
            const Result<std::array<double, 2>> flare = outerFlare(m, settings, rules.directions);
            if (!flare)
                return std::unexpected(flare.error());
            double more = 0;
            for (const std::size_t side : {0UL, 1UL})
                more = std::max(more, -(*flare)[side] * block.body.height[side]);
            double reach = -std::numeric_limits<double>::infinity();
            for (const KeptInside& inside : kept)
                for (const Vector2d& p : inside.shape)
                    reach = std::max(reach, m.dot(p) + inside.steel + more);
            PlanShape smaller = clipped(shell.body.base, m, reach);
            if (shortestEdge(smaller) < shortest)
                continue;
            Result<Block> cut = blockOn(std::move(smaller), block.body.height, settings, rules);
            if (cut && shortestEdge(cut->body.lid[0]) >= shortest / 3 &&
                shortestEdge(cut->body.lid[1]) >= shortest / 3)
                shell = *std::move(cut);
        }
    return shell;
}

} // namespace moldwright
