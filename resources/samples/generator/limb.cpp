// SPDX-License-Identifier: AGPL-3.0-or-later
#include "limb.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

namespace moldwright::samples {

namespace {

/// Position (3), width and thickness in one vector, so that all are interpolated alike.
using Section = Eigen::Matrix<double, 5, 1>;

constexpr int samplesPerSpan = 8;
constexpr double farAway = 8; ///< mm beyond which a bound is as good as the distance

class Limb {
public:
    Limb(const std::vector<Station>& stations, const Vector3d& flat) : m_flat(flat.normalized()) {
        std::vector<Section> knots;
        knots.reserve(stations.size() + 2);
        for (const Station& s : stations)
            knots.push_back((Section() << s.at, s.width, s.thickness).finished());
        // Continued past the ends by reflection.
        knots.insert(knots.begin(), 2 * knots[0] - knots[1]);
        knots.push_back(2 * knots.back() - knots[knots.size() - 2]);
        for (std::size_t k = 1; k + 2 < knots.size(); ++k)
            m_spans.push_back(catmullRom(knots[k - 1], knots[k], knots[k + 1], knots[k + 2]));
        const int samples = spans() * samplesPerSpan;
        for (int k = 0; k <= samples; ++k)
            m_samples.push_back(section(double(k) / samplesPerSpan).head<3>());
        m_centre = Vector3d::Zero();
        for (const Vector3d& s : m_samples)
            m_centre += s / double(m_samples.size());
        for (int k = 0; k <= samples; ++k) {
            const Section s = section(double(k) / samplesPerSpan);
            m_reach = std::max(m_reach, (s.head<3>() - m_centre).norm() + std::max(s[3], s[4]));
        }
    }

    [[nodiscard]] double distance(const Vector3d& p) const {
        const double bound = (p - m_centre).norm() - m_reach;
        if (bound > farAway)
            return bound;
        const double t = nearest(p);
        const Section s = section(t);
        const Section rate = derivative(t);
        const double speed = rate.head<3>().norm();
        const Vector3d along = rate.head<3>() / speed;
        const Vector3d side = along.cross(m_flat).normalized();
        const Vector3d d = p - s.head<3>();
        // Past an end the limb goes on tapering, so that the round cap meets it without a knob.
        const double beyond = d.dot(along);
        const double taper = std::clamp(1 + rate[3] / speed * beyond / s[3], 0.4, 1.0);
        return ellipticDistance({beyond, d.dot(side), d.dot(side.cross(along))},
                                {s[3], taper * s[3], taper * s[4]});
    }

private:
    /// Columns: the coefficients of 1, u, u², u³ on one span, 0 ≤ u ≤ 1.
    using Span = Eigen::Matrix<double, 5, 4>;

    static Span catmullRom(const Section& a, const Section& b, const Section& c, const Section& d) {
        Span span;
        span << b, (c - a) / 2, a - 2.5 * b + 2 * c - d / 2, (3 * (b - c) + d - a) / 2;
        return span;
    }

    [[nodiscard]] int spans() const { return static_cast<int>(m_spans.size()); }
    [[nodiscard]] int spanAt(double t) const { return std::min(static_cast<int>(t), spans() - 1); }

    [[nodiscard]] Section section(double t) const {
        const Span& s = m_spans[spanAt(t)];
        const double u = t - spanAt(t);
        Section result = s.col(0) + u * (s.col(1) + u * (s.col(2) + u * s.col(3)));
        result.tail<2>() = result.tail<2>().cwiseMax(0.3);
        return result;
    }

    [[nodiscard]] Section derivative(double t) const {
        const Span& s = m_spans[spanAt(t)];
        const double u = t - spanAt(t);
        return s.col(1) + u * (2 * s.col(2) + 3 * u * s.col(3));
    }

    /// Parameter of the point of the spline nearest to p: the best sample, then halving, which cannot
    /// leave the bracket.
    [[nodiscard]] double nearest(const Vector3d& p) const {
        int best = 0;
        for (int k = 1; k < static_cast<int>(m_samples.size()); ++k)
            if ((p - m_samples[k]).squaredNorm() < (p - m_samples[best]).squaredNorm())
                best = k;
        const double step = 1.0 / samplesPerSpan;
        double lo = std::max(best * step - step, 0.0);
        double hi = std::min(best * step + step, double(spans()));
        // The slope of the squared distance changes sign once in the bracket.
        for (int k = 0; k < 20; ++k) {
            const double mid = (lo + hi) / 2;
            const bool passed = (section(mid).head<3>() - p).dot(derivative(mid).head<3>()) > 0;
            (passed ? hi : lo) = mid;
        }
        return (lo + hi) / 2;
    }

    std::vector<Span> m_spans;
    std::vector<Vector3d> m_samples;
    Vector3d m_flat;
    Vector3d m_centre;
    double m_reach = 0;
};

} // namespace

Field limb(const std::vector<Station>& stations, const Vector3d& flat) {
    return [limb = std::make_shared<const Limb>(stations, flat)](const Vector3d& p) {
        return limb->distance(p);
    };
}

} // namespace moldwright::samples
