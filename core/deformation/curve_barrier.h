// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/elastic_body.h"

#include <array>
#include <vector>

namespace moldwright {

/// Keeps the parting curves simple: a barrier between every point of the curves and every segment that does
/// not contain it, in the plane. With s = distance / d̂: b = −d̂·h̄·(1−s)² ln s for s < 1, h̄ the mean segment. A
/// castable shape is embedded exactly when its parting curves are simple and nested, and they are so right
/// after the parting line is inserted; what never crosses stays so. Like an incremental potential contact
/// barrier ([Li 2020]), in two dimensions.
class CurveBarrier {
public:
    /// `edges`: directed segments of the parting line; `X`: where they are now, in the plane's frame. The
    /// reach d̂ of a pair is half the least clearance of its three points there, within [0.02, 0.5]·h̄.
    CurveBarrier(std::vector<std::array<int, 2>> edges, const Positions& X);

    /// Barrier energy at X; adds `factor` times its gradient (x and y only). Infinite when two things touch.
    [[nodiscard]] double energy(const Positions& X, double factor, Positions& gradient) const;

    /// Largest step ≤ `step` from X along D on which every pair keeps at least a fifth of its distance all
    /// the way.
    [[nodiscard]] double largestStep(const Positions& X, const Positions& D, double step) const;

    [[nodiscard]] const std::vector<std::array<int, 2>>& edges() const { return m_edges; }
    [[nodiscard]] bool empty() const { return m_edges.empty(); }

private:
    struct Pair {
        int point;
        int edge;
    };
    [[nodiscard]] std::vector<Pair> pairsWithin(const Positions& X, const Positions* D, double step,
                                                double reach) const;
    [[nodiscard]] double reachOf(const Pair& pair) const;

    std::vector<std::array<int, 2>> m_edges;
    std::vector<int> m_points;       ///< each point of the curves once
    std::vector<double> m_clearance; ///< per vertex of the body; 0 off the curves
    double m_meanEdge = 0;
};

/// Distance of p from segment ab, and where on it (0 at a, 1 at b) the nearest point lies.
struct SegmentDistance {
    double distance = 0;
    double t = 0;
};
[[nodiscard]] SegmentDistance segmentDistance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                              const Eigen::Vector2d& b);

} // namespace moldwright
