// SPDX-License-Identifier: AGPL-3.0-or-later
// The parts of the workshop: a beam, a knob, a praline.
#include "samples.h"

#include <cmath>

namespace moldwright::samples {

namespace {

/// The straight solid (along z) bent about the axis x = −radius, y free, and twisted by `twist` radians a mm.
Field bent(Field straight, double radius, double twist) {
    return [straight = std::move(straight), radius, twist](const Vector3d& p) {
        const double angle = std::atan2(p.z(), p.x() + radius);
        const double along = radius * angle;
        const double u = std::hypot(p.x() + radius, p.z()) - radius;
        const double c = std::cos(twist * along);
        const double s = std::sin(twist * along);
        return straight({c * u + s * p.y(), c * p.y() - s * u, along});
    };
}

/// How deep the flute at this angle is, 0 to 1: round valleys between narrower ridges.
double flute(double angle, int count) {
    const double wave = (1 + std::cos(count * angle)) / 2;
    return wave * (2 - wave);
}

/// Fluted bulb about the y axis, centre at the origin; the flutes swirl and fade towards both poles.
Field fluted(const Vector3d& radii, double depth, int count, double swirl) {
    return [=](const Vector3d& p) {
        const double latitude = std::atan2(p.y() / radii.y(), std::hypot(p.x(), p.z()) / radii.x());
        const double fade = std::pow(std::cos(latitude), 2);
        const double angle = std::atan2(p.z(), p.x()) + swirl * latitude;
        return ellipticDistance(p, radii) + depth * fade * flute(angle, count);
    };
}

} // namespace

Sample bentBeam() {
    constexpr double half = 47;
    const Field web = roundedBox({0, 0, 0}, {4, 9.5, 2 * half}, 0.1);
    const Field upper = roundedBox({0, 12.5, 0}, {12, 3.5, 2 * half}, 1);
    const Field lower = roundedBox({0, -12.5, 0}, {12, 3.5, 2 * half}, 1);
    const Field ends = [](const Vector3d& p) { return std::abs(p.z()) - half; };
    const Field beam = overlap(join({web, upper, lower}, 3), ends, 1.6);
    return {"bent_beam",
            "Bent beam",
            "Sharp corners, exact flanges",
            {bent(beam, 75, 0.006), {Vector3d(-40, -26, -56), Vector3d(24, 26, 56)}},
            {1.15, 4.5, 0.1}};
}

Sample doorKnob() {
    const Field rose = [](const Vector3d& p) {
        const double r = std::hypot(p.x(), p.z());
        return roundedBox({0, 0, 0}, {27, 3.5, 27}, 2)({r, p.y() + 3.5, 0});
    };
    const Field collar = ellipsoid({0, -7, 0}, {17, 4.5, 17});
    const Field neck = [](const Vector3d& p) {
        const double r = std::hypot(p.x(), p.z());
        return std::max(r - 8.5, std::abs(p.y() + 24) - 14);
    };
    const Field bulb = moved(fluted({25, 17, 25}, 1.6, 14, 0.9), {0, -44, 0});
    return {
        "door_knob",
        "Door knob",
        "A neck that locks in any mold",
        {join({join({rose, collar}, 0.6), neck, bulb}, 6), {Vector3d(-31, -66, -31), Vector3d(31, 5, 31)}},
        {1.25, 3.6, 0.13}};
}

Sample praline() {
    constexpr double height = 14;
    const Field wall = [](const Vector3d& p) {
        const double t = p.z() / height;
        const double r = 18 - 3.6 * t - 1.2 * t * t;
        const double depth = 1.8 * (1 - 0.3 * t);
        return std::hypot(p.x(), p.y()) - r + depth * flute(std::atan2(p.y(), p.x()), 10);
    };
    const Field top = ball({0, 0, height - 36}, 36);
    const Field nut = ball({0, 0, height - 2.2}, 5.4);
    return {"praline",
            "Praline",
            "Flat back, castable as it is",
            {join({overlap(wall, top, 4), nut}, 2.5), {Vector3d(-21, -21, 0), Vector3d(21, 21, 20)}, true},
            {0.5, 2, 0.02}};
}

} // namespace moldwright::samples
