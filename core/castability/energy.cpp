// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/energy.h"

#include "base/parallel.h"
#include "mesh/measures.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr std::size_t kGrain = 2048;

/// What a block of faces adds to the energy and its derivatives with respect to the state.
struct Sums {
    double energy = 0;
    StateGradient gradient;

    Sums& operator+=(const Sums& o) {
        energy += o.energy;
        gradient.normal += o.gradient.normal;
        gradient.offset += o.gradient.offset;
        gradient.d1 += o.gradient.d1;
        gradient.d2 += o.gradient.d2;
        return *this;
    }
};

double hinge(double NdotD, double tau) {
    return std::min(NdotD - tau, 0.0);
}

using Corners = Eigen::Matrix3d; // a corner a column

/// One face's energy; derivatives with respect to the state are added to `gradient`, to the corners put in
/// `cornerGradient`.
double faceEnergy(const Corners& x, const MoldState& state, double tau, StateGradient& gradient,
                  Corners* cornerGradient) {
    const Eigen::Vector3d areaVector = (x.col(1) - x.col(0)).cross(x.col(2) - x.col(0));
    const double length = areaVector.norm();
    if (!(length > 0))
        return 0;
    const Eigen::Vector3d N = areaVector / length;
    const double A = length / 2;
    const double h1 = hinge(N.dot(state.directions.d1), tau);
    const double h2 = hinge(N.dot(state.directions.d2), tau);
    if (h1 == 0 && h2 == 0)
        return 0;

    const Eigen::Vector3d distances =
        (state.plane.normal.transpose() * x).transpose().array() - state.plane.offset;
    const PartedArea parted = partArea(distances, N.dot(state.plane.normal) > 0 ? 1 : 2);
    const double A1 = A * parted.share1;
    const double A2 = A - A1;
    const double energy = 0.5 * (h1 * h1 * A1 + h2 * h2 * A2);

    const double dShare = 0.5 * (h1 * h1 - h2 * h2) * A; // ∂E/∂share1
    gradient.normal += dShare * (x * parted.derivative);
    gradient.offset -= dShare * parted.derivative.sum();
    gradient.d1 += h1 * A1 * N;
    gradient.d2 += h2 * A2 * N;
    if (cornerGradient) {
        const double dA = energy / A;
        const Eigen::Vector3d dN = h1 * A1 * state.directions.d1 + h2 * A2 * state.directions.d2;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d opposite = x.col((k + 2) % 3) - x.col((k + 1) % 3);
            // Eq. (7): ∇A = ½ N×(w−v); Eq. (8), corrected: ∇N = 1/(2A) ((w−v)×N) Nᵀ, applied to dN.
            cornerGradient->col(k) = 0.5 * dA * N.cross(opposite) + dN.dot(opposite.cross(N)) / (2 * A) * N +
                                     dShare * parted.derivative[k] * state.plane.normal;
        }
    }
    return energy;
}

Sums sumOverFaces(const IndexedMesh& mesh, const MoldState& state, double tau,
                  std::vector<Corners>* corners) {
    const auto faces = static_cast<std::size_t>(mesh.faceCount());
    return parallelSum<Sums>(faces, kGrain, Sums{}, [&](std::size_t begin, std::size_t end) {
        Sums part;
        for (std::size_t f = begin; f < end; ++f) {
            Corners x;
            for (int k = 0; k < 3; ++k)
                x.col(k) = mesh.corner(static_cast<int>(f), k);
            part.energy += faceEnergy(x, state, tau, part.gradient, corners ? &(*corners)[f] : nullptr);
        }
        return part;
    });
}

} // namespace

PartedArea partArea(const Eigen::Vector3d& s, int flatSide) {
    const bool anyAbove = (s.array() > 0).any();
    const bool anyBelow = (s.array() < 0).any();
    if (!anyAbove || !anyBelow) {
        const bool side1 = anyAbove || (!anyBelow && flatSide == 1);
        return {side1 ? 1.0 : 0.0, Eigen::Vector3d::Zero()};
    }
    // The corner u that is alone on its side cuts off a small triangle with share t =
    // s_u²/((s_u−s_v)(s_u−s_w)).
    int u = 0;
    for (int k = 0; k < 3; ++k) {
        const double a = s[(k + 1) % 3];
        const double b = s[(k + 2) % 3];
        if ((s[k] > 0 && a <= 0 && b <= 0) || (s[k] < 0 && a >= 0 && b >= 0))
            u = k;
    }
    const int v = (u + 1) % 3;
    const int w = (u + 2) % 3;
    const double uv = s[u] - s[v];
    const double uw = s[u] - s[w];
    const double t = s[u] * s[u] / (uv * uw);
    PartedArea result{t, {}};
    result.derivative[u] = 2 * s[u] / (uv * uw) - t / uv - t / uw;
    result.derivative[v] = t / uv;
    result.derivative[w] = t / uw;
    if (s[u] < 0) {
        result.share1 = 1 - t;
        result.derivative = -result.derivative;
    }
    return result;
}

double castabilityEnergy(const IndexedMesh& mesh, const MoldState& state, double tau) {
    StateGradient unused;
    return castabilityEnergy(mesh, state, tau, unused);
}

double castabilityEnergy(const IndexedMesh& mesh, const MoldState& state, double tau,
                         StateGradient& gradient) {
    const Sums sums = sumOverFaces(mesh, state, tau, nullptr);
    gradient = sums.gradient;
    return sums.energy;
}

double castabilityEnergy(const IndexedMesh& mesh, const MoldState& state, double tau, Points& gradient) {
    std::vector<Corners> cornerGradients(static_cast<std::size_t>(mesh.faceCount()), Corners::Zero());
    const Sums sums = sumOverFaces(mesh, state, tau, &cornerGradients);
    gradient = Points::Zero(mesh.V.rows(), 3);
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            gradient.row(mesh.F(f, k)) += cornerGradients[static_cast<std::size_t>(f)].col(k).transpose();
    return sums.energy;
}

} // namespace moldwright
