// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over lanes become vector code.
#include "castability/directions.h"

#include "base/parallel.h"
#include "base/vector_code.h"
#include "castability/share_above.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr int L = FaceArrays::kLanes;
constexpr std::size_t kBlock = 256; ///< batches
constexpr int kSteps = 40;
constexpr int kHalvings = 20;
constexpr double kSettled = 1e-9;    ///< gain of a step over the energy that ends the search
constexpr double kLeastCurve = 1e-3; ///< of the larger curvature: keeps steps in flat valleys short
constexpr double kRealGain = 1e-9;

/// u with |u| ≤ reach that minimises g·(u−at) + ½ (u−at)ᵀH(u−at), H made positive definite.
Eigen::Vector2d leastInDisc(const Eigen::Vector2d& at, const Eigen::Vector2d& g, const Eigen::Matrix2d& H,
                            double reach) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes;
    modes.computeDirect(H);
    const Eigen::Array2d size = modes.eigenvalues().array().abs();
    const Eigen::Array2d curvature = size.max(kLeastCurve * size.maxCoeff()).max(1e-300);
    const Eigen::Matrix2d& Q = modes.eigenvectors();
    // In the frame of the modes u = pull/(curvature + λ), with the λ ≥ 0 that brings it to the rim if it
    // must.
    const Eigen::Array2d pull = curvature * (Q.transpose() * at).array() - (Q.transpose() * g).array();
    const auto place = [&](double lambda) { return Eigen::Array2d(pull / (curvature + lambda)); };
    double low = 0;
    if (place(0).matrix().norm() > reach) {
        double high = pull.matrix().norm() / reach;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (place(middle).matrix().norm() > reach ? low : high) = middle;
        }
        low = high;
    }
    return Q * place(low).matrix();
}

/// The directions of one side within the cap, as d = w/|w|, w = axis + T·u.
class Disc {
public:
    Disc(const SideFaces& faces, const Eigen::Vector3d& axis, double tau)
        : m_faces(faces), m_axis(axis), m_tau(tau) {
        const auto [x, y] = planeAxes(axis);
        m_tangents << x, y;
    }

    struct Value {
        double energy;
        Eigen::Vector2d gradient;
        Eigen::Matrix2d hessian;
    };
    [[nodiscard]] Value at(const Eigen::Vector2d& u) const {
        const Eigen::Vector3d w = m_axis + m_tangents * u;
        const double length = w.norm();
        const Eigen::Vector3d d = w / length;
        const SideFaces::Energy e = m_faces.energy(d, m_tau);
        const Eigen::Matrix<double, 3, 2> J = (m_tangents - d * (d.transpose() * m_tangents)) / length;
        // The second derivative of w/|w|, applied to the gradient.
        const Eigen::Matrix3d outer = e.gradient * d.transpose();
        const Eigen::Matrix3d bend =
            outer + outer.transpose() +
            e.gradient.dot(d) * (Eigen::Matrix3d::Identity() - 3 * d * d.transpose());
        return {e.value, J.transpose() * e.gradient,
                J.transpose() * e.hessian * J -
                    m_tangents.transpose() * bend * m_tangents / (length * length)};
    }
    [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector2d& u) const {
        return (m_axis + m_tangents * u).normalized();
    }

private:
    const SideFaces& m_faces;
    Eigen::Vector3d m_axis;
    double m_tau;
    Eigen::Matrix<double, 3, 2> m_tangents;
};

Eigen::Vector3d bestOfSide(const SideFaces& faces, const DirectionCap& cap, double tau) {
    const double reach = std::tan(radians(cap.radiusDegrees));
    const Disc disc(faces, cap.middle, tau);
    Eigen::Vector2d u = Eigen::Vector2d::Zero();
    Disc::Value now = disc.at(u);
    const double atMiddle = now.energy;
    for (int step = 0; step < kSteps && now.energy > 0 && reach > 0; ++step) {
        const Eigen::Vector2d way = leastInDisc(u, now.gradient, now.hessian, reach) - u;
        const double slope = now.gradient.dot(way);
        double share = 1;
        Disc::Value next = disc.at(u + way);
        for (int i = 0; i < kHalvings && next.energy > now.energy + 1e-4 * share * slope; ++i) {
            share *= 0.5;
            next = disc.at(u + share * way);
        }
        const double gain = now.energy - next.energy;
        if (!(gain > 0))
            break;
        u += share * way;
        now = next;
        if (gain <= kSettled * now.energy)
            break;
    }
    // The middle itself is the natural choice: leave it only for a real gain.
    return now.energy < atMiddle * (1 - kRealGain) ? disc.direction(u) : cap.middle;
}

/// Areas of eight faces on both sides of a plane.
struct alignas(64) LaneAreas {
    double side1[L];
    double side2[L];
};

[[gnu::always_inline]] inline LaneAreas partAreas(const FaceArrays::Batch& batch, double nx, double ny,
                                                  double nz, double offset) {
    const auto& c = batch.corner;
    LaneAreas areas;
    for (int l = 0; l < L; ++l) {
        const double s0 = c[0][l] * nx + c[1][l] * ny + c[2][l] * nz - offset;
        const double s1 = c[3][l] * nx + c[4][l] * ny + c[5][l] * nz - offset;
        const double s2 = c[6][l] * nx + c[7][l] * ny + c[8][l] * nz - offset;
        const double upright = batch.normal[0][l] * nx + batch.normal[1][l] * ny + batch.normal[2][l] * nz;
        areas.side1[l] = batch.area[l] * shareAbove(s0, s1, s2, upright).share;
        areas.side2[l] = batch.area[l] - areas.side1[l];
    }
    return areas;
}

/// Adds the batch to a side unless none of its faces has area there.
void addSide(const FaceArrays::Batch& faces, const double (&areas)[L], std::vector<SideFaces::Batch>& side) {
    if (std::all_of(areas, areas + L, [](double a) { return a == 0; }))
        return;
    SideFaces::Batch& batch = side.emplace_back();
    std::copy_n(faces.normal[0], 3 * L, batch.normal[0]);
    std::copy_n(areas, L, batch.area);
}

/// Energy twofold, gradient, and the hessian's upper triangle, lane by lane.
struct alignas(64) LaneSums {
    double of[10][L];
};

[[gnu::always_inline]] inline void addBatches(const SideFaces::Batch* batches, std::size_t count, double dx,
                                              double dy, double dz, double tau, LaneSums& total) {
    LaneSums sums = total; // a local copy: nothing else can write there
    for (std::size_t b = 0; b < count; ++b)
        for (int l = 0; l < L; ++l) {
            const double x = batches[b].normal[0][l];
            const double y = batches[b].normal[1][l];
            const double z = batches[b].normal[2][l];
            const double miss = x * dx + y * dy + z * dz - tau;
            const double area = miss < 0 ? batches[b].area[l] : 0.0;
            const double push = area * miss;
            sums.of[0][l] += push * miss;
            sums.of[1][l] += push * x;
            sums.of[2][l] += push * y;
            sums.of[3][l] += push * z;
            sums.of[4][l] += area * x * x;
            sums.of[5][l] += area * x * y;
            sums.of[6][l] += area * x * z;
            sums.of[7][l] += area * y * y;
            sums.of[8][l] += area * y * z;
            sums.of[9][l] += area * z * z;
        }
    total = sums;
}

} // namespace

PartedFaces partFaces(const IndexedMesh& mesh, const PartingPlane& plane) {
    const std::size_t count = FaceArrays::batchCount(mesh);
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    PartedFaces parted;
    parted.side1.blocks.resize(blocks);
    parted.side2.blocks.resize(blocks);
    parallelFor(count, kBlock, [&](std::size_t begin, std::size_t end) {
        std::vector<FaceArrays::Batch> faces(end - begin);
        FaceArrays::gather(mesh, begin, faces);
        std::vector<LaneAreas> areas(faces.size());
        const double nx = plane.normal.x(), ny = plane.normal.y(), nz = plane.normal.z();
        const double offset = plane.offset;
        inVectorCode([&] {
            for (std::size_t b = 0; b < faces.size(); ++b)
                areas[b] = partAreas(faces[b], nx, ny, nz, offset);
        });
        for (std::size_t b = 0; b < faces.size(); ++b) {
            addSide(faces[b], areas[b].side1, parted.side1.blocks[begin / kBlock]);
            addSide(faces[b], areas[b].side2, parted.side2.blocks[begin / kBlock]);
        }
    });
    return parted;
}

SideFaces::Energy SideFaces::energy(const Eigen::Vector3d& d, double tau) const {
    const double dx = d.x(), dy = d.y(), dz = d.z();
    LaneSums sums{};
    for (const std::vector<Batch>& block : blocks)
        inVectorCode([&] { addBatches(block.data(), block.size(), dx, dy, dz, tau, sums); });
    double total[10] = {};
    for (int k = 0; k < 10; ++k)
        for (const double lane : sums.of[k])
            total[k] += lane;
    Energy e;
    e.value = 0.5 * total[0];
    e.gradient << total[1], total[2], total[3];
    e.hessian << total[4], total[5], total[6], total[5], total[7], total[8], total[6], total[8], total[9];
    return e;
}

Directions bestDirections(const IndexedMesh& mesh, const PartingPlane& plane, double draftDegrees,
                          const DirectionLimits& limits) {
    const double tau = std::sin(radians(draftDegrees));
    const PartedFaces parted = partFaces(mesh, plane);
    Directions best;
    parallelFor(2, 1, [&](std::size_t i, std::size_t) {
        if (i == 0)
            best.d1 = bestOfSide(parted.side1, *capWithin(limits, plane.normal, 1), tau);
        else
            best.d2 = bestOfSide(parted.side2, *capWithin(limits, plane.normal, 2), tau);
    });
    return best;
}

} // namespace moldwright
