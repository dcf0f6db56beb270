// SPDX-License-Identifier: AGPL-3.0-or-later
#include "limb.h"
#include "samples.h"

namespace moldwright::samples {

namespace {

Field skull() {
    const Field neck =
        limb({{{0, 4, -8}, 19, 16}, {{0, 5, 8}, 16.5, 14}, {{0, 4, 26}, 14, 12.5}, {{0, 0, 42}, 11.5, 11}});
    const Field cranium = ellipsoid({0, -5, 48}, {12, 15, 12.5}, {0.35, 0, 0});
    const Field snout = limb({{{0, -13, 46}, 10, 9}, {{0, -25, 38.5}, 7.6, 7}, {{0, -36, 31}, 6.4, 6.2}});
    const Field jaw = limb({{{0, -6, 36}, 8}, {{0, -22, 29.5}, 5.4}, {{0, -33, 25.5}, 4.6}});
    const Field lip = ellipsoid({0, -37.5, 29}, {5.6, 5, 5});
    const Field cheek = ellipsoid({6.5, -13, 40}, {5, 8, 6}, {0.5, 0, 0});
    return join({neck, cranium, snout, jaw, lip, cheek, mirrored(cheek)}, 6);
}

/// The ball of the eye, and the upper lid as a shell about it.
Field eye() {
    const Vector3d at(9.4, -17.2, 47.4);
    const Field globe = ball(at, 3.7);
    const Field above = [at](const Vector3d& p) { return at.z() + 1.3 - p.z() - 0.25 * (p.y() - at.y()); };
    const Field lid = overlap(ball(at, 4.5), above, 0.8);
    return join({globe, lid}, 0.3);
}

Field brow() {
    return limb({{{3.2, -20, 51.2}, 2.6}, {{7.6, -15.5, 54}, 2.8}, {{10.5, -8, 53}, 2.4}});
}

Field ear() {
    const Vector3d front = Vector3d(0.1, -0.95, 0.35).normalized();
    const Field leaf = limb({{{10, -2, 49}, 3.6, 3},
                             {{17, -1.5, 49.5}, 5.2, 2.8},
                             {{25, -3, 46}, 5.4, 2.5},
                             {{32, -6.5, 40}, 2.4, 2}},
                            front);
    const Field hollow = limb({{Vector3d(15, -1.5, 49.5) + 3.2 * front, 2.4, 2.4},
                               {Vector3d(24, -3, 46.3) + 3 * front, 3.2, 2.4},
                               {Vector3d(30, -6, 41.5) + 2.4 * front, 1.4, 1.8}},
                              front);
    return carve(leaf, hollow, 1.4);
}

/// Out, over and round again, the tip forward.
Field horn() {
    return limb({{{5.2, -4, 57}, 5.6},
                 {{8, 1, 68}, 5.4},
                 {{16, 5, 78}, 5},
                 {{28, 6, 81}, 4.5},
                 {{37, 2, 74.5}, 3.9},
                 {{38.5, -4.5, 64.5}, 3.3},
                 {{32, -10.5, 58}, 2.6},
                 {{25.5, -15, 59}, 2}});
}

Field beard() {
    return limb({{{0, -30, 25}, 4.6, 3.8},
                 {{0, -31, 17}, 4.2, 3.4},
                 {{0, -30, 10}, 3, 2.6},
                 {{0, -27.5, 4}, 1.8, 1.8}});
}

Field carvings() {
    const Field nostril = limb({{{2.2, -42.4, 32.4}, 1}, {{3.6, -41.6, 34}, 1.2}, {{4.8, -39.6, 34.4}, 0.8}});
    const Field mouth = limb(
        {{{0.4, -43, 27.6}, 0.6}, {{4.4, -40, 26.8}, 0.7}, {{6.2, -33, 28.4}, 0.7}, {{6.6, -28, 31}, 0.5}});
    return join({nostril, mirrored(nostril), mouth, mirrored(mouth)}, 0.5);
}

} // namespace

Sample goatHead() {
    const Field base = carve(skull(), [](const Vector3d& p) { return p.z() + 1; }, 1.5);
    const Field grown = join({base, brow(), mirrored(brow()), beard()}, 2.5);
    const Field face = carve(join({grown, eye(), mirrored(eye())}, 0.8), carvings(), 0.8);
    return {"goat_head",
            "Goat head",
            "Curled horns, an eye worth keeping",
            {join({face, ear(), mirrored(ear()), join({horn(), mirrored(horn())}, 4)}, 2.5),
             {Vector3d(-46, -50, -8), Vector3d(46, 30, 90)}},
            {0.95, 4, 0.1}};
}

} // namespace moldwright::samples
