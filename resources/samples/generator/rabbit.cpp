// SPDX-License-Identifier: AGPL-3.0-or-later
#include "limb.h"
#include "samples.h"

namespace moldwright::samples {

namespace {

Field body() {
    const Field trunk = limb({{{0, 13, 17}, 16}, {{0, 6, 26}, 16}, {{0, -3, 37}, 14.8}, {{0, -8, 48}, 11.5}});
    const Field chest = ellipsoid({0, -9, 27}, {9, 8, 14});
    const Field haunch = ellipsoid({11.5, 7, 16.5}, {9, 14.5, 14.5}, {-0.3, 0, -0.12});
    const Field hindFoot =
        limb({{{16, 9, 5}, 6, 5}, {{17, -5, 4.4}, 4.7, 4.4}, {{17, -13, 4.6}, 5, 4.6}}, Vector3d::UnitZ());
    const Field frontLeg =
        limb({{{5.6, -9, 30}, 6.5}, {{5.4, -14, 18}, 5}, {{4.5, -16.5, 8}, 4.3}, {{4.4, -20.5, 4.4}, 4.4}});
    const Field belly = ellipsoid({0, -5, 15}, {12, 11, 14});
    const Field tail = ball({0, 28, 12}, 6.6);
    return join({join({trunk, chest, belly, haunch, mirrored(haunch), frontLeg, mirrored(frontLeg)}, 4),
                 join({hindFoot, mirrored(hindFoot)}, 1), tail},
                2.5);
}

Field head() {
    const Field skull = ellipsoid({0, -12, 57.5}, {13.2, 14.5, 12.8}, {0.2, 0, 0});
    const Field cheek = ellipsoid({6.4, -17.5, 52}, {6.6, 7.5, 6.4});
    const Field muzzle = ellipsoid({0, -23, 53}, {6, 6.5, 6});
    const Field lip = ellipsoid({2.5, -27, 50.6}, {3.5, 3.2, 3});
    const Field chin = ball({0, -25.5, 48.2}, 2.6);
    const Field nose = ellipsoid({0, -29.6, 54}, {2.3, 1.6, 1.5});
    const Field soft = join({skull, cheek, mirrored(cheek), muzzle}, 5);
    return join({join({soft, chin, join({lip, mirrored(lip)}, 0.5)}, 1.6), nose}, 0.8);
}

Field ear(const std::vector<Station>& stations, const Vector3d& flat) {
    std::vector<Station> hollow;
    for (std::size_t k = 1; k + 1 < stations.size(); ++k) {
        const Station& s = stations[k];
        hollow.push_back({s.at + flat * s.thickness * 1.25, s.width * 0.6, s.thickness});
    }
    return carve(limb(stations, flat), limb(hollow, flat), 1.5);
}

Field ears() {
    const Field upright = ear({{{5, -7, 63}, 4, 3.6},
                               {{7, -4.5, 71}, 5.2, 3.6},
                               {{9.5, -1, 81}, 7, 3.4},
                               {{11, 3, 90}, 5.8, 3},
                               {{11.6, 6, 97}, 3, 2.5}},
                              Vector3d(0.25, -0.9, 0.3).normalized());
    const Field folded = ear({{{-5, -7, 63}, 4, 3.6},
                              {{-8.5, -5, 71}, 5.2, 3.6},
                              {{-15, -5.5, 79}, 7, 3.4},
                              {{-23, -8, 81.5}, 6, 3.1},
                              {{-29.5, -11, 79}, 3.2, 2.6}},
                             Vector3d(-0.15, -0.85, -0.45).normalized());
    return join({upright, folded}, 1);
}

} // namespace

Sample rabbit() {
    const Field soft = join({body(), head(), ears()}, 3);
    const Vector3d at(9.2, -20.6, 59.8);
    const Field socket = ellipsoid(at + Vector3d(1.2, -0.9, 0), {2.4, 4.2, 4.4}, {0, 0, -0.75});
    const Field eye = ellipsoid(at, {2.4, 3.2, 3.4}, {0, 0, -0.75});
    const Field lidded = carve(soft, join({socket, mirrored(socket)}, 0), 1);
    return {"rabbit",
            "Sitting rabbit",
            "Ears that lean apart",
            {join({lidded, eye, mirrored(eye)}, 0.3), {Vector3d(-39, -36, -5), Vector3d(30, 44, 106)}},
            {1.1, 4, 0.1}};
}

} // namespace moldwright::samples
