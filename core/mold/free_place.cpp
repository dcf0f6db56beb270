// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/free_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace moldwright {

using Eigen::Vector2d;

namespace {

/// Tells of many circles of one size whether they keep clear, as keepsClear() does of the polygons in them.
class CirclesClear {
public:
    CirclesClear(const Obstacles& obstacles, double radius, double steel)
        : m_obstacles(obstacles), m_radius(radius), m_steel(steel) {
        for (const PlanShape& obstacle : obstacles) {
            m_boxes.emplace_back();
            for (const Vector2d& p : obstacle)
                m_boxes.back().extend(p);
            m_discs.push_back(discIn(obstacle, m_boxes.back().center()));
        }
    }

    [[nodiscard]] bool clear(const Vector2d& middle) const {
        for (std::size_t i = 0; i < m_obstacles.size(); ++i)
            if (m_boxes[i].exteriorDistance(middle) < m_radius + m_steel &&
                (meetsDisc(m_discs[i], middle) || !clearOf(m_obstacles[i], middle)))
                return false;
        return true;
    }

private:
    /// A circle wholly within an obstacle: no other look is needed at what is near to it.
    struct Disc {
        Vector2d middle;
        double radius = 0; ///< mm; below 0: none
    };
    static Disc discIn(const PlanShape& obstacle, const Vector2d& middle) {
        Disc disc{middle, -1};
        if (!insidePlan(obstacle, middle))
            return disc;
        disc.radius = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < obstacle.size(); ++k)
            disc.radius = std::min(
                disc.radius, planDistanceTo({obstacle[k], obstacle[(k + 1) % obstacle.size()]}, middle));
        return disc;
    }
    [[nodiscard]] bool meetsDisc(const Disc& disc, const Vector2d& middle) const {
        constexpr double rounding = 1e-9; // mm
        const double surely = m_steel + m_radius * std::cos(std::numbers::pi / circleCorners) - rounding;
        return disc.radius >= 0 && (middle - disc.middle).norm() - disc.radius < surely;
    }
    [[nodiscard]] bool clearOf(const PlanShape& obstacle, const Vector2d& middle) const {
        const double away = planDistanceTo(obstacle, middle) - m_steel;
        if (away >= m_radius)
            return true;
        // The polygon lies between its circle and the one that touches its sides.
        return away >= m_radius * std::cos(std::numbers::pi / circleCorners) &&
               planDistance(planCircle(middle, m_radius, circleCorners), obstacle) >= m_steel;
    }

    const Obstacles& m_obstacles;
    double m_radius;
    double m_steel;
    std::vector<Eigen::AlignedBox2d> m_boxes;
    std::vector<Disc> m_discs;
};

/// A place that may be free.
struct Candidate {
    double after = 0; ///< the less, the better
    std::size_t number = 0;
    Vector2d place;

    [[nodiscard]] bool isBefore(const Candidate& other) const {
        return after != other.after ? after < other.after : number < other.number;
    }
};

} // namespace

bool keepsClear(const PlanShape& shape, const Obstacles& obstacles, double steel) {
    return std::all_of(obstacles.begin(), obstacles.end(),
                       [&](const PlanShape& obstacle) { return planKeepsClear(shape, obstacle, steel); });
}

std::optional<Vector2d> nearestFree(const Vector2d& wish, double radius, const Block& block,
                                    const Obstacles& obstacles, const Clearances& steel, Pull pull) {
    constexpr double searchStep = 1; // mm
    const double edge = radius + steel.outside;
    const Eigen::AlignedBox2d box = block.plan();
    const Vector2d low = box.min().array() + edge;
    const Vector2d high = box.max().array() - edge;
    const Vector2d start = wish.cwiseMax(low).cwiseMin(high);
    const Vector2d middle = box.center();
    const double reach = (start - middle).norm() / 2;
    std::vector<Candidate> candidates;
    const auto add = [&](const Vector2d& place) {
        const double after = pull == Pull::Inwards // least far out along the way to the wish
                                 ? (place - middle).dot(start - middle)
                                 : (place - start).squaredNorm();
        candidates.push_back({after, candidates.size(), place});
    };
    for (double x = low.x(); x <= high.x(); x += searchStep)
        for (double y = low.y(); y <= high.y() && std::abs(x - start.x()) < reach; y += searchStep)
            if ((Vector2d(x, y) - start).norm() < reach)
                add({x, y});
    add(start);
    // A heap: as a rule one of the first is free.
    const auto later = [](const Candidate& a, const Candidate& b) { return b.isBefore(a); };
    std::make_heap(candidates.begin(), candidates.end(), later);
    const CirclesClear circles(obstacles, radius, steel.inside);
    for (auto end = candidates.end(); end != candidates.begin(); --end) {
        const Vector2d place = candidates.front().place;
        if (block.depthOf(place) >= edge - 1e-9 && circles.clear(place))
            return place;
        std::pop_heap(candidates.begin(), end, later);
    }
    return std::nullopt;
}

Wishes wishesFor(const PlacedFeatures& placed, Placeable kind, int count) {
    Wishes wishes;
    for (int number = 0; number < count; ++number)
        wishes.push_back(placeByHand(placed, kind, number));
    return wishes;
}

std::vector<Vector2d> placesRound(const Block& block, int count) {
    const Eigen::AlignedBox2d box = block.plan();
    const Vector2d low = box.min();
    const Vector2d high = box.max();
    const Vector2d middle = box.center();
    std::vector<Vector2d> places{low,
                                 high,
                                 {high.x(), low.y()},
                                 {low.x(), high.y()},
                                 {middle.x(), low.y()},
                                 {low.x(), middle.y()},
                                 {high.x(), middle.y()},
                                 {middle.x(), high.y()}};
    const Vector2d quarter = (high - low) / 4;
    for (const double along : {1.0, 3.0})
        for (const double across : {0.0, 4.0}) {
            places.emplace_back(low + Vector2d(along * quarter.x(), across * quarter.y()));
            places.emplace_back(high - Vector2d(across * quarter.x(), along * quarter.y()));
        }
    places.resize(static_cast<std::size_t>(std::min(count, static_cast<int>(places.size()))));
    return places;
}

} // namespace moldwright
