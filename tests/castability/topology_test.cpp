// SPDX-License-Identifier: AGPL-3.0-or-later
// The topological certificate against a judge of its own: Euler characteristic, boundary walks, turning and
// winding numbers of the labelled faces.
#include "castability/topology.h"

#include "castability/parting_line.h"
#include "support/labelled_pieces.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <ostream>
#include <set>

using namespace moldwright;
using test::PieceVerdict;

namespace moldwright::test {

void PrintTo(PieceVerdict verdict, std::ostream* out) {
    *out << std::array{"free", "closed", "handle", "arch", "pocket"}[static_cast<std::size_t>(verdict)];
}

} // namespace moldwright::test

namespace {

constexpr double kPi = std::numbers::pi;

/// Side and verdict of a piece.
using Verdicts = std::multiset<std::pair<int, PieceVerdict>>;

PieceVerdict verdictOf(PieceFault fault) {
    switch (fault) {
    case PieceFault::None:
        return PieceVerdict::Free;
    case PieceFault::Closed:
        return PieceVerdict::Closed;
    case PieceFault::Handle:
        return PieceVerdict::Handle;
    case PieceFault::Arch:
        return PieceVerdict::Arch;
    case PieceFault::Pocket:
        break;
    }
    return PieceVerdict::Pocket;
}

IndexedMesh shifted(IndexedMesh mesh, const Eigen::Vector3d& by) {
    mesh.V.rowwise() += by.transpose();
    return mesh;
}

IndexedMesh insideOut(IndexedMesh mesh) {
    mesh.F.col(1).swap(mesh.F.col(2));
    return mesh;
}

IndexedMesh standingTorus(double height) {
    return shifted(test::rotated(test::torus(2, 0.7, 64, 48), Eigen::Vector3d::UnitX(), kPi / 2),
                   {0, 0, height});
}

/// What stands about the z axis: a closed profile of (radius, height), first and last point on the axis.
IndexedMesh lathed(const std::vector<Eigen::Vector2d>& profile, int around) {
    const int rings = static_cast<int>(profile.size()) - 2;
    IndexedMesh mesh;
    mesh.V.resize(rings * around + 2, 3);
    for (int r = 0; r < rings; ++r)
        for (int a = 0; a < around; ++a) {
            const Eigen::Vector2d p = profile[static_cast<std::size_t>(r) + 1];
            const double t = 2 * kPi * a / around;
            mesh.V.row(r * around + a) << p.x() * std::cos(t), p.x() * std::sin(t), p.y();
        }
    const int first = rings * around;
    mesh.V.row(first) << 0, 0, profile.front().y();
    mesh.V.row(first + 1) << 0, 0, profile.back().y();
    std::vector<Eigen::RowVector3i> faces;
    const auto at = [&](int r, int a) { return r * around + a % around; };
    for (int a = 0; a < around; ++a) {
        faces.emplace_back(first, at(0, a + 1), at(0, a));
        for (int r = 0; r + 1 < rings; ++r) {
            faces.emplace_back(at(r, a), at(r, a + 1), at(r + 1, a + 1));
            faces.emplace_back(at(r, a), at(r + 1, a + 1), at(r + 1, a));
        }
        faces.emplace_back(at(rings - 1, a), at(rings - 1, a + 1), first + 1);
    }
    mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f)
        mesh.F.row(static_cast<Eigen::Index>(f)) = faces[f];
    return mesh;
}

/// A cup with its mouth down: outside from the rim at −1 to the top at 2, inside up to a ceiling at 1.5.
IndexedMesh cupUpsideDown() {
    return lathed({{0, 1.5}, {0.8, 1.4}, {0.9, -1}, {1.2, -1}, {1.1, 1.9}, {0, 2}}, 24);
}

/// What the room says of a part at z = 0, after checking that the judge says the same of every piece.
Verdicts agreed(const IndexedMesh& part) {
    const PartedMesh parted = insertPartingLine(part, 0.1);
    Verdicts ours;
    Verdicts judged;
    for (const SidePiece& piece : sidePieces(parted.mesh, parted.labels)) {
        ours.emplace(piece.side, verdictOf(pieceFault(parted.mesh, piece)));
        EXPECT_GE(piece.genus, 0);
    }
    for (const test::LabelledPiece& piece : test::labelledPieces(parted.mesh, parted.labels))
        judged.emplace(piece.side, piece.verdict());
    EXPECT_EQ(ours, judged);
    const bool free = std::all_of(judged.begin(), judged.end(),
                                  [](const auto& piece) { return piece.second == PieceVerdict::Free; });
    EXPECT_EQ(topologyAllowsCasting(parted.mesh, parted.labels), free);
    return judged;
}

} // namespace

TEST(Topology, ATorusIsFreeWhereThePlaneHalvesItsHole) {
    EXPECT_EQ(agreed(test::torus(2, 0.7, 64, 48)),
              (Verdicts{{1, PieceVerdict::Free}, {2, PieceVerdict::Free}}));
}

TEST(Topology, AStandingTorusIsAnArchAHandleOrAClosedPieceByTheHeightOfThePlane) {
    EXPECT_EQ(agreed(standingTorus(0)), (Verdicts{{1, PieceVerdict::Arch}, {2, PieceVerdict::Arch}}));
    EXPECT_EQ(agreed(standingTorus(2.1)), (Verdicts{{1, PieceVerdict::Handle}, {2, PieceVerdict::Free}}));
    EXPECT_EQ(agreed(standingTorus(-2.1)), (Verdicts{{1, PieceVerdict::Free}, {2, PieceVerdict::Handle}}));
    EXPECT_EQ(agreed(standingTorus(3)), (Verdicts{{1, PieceVerdict::Closed}}));
}

TEST(Topology, ATorusThroughAPlaneOfAnyLeanIsJudgedAlike) {
    std::set<PieceVerdict> met;
    for (int lean = 0; lean <= 18; ++lean)
        for (const double height : {-2.2, -1.0, -0.3, 0.0, 0.45, 1.3, 2.4}) {
            SCOPED_TRACE("leaning " + std::to_string(5 * lean) + "°, height " + std::to_string(height));
            const IndexedMesh torus = test::rotated(test::torus(2, 0.7, 37, 23),
                                                    Eigen::Vector3d(1, 0.3, 0).normalized(), kPi / 36 * lean);
            for (const auto& [side, verdict] : agreed(shifted(torus, {0, 0, height})))
                met.insert(verdict);
        }
    EXPECT_TRUE(met.contains(PieceVerdict::Free) && met.contains(PieceVerdict::Arch) &&
                met.contains(PieceVerdict::Handle));
}

TEST(Topology, ACupUpsideDownHoldsAPocketOfAir) {
    EXPECT_EQ(agreed(cupUpsideDown()),
              (Verdicts{{1, PieceVerdict::Free}, {1, PieceVerdict::Pocket}, {2, PieceVerdict::Free}}));
    // Cut through its bottom it is a bell, whose inside belongs to the half that fills it.
    EXPECT_EQ(agreed(shifted(cupUpsideDown(), {0, 0, -1.7})),
              (Verdicts{{1, PieceVerdict::Free}, {2, PieceVerdict::Free}}));
}

TEST(Topology, ACavityIsClosedWhereverThePlaneIsNot) {
    const IndexedMesh hollow =
        test::together(test::sphere({0, 0, 0}, 2, 4), insideOut(test::sphere({0, 0, 1}, 0.5, 3)));
    EXPECT_EQ(agreed(hollow),
              (Verdicts{{1, PieceVerdict::Free}, {1, PieceVerdict::Closed}, {2, PieceVerdict::Free}}));
    // Cut in two it is a pocket on either side.
    EXPECT_EQ(agreed(shifted(hollow, {0, 0, -1})), (Verdicts{{1, PieceVerdict::Free},
                                                             {1, PieceVerdict::Pocket},
                                                             {2, PieceVerdict::Free},
                                                             {2, PieceVerdict::Pocket}}));
}

TEST(Topology, RingsOfALinkAreJudgedEachForItself) {
    const IndexedMesh lying = test::torus(2, 0.5, 48, 24);
    const IndexedMesh standing =
        shifted(test::rotated(test::torus(2, 0.5, 48, 24), Eigen::Vector3d::UnitX(), kPi / 2), {2, 0, 0});
    EXPECT_EQ(agreed(test::together(lying, standing)), (Verdicts{{1, PieceVerdict::Free},
                                                                 {1, PieceVerdict::Arch},
                                                                 {2, PieceVerdict::Free},
                                                                 {2, PieceVerdict::Arch}}));
}

TEST(Topology, AHoleThroughBothSidesIsFreeASecondOneOnOneSideIsNot) {
    // A bar with an eye above the plane, beside a ring that lies in it.
    const IndexedMesh both =
        test::together(test::torus(2, 0.5, 48, 24), shifted(standingTorus(2.1), {8, 0, 0}));
    EXPECT_EQ(agreed(both), (Verdicts{{1, PieceVerdict::Free},
                                      {1, PieceVerdict::Handle},
                                      {2, PieceVerdict::Free},
                                      {2, PieceVerdict::Free}}));
}
