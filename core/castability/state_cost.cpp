// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over lanes become vector code.
#include "castability/state_cost.h"

#include "base/parallel.h"
#include "base/vector_code.h"
#include "castability/share_above.h"

#include <algorithm>
#include <array>

namespace moldwright {

namespace {

constexpr int L = FaceArrays::kLanes;
constexpr std::size_t kBlock = 256; ///< batches that stay in a core's cache
constexpr std::size_t kStates = 16; ///< states that share a block while it is there

using Batch = FaceArrays::Batch;

/// What a block of faces adds, lane by lane.
struct alignas(64) LaneSums {
    double energy[L] = {};
    double volume[L] = {};
    double violatingArea[L] = {};
    double worstSine[L] = {1, 1, 1, 1, 1, 1, 1, 1};
    double d1[3][L] = {};
    double d2[3][L] = {};
};

/// What remains of a block once its lanes are added.
struct Sums {
    StateCost cost;
    StateGradient energy;
    double sectionArea = 0;
    Eigen::Vector3d sectionMoment = Eigen::Vector3d::Zero();

    Sums& operator+=(const Sums& o) {
        cost.energy += o.cost.energy;
        cost.volumeAbove += o.cost.volumeAbove;
        cost.violatingArea += o.cost.violatingArea;
        cost.worstSine = std::min(cost.worstSine, o.cost.worstSine);
        energy.normal += o.energy.normal;
        energy.offset += o.energy.offset;
        energy.d1 += o.energy.d1;
        energy.d2 += o.energy.d2;
        sectionArea += o.sectionArea;
        sectionMoment += o.sectionMoment;
        return *this;
    }
};

/// Plain numbers of a state: what the vector loop broadcasts.
struct StateNumbers {
    double n[3], offset, d1[3], d2[3], tau;

    StateNumbers(const MoldState& state, double t) : offset(state.plane.offset), tau(t) {
        for (int i = 0; i < 3; ++i) {
            n[i] = state.plane.normal[i];
            d1[i] = state.directions.d1[i];
            d2[i] = state.directions.d2[i];
        }
    }
};

/// Adds batches to the sums; marks in `crossing` the batches with faces across the plane. All lanes take the
/// same way: what does not apply is computed and not selected.
template <bool kWithGradient>
[[gnu::always_inline]] inline void addBatches(const Batch* batches, std::size_t count, const StateNumbers s,
                                              LaneSums& total, double* crossing) {
    LaneSums sums = total; // a local copy: nothing else can write there
    for (std::size_t b = 0; b < count; ++b) {
        const Batch& batch = batches[b];
        const auto& c = batch.corner;
        double crossed[L];
        for (int l = 0; l < L; ++l) {
            const double x = batch.normal[0][l], y = batch.normal[1][l], z = batch.normal[2][l];
            const double upright = x * s.n[0] + y * s.n[1] + z * s.n[2];
            const double sine1 = x * s.d1[0] + y * s.d1[1] + z * s.d1[2];
            const double sine2 = x * s.d2[0] + y * s.d2[1] + z * s.d2[2];
            const double s0 = c[0][l] * s.n[0] + c[1][l] * s.n[1] + c[2][l] * s.n[2] - s.offset;
            const double s1 = c[3][l] * s.n[0] + c[4][l] * s.n[1] + c[5][l] * s.n[2] - s.offset;
            const double s2 = c[6][l] * s.n[0] + c[7][l] * s.n[1] + c[8][l] * s.n[2] - s.offset;
            const LaneShare parted = shareAbove(s0, s1, s2, upright);

            const double area = batch.area[l];
            const double area1 = area * parted.share;
            const double area2 = area - area1;
            const double miss1 = sine1 - s.tau, miss2 = sine2 - s.tau;
            const double h1 = miss1 < 0 ? miss1 : 0.0;
            const double h2 = miss2 < 0 ? miss2 : 0.0;
            sums.energy[l] += 0.5 * (h1 * h1 * area1 + h2 * h2 * area2);
            sums.violatingArea[l] += (h1 < 0 ? area1 : 0.0) + (h2 < 0 ? area2 : 0.0);
            const double worst1 = area1 > 0 ? sine1 : 1.0;
            const double worst2 = area2 > 0 ? sine2 : 1.0;
            const double worst = worst1 < worst2 ? worst1 : worst2;
            sums.worstSine[l] = worst < sums.worstSine[l] ? worst : sums.worstSine[l];

            // ∫ max(s, 0) N·n dA: the divergence theorem on the part above; the section adds nothing.
            const double whole = parted.above ? s0 + s1 + s2 : 0.0; // threefold mean height
            const double corner = parted.t * parted.lone;
            const double pieces = parted.oneAbove ? corner : whole - corner;
            sums.volume[l] += upright * area * (parted.crosses ? pieces : whole);
            if constexpr (kWithGradient) {
                const double g1 = h1 * area1;
                const double g2 = h2 * area2;
                sums.d1[0][l] += g1 * x;
                sums.d1[1][l] += g1 * y;
                sums.d1[2][l] += g1 * z;
                sums.d2[0][l] += g2 * x;
                sums.d2[1][l] += g2 * y;
                sums.d2[2][l] += g2 * z;
                crossed[l] = parted.crosses ? 1.0 : 0.0;
            }
        }
        if constexpr (kWithGradient) {
            double any = 0;
            for (const double lane : crossed)
                any += lane;
            crossing[b] = any;
        }
    }
    total = sums;
}

double sumOf(const double (&lanes)[L]) {
    double sum = 0;
    for (const double x : lanes)
        sum += x;
    return sum;
}

Sums sumsOf(const LaneSums& lanes) {
    Sums sums;
    sums.cost = {sumOf(lanes.energy), sumOf(lanes.volume) / 3, sumOf(lanes.violatingArea),
                 *std::min_element(lanes.worstSine, lanes.worstSine + L)};
    for (int i = 0; i < 3; ++i) {
        sums.energy.d1[i] = sumOf(lanes.d1[i]);
        sums.energy.d2[i] = sumOf(lanes.d2[i]);
    }
    return sums;
}

/// Adds what a face across the plane contributes to the derivatives with respect to the plane: by its share
/// of the area on side 1, and by its segment of the section's boundary.
void addCrossingFace(const Batch& batch, int lane, const MoldState& state, double tau, Sums& sums) {
    Eigen::Matrix3d x; // a corner a column
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
            x(i, k) = batch.corner[3 * k + i][lane];
    const Eigen::Vector3d& n = state.plane.normal;
    const Eigen::Vector3d s = (n.transpose() * x).transpose().array() - state.plane.offset;
    if (!(s.maxCoeff() > 0) || !(s.minCoeff() < 0))
        return;
    const Eigen::Vector3d N(batch.normal[0][lane], batch.normal[1][lane], batch.normal[2][lane]);
    const double h1 = std::min(N.dot(state.directions.d1) - tau, 0.0);
    const double h2 = std::min(N.dot(state.directions.d2) - tau, 0.0);
    const double dShare = 0.5 * (h1 * h1 - h2 * h2) * batch.area[lane];
    const Eigen::Vector3d derivative = partArea(s, 1).derivative;
    sums.energy.normal += dShare * (x * derivative);
    sums.energy.offset -= dShare * derivative.sum();

    const bool oneAbove = (s.array() > 0).count() == 1;
    Eigen::Index u = 0;
    oneAbove ? s.maxCoeff(&u) : s.minCoeff(&u);
    const Eigen::Index v = (u + 1) % 3;
    const Eigen::Index w = (u + 2) % 3;
    const Eigen::Vector3d p = x.col(u) + s[u] / (s[u] - s[v]) * (x.col(v) - x.col(u));
    const Eigen::Vector3d q = x.col(u) + s[u] / (s[u] - s[w]) * (x.col(w) - x.col(u));
    const double piece = (oneAbove ? 0.5 : -0.5) * n.dot(p.cross(q));
    sums.sectionArea += piece;
    sums.sectionMoment += piece * (p + q) / 3;
}

std::size_t blockCount(const FaceArrays& faces) {
    return (faces.batches().size() + kBlock - 1) / kBlock;
}

std::span<const Batch> blockAt(const FaceArrays& faces, std::size_t block) {
    const std::size_t begin = block * kBlock;
    return {faces.batches().data() + begin, std::min(kBlock, faces.batches().size() - begin)};
}

Sums blockSums(std::span<const Batch> batches, const MoldState& state, double tau) {
    const StateNumbers numbers(state, tau);
    LaneSums lanes;
    inVectorCode([&] { addBatches<false>(batches.data(), batches.size(), numbers, lanes, nullptr); });
    return sumsOf(lanes);
}

Sums blockSumsWithGradient(std::span<const Batch> batches, const MoldState& state, double tau) {
    const StateNumbers numbers(state, tau);
    LaneSums lanes;
    std::array<double, kBlock> crossing;
    inVectorCode([&] { addBatches<true>(batches.data(), batches.size(), numbers, lanes, crossing.data()); });
    Sums sums = sumsOf(lanes);
    for (std::size_t b = 0; b < batches.size(); ++b)
        for (int l = 0; crossing[b] > 0 && l < L; ++l)
            addCrossingFace(batches[b], l, state, tau, sums);
    return sums;
}

/// Derivatives of the volume above, from the section: its segments run about it one way or the other, its
/// area is positive.
VolumeGradient volumeGradient(const Sums& sums, const PartingPlane& plane) {
    const double sign = sums.sectionArea < 0 ? -1 : 1;
    // The moment of triangles from the origin's foot lacks their third corner, the foot point n·o.
    return {sign * (sums.sectionMoment + sums.sectionArea * plane.offset / 3 * plane.normal),
            -sign * sums.sectionArea};
}

} // namespace

StateCost stateCost(const FaceArrays& faces, const MoldState& state, double tau) {
    return parallelSum<Sums>(
               blockCount(faces), 1, Sums{},
               [&](std::size_t block, std::size_t) { return blockSums(blockAt(faces, block), state, tau); })
        .cost;
}

StateCost stateCost(const FaceArrays& faces, const MoldState& state, double tau, StateGradient& energy,
                    VolumeGradient& volume) {
    const Sums sums = parallelSum<Sums>(blockCount(faces), 1, Sums{}, [&](std::size_t block, std::size_t) {
        return blockSumsWithGradient(blockAt(faces, block), state, tau);
    });
    energy = sums.energy;
    volume = volumeGradient(sums, state.plane);
    return sums.cost;
}

std::vector<StateCost> stateCosts(const FaceArrays& faces, std::span<const MoldState> states, double tau) {
    std::vector<StateCost> costs(states.size());
    parallelFor(states.size(), kStates, [&](std::size_t begin, std::size_t end) {
        std::vector<Sums> sums(end - begin);
        for (std::size_t block = 0; block < blockCount(faces); ++block)
            for (std::size_t i = begin; i < end; ++i)
                sums[i - begin] += blockSums(blockAt(faces, block), states[i], tau);
        for (std::size_t i = begin; i < end; ++i)
            costs[i] = sums[i - begin].cost;
    });
    return costs;
}

} // namespace moldwright
