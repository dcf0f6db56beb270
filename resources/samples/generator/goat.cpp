// SPDX-License-Identifier: AGPL-3.0-or-later
#include "limb.h"
#include "samples.h"

namespace moldwright::samples {

namespace {

Field trunk() {
    const Field barrel = limb({{{0, 23, 44}, 10.5, 10},
                               {{0, 11, 43}, 11.2, 10.4},
                               {{0, -3, 41.3}, 12.8, 11.4},
                               {{0, -15, 45}, 11, 9.8}});
    const Field neck = limb({{{0, -15, 48}, 10, 8.5}, {{0, -22, 59}, 7.6, 6.4}, {{0, -25.5, 69}, 6, 5.4}});
    const Field tail = limb({{{0, 31, 50}, 3}, {{0, 36, 53}, 2.6}, {{0, 39, 58}, 2}});
    return join({barrel, neck, tail}, 4);
}

/// A leg from hip or shoulder to fetlock, and its hoof under the last place.
Field leg(const std::vector<Station>& stations) {
    const Vector3d ankle = stations.back().at;
    const Field hoof = limb({{{ankle.x(), ankle.y() - 0.4, 5.5}, 3}, {{ankle.x(), ankle.y() - 1.8, 1}, 3.9}});
    return join({limb(stations), hoof}, 0.8);
}

/// A stride apart, so that no leg hides another from the side.
Field legs() {
    const Field foreLeft =
        leg({{{5.5, -13, 41}, 7.5}, {{6.2, -17, 30}, 5}, {{6, -20.5, 20}, 3.5}, {{6, -22, 9}, 2.7}});
    const Field foreRight =
        leg({{{-5.5, -12, 41}, 7.5}, {{-6.2, -10, 30}, 5}, {{-6, -7.5, 20}, 3.5}, {{-6, -3, 9.5}, 2.7}});
    const Field hindLeft = leg({{{5, 20, 43}, 9},
                                {{6.4, 15, 32}, 6.4},
                                {{6.2, 20.5, 21}, 3.6},
                                {{6, 19, 14}, 2.9},
                                {{6, 16.5, 8.5}, 2.7}});
    const Field hindRight = leg({{{-5, 21, 43}, 9},
                                 {{-6.4, 21, 32}, 6.4},
                                 {{-6.2, 30.5, 22}, 3.6},
                                 {{-6, 31, 14}, 2.9},
                                 {{-6, 30, 8.5}, 2.7}});
    return join({foreLeft, foreRight, hindLeft, hindRight}, 1);
}

/// Looks along −y; turned and set upon the neck by the caller.
Field head() {
    const Field skull = ellipsoid({0, -27, 71}, {6.4, 8, 7}, {0.3, 0, 0});
    const Field snout =
        limb({{{0, -31, 69.5}, 5.6, 5}, {{0, -38, 65.5}, 4.5, 4.1}, {{0, -42.5, 63}, 3.9, 3.8}});
    const Field jaw = limb({{{0, -27, 66}, 4.4}, {{0, -36, 62.5}, 3.2}, {{0, -40.5, 61}, 2.8}});
    const Field beard = limb({{{0, -37, 61}, 2.6}, {{0, -37, 55}, 2.4}, {{0, -35, 49.5}, 1.5}});
    const Field brow = ellipsoid({4, -31, 73.6}, {2.6, 3.2, 2});
    const Field soft = join({join({skull, snout, jaw, brow, mirrored(brow)}, 3), beard}, 1.5);
    const Field eye = ellipsoid({5.2, -32, 71.2}, {1.8, 2.2, 2});
    const Field ear = limb({{{5, -24, 72}, 2.2, 1.9},
                            {{10, -23, 72.5}, 3.2, 1.8},
                            {{15, -23.5, 71}, 3, 1.6},
                            {{18.5, -24.5, 69}, 1.6, 1.4}},
                           Vector3d(0, -0.9, 0.35).normalized());
    const Field horn = limb({{{2.9, -26, 76}, 3},
                             {{4.2, -22.5, 84}, 2.8},
                             {{6.5, -15.5, 91}, 2.5},
                             {{9.5, -6, 92.5}, 2.1},
                             {{12.5, 1.5, 89}, 1.5}});
    return join({join({soft, ear, mirrored(ear), horn, mirrored(horn)}, 1.4), eye, mirrored(eye)}, 0.4);
}

} // namespace

Sample goat() {
    const Field looking = turned(head(), {0, 0, 0.6}, {0, -25.5, 68});
    const Field ground = [](const Vector3d& p) { return p.z() - 0.5; };
    const Field whole = join({join({trunk(), legs()}, 4), looking}, 3);
    return {"goat",
            "Standing goat",
            "Four legs, two horns, one plane",
            {carve(whole, ground, 1), {Vector3d(-36, -54, -4), Vector3d(30, 46, 102)}},
            {0.95, 3.6, 0.1}};
}

} // namespace moldwright::samples
