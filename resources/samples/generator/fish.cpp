// SPDX-License-Identifier: AGPL-3.0-or-later
#include "limb.h"
#include "samples.h"

namespace moldwright::samples {

namespace {

Field body(double inflation) {
    std::vector<Station> stations = {{{0, -41, 28.8}, 7.8, 6},    {{0, -34.5, 29.3}, 10.4, 7.6},
                                     {{0, -20, 30.5}, 14.6, 9.5}, {{0, -3, 30.5}, 15.5, 9.4},
                                     {{1.5, 15, 30}, 11, 7},      {{6, 30, 30}, 5.8, 4.2},
                                     {{12.5, 40, 30.5}, 4.6, 3}};
    for (Station& s : stations) {
        s.width += inflation;
        s.thickness += inflation;
    }
    return limb(stations);
}

Field tailFin() {
    const Vector3d side = Vector3d(0.85, -0.5, 0).normalized();
    const Field upper = limb(
        {{{11, 38, 31}, 3.5, 2.2}, {{17, 46, 38}, 6, 1.9}, {{23, 52, 47}, 5, 1.7}, {{27, 55, 54}, 1.6, 1.5}},
        side);
    const Field lower = limb({{{11, 38, 30}, 3.5, 2.2},
                              {{17, 46, 23.5}, 5.8, 1.9},
                              {{22.5, 51.5, 16}, 4.8, 1.7},
                              {{26, 54.5, 10}, 1.6, 1.5}},
                             side);
    const Field middle =
        limb({{{11, 38, 30.5}, 4, 2.2}, {{15, 43.4, 30.7}, 6, 1.9}, {{17.5, 46.4, 30.8}, 5, 1.6}}, side);
    return join({upper, lower, middle}, 3);
}

Field fins() {
    const Field dorsal = limb(
        {{{0, -11, 41}, 9, 2.4}, {{0, -4, 50}, 8.5, 2}, {{0.5, 5, 56.5}, 5.5, 1.7}, {{1, 12, 59}, 2, 1.5}});
    const Field anal = limb({{{1, 9, 21}, 5.5, 2.1}, {{2, 15, 14.5}, 4.4, 1.8}, {{3, 21, 11}, 1.8, 1.5}});
    const Field pectoral = limb({{{7.5, -17, 25}, 3, 2},
                                 {{13, -11, 22}, 4.4, 1.8},
                                 {{18, -4, 19.5}, 4, 1.6},
                                 {{20.5, 0.5, 18.5}, 1.8, 1.4}},
                                Vector3d(0.45, 0.1, 0.9).normalized());
    const Field pelvic = limb({{{2.8, -9, 17}, 3, 1.9}, {{4.8, -3, 11.5}, 3.4, 1.7}, {{6, 2, 8}, 1.6, 1.4}},
                              Vector3d(0.95, 0, 0.3).normalized());
    return join({dorsal, anal, pectoral, mirrored(pectoral), pelvic, mirrored(pelvic)}, 1);
}

} // namespace

Sample fish() {
    const Field gillCover = overlap(body(0.8), ellipsoid({0, -40, 29.5}, {18, 23, 18}), 1);
    const Field mouth = limb({{{0, -49.2, 26.6}, 0.8}, {{4, -46.4, 25.6}, 0.8}, {{7, -40.5, 23.8}, 0.7}});
    const Field trunk = carve(join({body(0), gillCover}, 0.6), join({mouth, mirrored(mouth)}, 0.5), 0.8);
    const Field eye = ellipsoid({7.3, -34, 33}, {2.4, 2.9, 2.9});
    const Field whole = join({trunk, fins(), tailFin()}, 2.5);
    return {"fish",
            "Fish",
            "Keep the curve of the tail fin",
            {join({whole, eye, mirrored(eye)}, 0.5), {Vector3d(-26, -50, 2), Vector3d(34, 62, 66)}},
            {0.9, 4, 0.09}};
}

} // namespace moldwright::samples
