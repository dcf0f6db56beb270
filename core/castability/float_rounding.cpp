// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/float_rounding.h"

#include "base/stop_point.h"
#include "castability/certificate.h"
#include "castability/exact_predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace moldwright {

namespace {

using Eigen::Vector3d;

/// The two floats, or multiples of the grid, round `value`: the nearest first. Twice the same when it is one.
std::array<double, 2> neighbours(double value, double grid) {
    if (grid > 0) {
        const double nearest = std::round(value / grid) * grid;
        const double other = value == nearest ? nearest : nearest + (value > nearest ? grid : -grid);
        return {nearest, other};
    }
    const auto nearest = static_cast<float>(value);
    const auto rounded = static_cast<double>(nearest);
    if (rounded == value)
        return {value, value};
    return {rounded, std::nextafter(nearest, value > rounded ? INFINITY : -INFINITY)};
}

class Rounding {
public:
    Rounding(const IndexedMesh& exact, const SideLabels& labels, const Directions& directions, double tau,
             double grid)
        : m_exact(exact), m_labels(labels), m_directions(directions), m_tau(tau), m_grid(grid),
          m_rounded(exact), m_facesOf(static_cast<std::size_t>(exact.vertexCount())) {
        m_rounded.V = exact.V.unaryExpr([grid](double x) { return neighbours(x, grid)[0]; });
        for (int f = 0; f < exact.faceCount(); ++f)
            for (int k = 0; k < 3; ++k)
                m_facesOf[static_cast<std::size_t>(exact.F(f, k))].push_back(f);
    }

    [[nodiscard]] bool passes(int f) const {
        const int side = m_labels[static_cast<std::size_t>(f)];
        return side == 0 || leavesAlong(m_rounded.corner(f, 0), m_rounded.corner(f, 1),
                                        m_rounded.corner(f, 2), m_directions.of(side), m_tau);
    }

    /// Moves one corner of f to another float next to it so that f and all faces round it pass.
    void mend(int f) {
        for (int k = 0; k < 3; ++k)
            if (mendPoint(m_exact.F(f, k)))
                return;
    }

    [[nodiscard]] const IndexedMesh& result() const { return m_rounded; }

private:
    bool mendPoint(int v) {
        const Vector3d before = m_rounded.point(v);
        for (unsigned choice = 1; choice < 8; ++choice) {
            for (int axis = 0; axis < 3; ++axis)
                m_rounded.V(v, axis) = neighbours(m_exact.V(v, axis), m_grid)[(choice >> axis) & 1U];
            const auto& faces = m_facesOf[static_cast<std::size_t>(v)];
            if (std::all_of(faces.begin(), faces.end(), [&](int f) { return passes(f); }))
                return true;
        }
        m_rounded.V.row(v) = before.transpose();
        return false;
    }

    const IndexedMesh& m_exact;
    const SideLabels& m_labels;
    const Directions& m_directions;
    double m_tau;
    double m_grid;
    IndexedMesh m_rounded;
    std::vector<std::vector<int>> m_facesOf;
};

} // namespace

IndexedMesh roundKeepingDraft(const IndexedMesh& mesh, const SideLabels& labels, const Directions& directions,
                              double draftDegrees, double grid) {
    Rounding rounding(mesh, labels, directions, provableTolerance(draftDegrees), grid);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        stopPointAt(f);
        if (!rounding.passes(f))
            rounding.mend(f);
    }
    return rounding.result();
}

} // namespace moldwright
