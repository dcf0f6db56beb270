// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/mold_states.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace moldwright;

namespace {

using Eigen::Vector3d;

/// A coil of round wire about the z axis, its ends closed.
IndexedMesh coil(double radius, double wire, double rise, int turns) {
    constexpr int steps = 40;
    constexpr int around = 8;
    const int rings = turns * steps + 1;
    IndexedMesh mesh;
    mesh.V.resize(rings * around + 2, 3);
    mesh.F.resize(2 * rings * around, 3);
    const auto middle = [&](int ring) {
        const double angle = 2 * std::numbers::pi * ring / steps;
        return Vector3d(radius * std::cos(angle), radius * std::sin(angle), rise * ring / steps);
    };
    Eigen::Index face = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const Vector3d out = Vector3d(middle(ring).x(), middle(ring).y(), 0).normalized();
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            const int next = ring * around + (k + 1) % around;
            mesh.V.row(ring * around + k) =
                middle(ring) + wire * (std::cos(angle) * out + std::sin(angle) * Vector3d::UnitZ());
            if (ring + 1 < rings) {
                mesh.F.row(face++) << ring * around + k, next + around, next;
                mesh.F.row(face++) << ring * around + k, ring * around + k + around, next + around;
            } else {
                mesh.F.row(face++) << ring * around + k, rings * around + 1, next;
                mesh.F.row(face++) << k, (k + 1) % around, rings * around;
            }
        }
    }
    mesh.V.row(rings * around) = middle(0);
    mesh.V.row(rings * around + 1) = middle(rings - 1);
    return mesh;
}

} // namespace

TEST(MoldStates, ACoilIsPartedSquareToItsAxis) {
    const auto part = std::make_shared<const IndexedMesh>(coil(10, 2, 6, 3));
    DesignRequest request;
    request.part = part;
    DesignRun run(request, {}, {});
    Result<MoldStates> states = MoldStates::create(*part, run);
    ASSERT_TRUE(states);
    const std::optional<MoldState> state = states->next();
    ASSERT_TRUE(state);
    EXPECT_GT(std::abs(state->plane.normal.z()), 0.9);
}

TEST(MoldStates, TheLeastIsFilledWhereARingIsParted) {
    const auto part = std::make_shared<const IndexedMesh>(
        test::rotated(test::torus(10, 3, 40, 20), Vector3d(1, 2, 0).normalized(), 0.7));
    const Vector3d axis = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 0).normalized()) * Vector3d::UnitZ();
    DesignRequest request;
    request.part = part;
    DesignRun run(request, {}, {});
    const Result<MoldStates> states = MoldStates::create(*part, run);
    ASSERT_TRUE(states);
    const FillableState least = states->leastToFill();
    EXPECT_GT(std::abs(least.state.plane.normal.dot(axis)), 0.98);
    EXPECT_LT(least.filled, 0.05);
}

TEST(MoldStates, APlaneThatIsGivenIsTheOnlyOne) {
    const auto part = std::make_shared<const IndexedMesh>(test::sphere({0, 0, 0}, 10, 3));
    DesignRequest request;
    request.part = part;
    request.plane = PartingPlane{Vector3d::UnitX(), 2};
    DesignRun run(request, {}, {});
    Result<MoldStates> states = MoldStates::create(*part, run);
    ASSERT_TRUE(states);
    EXPECT_EQ(states->leastToFill().state.plane, *request.plane);
    EXPECT_TRUE(states->next());
    EXPECT_FALSE(states->next());
}
