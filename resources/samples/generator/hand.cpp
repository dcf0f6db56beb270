// SPDX-License-Identifier: AGPL-3.0-or-later
#include "limb.h"
#include "samples.h"

namespace moldwright::samples {

namespace {

Field palm() {
    const Vector3d back = Vector3d::UnitY();
    const Field wrist =
        limb({{{0, 1, -8}, 13.8, 9.8}, {{0, 1, 6}, 13, 9.2}, {{0, 0.5, 16}, 13.5, 9}, {{0, 0, 24}, 15, 8.5}},
             back);
    const Field metacarpus =
        limb({{{0, 0, 22}, 15.5, 8.4}, {{0, 0, 34}, 17.5, 7.4}, {{0, 0.5, 41}, 17, 6.2}}, back);
    const Field ballOfThumb = ellipsoid({10, -4.5, 22}, {7.5, 6, 12}, {0, 0.35, 0});
    const Field heel = ellipsoid({-9.5, -4, 21}, {6.5, 5.5, 13}, {0, -0.1, 0});
    const Field hollow = ellipsoid({0, -13, 32}, {6.5, 6.5, 11});
    return carve(join({wrist, metacarpus, ballOfThumb, heel}, 7), hollow, 4);
}

/// A finger from the knuckle on: relaxed, its joints a little thicker than what lies between.
Field finger(const std::vector<Vector3d>& joints, double radius) {
    std::vector<Station> stations;
    const double thick[] = {1.08, 1.0, 1.02, 0.94, 0.94, 0.88, 0.72};
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
        stations.push_back({joints[k], radius * thick[2 * k]});
        stations.push_back(
            {(joints[k] + joints[k + 1]) / 2 + Vector3d(0, 0.5, 0), radius * thick[2 * k + 1]});
    }
    stations.push_back({joints.back(), radius * thick[2 * (joints.size() - 1)]});
    return limb(stations);
}

Field fingers() {
    const Field index = finger({{13.4, 0, 38}, {18.6, 0, 60}, {21, -4, 72}, {22.2, -10, 80.5}}, 5.4);
    const Field middle = finger({{4.4, 0.5, 38}, {5.8, 0.5, 65.5}, {6.2, -4.5, 79}, {6.4, -12, 88.5}}, 5.5);
    const Field ring =
        finger({{-4.8, 0.5, 38}, {-7.6, -0.5, 63}, {-8.6, -7.5, 74.5}, {-9, -15.5, 81.5}}, 5.2);
    const Field little =
        finger({{-12.6, 0, 36}, {-20.4, -2, 53}, {-23.4, -7.5, 61.5}, {-24.8, -13.5, 67}}, 4.6);
    const Field thumb = limb({{{10, -3, 16}, 7.5},
                              {{18, -6.5, 26}, 6.8},
                              {{24.5, -9.5, 35.5}, 5.6},
                              {{28.5, -12, 43.5}, 5.5},
                              {{31, -13.5, 50}, 4.9},
                              {{32.5, -14, 55}, 3.8}});
    return join({index, middle, ring, little, thumb}, 4);
}

} // namespace

Sample hand() {
    const Field cut = [](const Vector3d& p) { return p.z() + 1; };
    return {"hand",
            "Hand",
            "Which plane suits the fingers?",
            {carve(join({palm(), fingers()}, 5), cut, 2), {Vector3d(-32, -28, -6), Vector3d(42, 18, 98)}},
            {1.1, 4, 0.09}};
}

} // namespace moldwright::samples
