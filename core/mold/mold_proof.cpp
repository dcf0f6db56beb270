// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_proof.h"

#include "mold/release.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

void proveHalf(const Mold& mold, int side, std::vector<std::string>& problems) {
    const IndexedMesh& half = *(side == 1 ? mold.half1 : mold.half2).mesh;
    const IndexedMesh& other = *(side == 1 ? mold.half2 : mold.half1).mesh;
    const HalfRelease release =
        examineRelease(half, other, *mold.cast, mold.directions.of(side), mold.draftDegrees);
    const std::string name = "Half " + std::to_string(side);
    if (!release.sound)
        problems.push_back(name + " is not one closed solid free of self-intersection.");
    if (!release.stuckFaces.empty())
        problems.push_back(name + " has " + std::to_string(release.stuckFaces.size()) +
                           " faces below the draft angle.");
    if (!release.sweptFaces.empty())
        problems.push_back(name + " meets the cast or the other half when it leaves.");
}

} // namespace

std::vector<std::string> problemsOf(const Mold& mold) {
    std::vector<std::string> problems;
    if (!mold.castCertificate.holds())
        problems.push_back("The cast in the mold's frame is not certified. " + mold.castCertificate.reason);
    for (const int side : {1, 2})
        proveHalf(mold, side, problems);
    const bool keyed = std::any_of(mold.features.begin(), mold.features.end(),
                                   [](const MoldFeature& feature) { return feature.kind == "key"; });
    if (keyed && !leavesOther(*mold.half1.mesh, *mold.half2.mesh,
                              (mold.directions.d1 - mold.directions.d2).normalized()))
        problems.emplace_back("A key holds the halves when both are opened at once.");
    const double whole =
        mold.half1.volume + mold.half2.volume + mold.cavityVolume + mold.channelVolume + mold.otherVolume;
    constexpr double rounding = 1e-6;
    if (std::abs(mold.blockVolume - whole) > rounding * mold.blockVolume)
        problems.emplace_back("The volumes of halves and cavity do not add up to the block's.");
    return problems;
}

} // namespace moldwright
