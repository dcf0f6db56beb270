// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_proof.h"

#include "base/parallel.h"
#include "base/stop_point.h"
#include "castability/exact_predicates.h"
#include "mold/release.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

namespace {

std::vector<std::string> problemsOfHalf(const Mold& mold, int side) {
    const IndexedMesh& half = *(side == 1 ? mold.half1 : mold.half2).mesh;
    const IndexedMesh& other = *(side == 1 ? mold.half2 : mold.half1).mesh;
    const HalfRelease release =
        examineRelease(half, other, *mold.cast, mold.directions.of(side), mold.draftDegrees);
    const std::string name = "Half " + std::to_string(side);
    std::vector<std::string> problems;
    if (!release.sound)
        problems.push_back(name + " is not one closed solid free of self-intersection.");
    if (!release.stuckFaces.empty())
        problems.push_back(name + " has " + std::to_string(release.stuckFaces.size()) +
                           " faces below the draft angle.");
    if (!release.sweptFaces.empty())
        problems.push_back(name + " meets the cast or the other half when it leaves.");
    return problems;
}

/// Faces of a half's outer walls that do not have the draft against its form, exact.
std::vector<std::string> problemsOfForm(const Mold& mold, const Block& block, int side) {
    const double draft = mold.settings.outerDraft;
    if (draft == 0)
        return {};
    const IndexedMesh& half = *(side == 1 ? mold.half1 : mold.half2).mesh;
    const double tau = provableTolerance(std::abs(draft));
    const double touching = onPlaneTolerance(half);
    int held = 0;
    for (int f = 0; f < half.faceCount(); ++f) {
        stopPointAt(f);
        const std::array<Eigen::Vector3d, 3> p = {half.corner(f, 0), half.corner(f, 1), half.corner(f, 2)};
        if (block.wallWith(p, touching) == std::nullopt)
            continue;
        const std::size_t second = draft > 0 ? 2 : 1; // turned round: the face of the form
        held += leavesAlong(p[0], p[second], p[3 - second], mold.directions.of(side), tau) ? 0 : 1;
    }
    if (held == 0)
        return {};
    return {"Half " + std::to_string(side) + " has " + std::to_string(held) +
            " outer faces that do not leave its form."};
}

/// Whether a key holds the halves when both leave at once.
bool keysHold(const Mold& mold) {
    const bool keyed = std::any_of(mold.features.begin(), mold.features.end(),
                                   [](const MoldFeature& feature) { return feature.kind == "key"; });
    return keyed && !leavesOther(*mold.half1.mesh, *mold.half2.mesh,
                                 (mold.directions.d1 - mold.directions.d2).normalized());
}

} // namespace

void proveMold(Mold& mold, const Block& block) {
    std::array<std::vector<std::string>, 4> ofHalf;
    bool held = false;
    parallelInvoke(
        {[&] {
             mold.castCertificate =
                 certify(*mold.cast, labelSides(*mold.cast, {}), {{}, mold.directions}, mold.draftDegrees);
         },
         [&] { ofHalf[0] = problemsOfHalf(mold, 1); }, [&] { ofHalf[1] = problemsOfHalf(mold, 2); },
         [&] { ofHalf[2] = problemsOfForm(mold, block, 1); },
         [&] { ofHalf[3] = problemsOfForm(mold, block, 2); }, [&] { held = keysHold(mold); }});
    mold.problems.clear();
    if (!mold.castCertificate.holds())
        mold.problems.push_back("The cast in the mold's frame is not certified. " +
                                mold.castCertificate.reason);
    for (const std::vector<std::string>& problems : ofHalf)
        mold.problems.insert(mold.problems.end(), problems.begin(), problems.end());
    if (held)
        mold.problems.emplace_back("A key holds the halves when both are opened at once.");
    // A sprue leaves half 1 outwards once it has broken off.
    if (mold.sprues && !leavesOther(*mold.sprues, *mold.half1.mesh, mold.directions.d1))
        mold.problems.emplace_back("A sprue cannot be pushed out of half 1.");
    const double whole =
        mold.half1.volume + mold.half2.volume + mold.cavityVolume + mold.channelVolume + mold.otherVolume;
    constexpr double rounding = 1e-6;
    if (std::abs(mold.blockVolume - whole) > rounding * mold.blockVolume)
        mold.problems.emplace_back("The volumes of halves and cavity do not add up to the block's.");
}

} // namespace moldwright
