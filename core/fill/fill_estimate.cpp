// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fill/fill_estimate.h"

#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

using Eigen::Vector2d;

constexpr int kCells = 256; ///< along the longer side

/// Heights over the plane seen along a direction, the greatest in each cell of a raster.
class Skyline {
public:
    /// `X`: points sheared so that the direction stands upright on the plane; z: height over it.
    explicit Skyline(const Points& X)
        : m_origin(X.leftCols<2>().colwise().minCoeff().transpose()),
          m_cell((X.leftCols<2>().colwise().maxCoeff() - X.leftCols<2>().colwise().minCoeff()).maxCoeff() /
                 kCells),
          m_heights(static_cast<std::size_t>(kCells * kCells), 0.0) {}

    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        if (std::max({a.z(), b.z(), c.z()}) <= 0)
            return;
        const Vector2d p = onRaster(a);
        const Vector2d u = onRaster(b) - p;
        const Vector2d v = onRaster(c) - p;
        const double area = u.x() * v.y() - u.y() * v.x();
        if (area == 0)
            return;
        const auto [low, high] = cellsBetween(p, p + u, p + v);
        for (int j = low.y(); j <= high.y(); ++j)
            for (int i = low.x(); i <= high.x(); ++i) {
                const Vector2d q = Vector2d(i, j) - p;
                const double s = (q.x() * v.y() - q.y() * v.x()) / area;
                const double t = (u.x() * q.y() - u.y() * q.x()) / area;
                if (s < 0 || t < 0 || s + t > 1)
                    continue;
                double& height = m_heights[static_cast<std::size_t>(j * kCells + i)];
                height = std::max(height, a.z() + s * (b.z() - a.z()) + t * (c.z() - a.z()));
            }
    }

    [[nodiscard]] double volume() const {
        double sum = 0;
        for (const double height : m_heights)
            sum += height;
        return sum * m_cell * m_cell;
    }

private:
    /// In cells; the middle of the first one is the origin.
    [[nodiscard]] Vector2d onRaster(const Eigen::Vector3d& x) const {
        return ((x.head<2>() - m_origin) / m_cell).array() - 0.5;
    }
    [[nodiscard]] static std::pair<Eigen::Vector2i, Eigen::Vector2i>
    cellsBetween(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
        const Vector2d low = a.cwiseMin(b).cwiseMin(c);
        const Vector2d high = a.cwiseMax(b).cwiseMax(c);
        return {low.array().ceil().cast<int>().max(0), high.array().floor().cast<int>().min(kCells - 1)};
    }

    Vector2d m_origin;
    double m_cell;
    std::vector<double> m_heights;
};

/// What lies between the plane and a side's outermost surface along its direction. `X`: points in the plane's
/// frame, the side above.
double envelope(Points X, const Triangles& F, const Eigen::Vector3d& direction) {
    X.leftCols<2>() -= X.col(2) * (direction.head<2>() / direction.z()).transpose();
    Skyline skyline(X);
    const auto point = [&](int v) -> Eigen::Vector3d { return X.row(v).transpose(); };
    for (Eigen::Index f = 0; f < F.rows(); ++f)
        skyline.add(point(F(f, 0)), point(F(f, 1)), point(F(f, 2)));
    return skyline.volume();
}

} // namespace

double estimatedFill(const IndexedMesh& mesh, const MoldState& state) {
    const Eigen::Isometry3d toPlane = planeFrame(state.plane);
    const auto above = [&](const Eigen::Isometry3d& frame, const Eigen::Vector3d& direction) {
        const Points X = (mesh.V * frame.linear().transpose()).rowwise() + frame.translation().transpose();
        return envelope(X, mesh.F, frame.linear() * direction);
    };
    Eigen::Isometry3d turnedOver = toPlane;
    turnedOver.prerotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
    const double solid = volume(mesh);
    const double filled =
        above(toPlane, state.directions.d1) + above(turnedOver, state.directions.d2) - solid;
    return std::max(0.0, filled / solid);
}

} // namespace moldwright
