// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold.h"

#include "castability/parting_curves.h"
#include "castability/placed_cast.h"
#include "mesh/measures.h"
#include "mold/block.h"
#include "mold/half.h"
#include "mold/release.h"

#include <cmath>

namespace moldwright {

namespace {

/// Presses are chosen with this much in hand over pressure × area (1.1 to 1.2 are usual).
constexpr double clampAllowance = 1.1;

MoldHalf measured(IndexedMesh mesh) {
    MoldHalf half;
    half.volume = volume(mesh);
    half.size = boundingBox(mesh).sizes();
    half.mesh = std::make_shared<const IndexedMesh>(std::move(mesh));
    return half;
}

/// Area that the curves enclose in the plane z = 0; inner curves run the other way and count as holes.
double enclosedArea(const IndexedMesh& cast, const std::vector<PartingCurve>& curves) {
    double doubled = 0;
    for (const PartingCurve& curve : curves)
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const Eigen::Vector3d a = cast.point(curve[i]);
            const Eigen::Vector3d b = cast.point(curve[(i + 1) % curve.size()]);
            doubled += a.x() * b.y() - a.y() * b.x();
        }
    return doubled / 2;
}

std::vector<std::string> problemsOf(const Mold& mold, const Block& block) {
    std::vector<std::string> problems;
    if (!mold.castCertificate.holds())
        problems.push_back("The cast in the mold's frame is not certified. " + mold.castCertificate.reason);
    for (const int side : {1, 2}) {
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
    const double whole = mold.half1.volume + mold.half2.volume + mold.cavityVolume + mold.channelVolume;
    constexpr double rounding = 1e-6;
    if (std::abs(block.volume() - whole) > rounding * block.volume())
        problems.emplace_back("The volumes of halves and cavity do not add up to the block's.");
    return problems;
}

} // namespace

Result<Mold> buildMold(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                       double draftDegrees, const MoldSettings& settings, const Task& task) {
    task.progress(0, "Place the cast");
    const PlacedCast placed = placeCast(cast, labels, state, draftDegrees);
    Mold mold;
    mold.settings = settings;
    mold.draftDegrees = draftDegrees;
    mold.partToMold = placed.fromPart;
    mold.directions = placed.state.directions;
    mold.castCertificate = certify(placed.mesh, labels, placed.state, draftDegrees);
    if (!mold.castCertificate.closedAndOutward || !mold.castCertificate.curvesSimpleAndNested)
        return failure(ErrorCode::BadInput,
                       MW_TEXT("Mold", "No mold can be built round this cast. {0} Finish the cast first."),
                       {mold.castCertificate.reason});
    if (task.stopped())
        return failure(ErrorCode::Cancelled, MW_TEXT("Mold", "Building the mold was cancelled."));

    task.progress(0.4, "Build the halves");
    const std::vector<PartingCurve> curves = *partingCurves(placed.mesh, labels);
    const Block block = blockAround(placed.mesh, settings);
    const std::optional<PartingFace> parting = partingFace(placed.mesh, curves, block);
    if (!parting)
        return failure(ErrorCode::Internal,
                       MW_TEXT("Mold", "The parting face could not be built: the parting curves cross."));
    mold.half1 = measured(assembleHalf(1, placed.mesh, labels, *parting, block));
    mold.half2 = measured(assembleHalf(2, placed.mesh, labels, *parting, block));
    mold.cast = std::make_shared<const IndexedMesh>(placed.mesh);
    mold.cavityVolume = volume(placed.mesh);
    mold.partingArea = enclosedArea(placed.mesh, curves);
    // cm² × bar / 100 = kN.
    mold.clampForce = mold.partingArea / 100 * settings.pressure / 100 * clampAllowance;
    const LeastWall least = leastWall(placed.mesh, block);
    mold.minWall = least.thickness;
    mold.minWallPlace = least.place;
    if (task.stopped())
        return failure(ErrorCode::Cancelled, MW_TEXT("Mold", "Building the mold was cancelled."));

    task.progress(0.6, "Prove the halves");
    mold.problems = problemsOf(mold, block);
    task.progress(1, "Prove the halves");
    return mold;
}

} // namespace moldwright
