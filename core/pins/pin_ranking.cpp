// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/pin_ranking.h"

#include "base/parallel.h"
#include "castability/energy.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double kKindCounts = 0.4;
constexpr double kAreaCounts = 0.25;
constexpr double kGainCounts = 0.35;

double worthOf(PinKind kind) {
    return kind == PinKind::Tip ? 1 : kind == PinKind::Junction ? 0.7 : 0.4;
}

/// The faces that belong to one pin, as a mesh of their own on all the part's points.
IndexedMesh regionOf(int pin, const PinSuggestions& suggestions, const IndexedMesh& part) {
    std::vector<int> faces;
    for (int f = 0; f < part.faceCount(); ++f)
        if (suggestions.pinOfFace[static_cast<std::size_t>(f)] == pin)
            faces.push_back(f);
    IndexedMesh region;
    region.V.resize(static_cast<Eigen::Index>(3 * faces.size()), 3);
    region.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const int v = static_cast<int>(3 * i) + k;
            region.V.row(v) = part.V.row(part.F(faces[i], k));
            region.F(static_cast<Eigen::Index>(i), k) = v;
        }
    return region;
}

} // namespace

void setRanks(std::vector<SuggestedPin>& pins) {
    double mostArea = 0;
    double mostGain = 0;
    for (const SuggestedPin& pin : pins) {
        mostArea = std::max(mostArea, pin.areaShare);
        mostGain = std::max(mostGain, pin.gain);
    }
    const auto share = [](double value, double most) { return most > 0 ? std::max(0.0, value) / most : 0; };
    for (SuggestedPin& pin : pins)
        pin.rank = kKindCounts * worthOf(pin.kind) + kAreaCounts * share(pin.areaShare, mostArea) +
                   kGainCounts * share(pin.gain, mostGain);
}

void rankPins(PinSuggestions& suggestions, const IndexedMesh& part, const MoldState& state,
              double draftDegrees) {
    const double tau = std::sin(radians(draftDegrees));
    const double whole = castabilityEnergy(part, state, tau);
    parallelFor(suggestions.pins.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            SuggestedPin& pin = suggestions.pins[i];
            const IndexedMesh region = regionOf(static_cast<int>(i), suggestions, part);
            MoldState atPin = state; // moving the plane to the pin is moving the pin's region to the plane
            atPin.plane.offset = state.plane.normal.dot(pin.point);
            const double gone = castabilityEnergy(region, state, tau) - castabilityEnergy(region, atPin, tau);
            pin.gain = whole > 0 ? gone / whole : 0;
        }
    });
    setRanks(suggestions.pins);
}

} // namespace moldwright
