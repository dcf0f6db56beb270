// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/edits.h"

#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace moldwright;
using Eigen::Vector3d;

namespace {

Project opened(double scale = 1) {
    const auto source = std::make_shared<const IndexedMesh>(test::box(Vector3d(0, 0, 0), Vector3d(1, 2, 3)));
    return withPart({}, "Box", "box.stl", source, Unit::Millimetre, scale);
}

} // namespace

TEST(ProjectEdits, APartIsScaledToMillimetres) {
    EXPECT_NEAR(volume(*opened(10).part), 6000, 1e-9);
}

TEST(ProjectEdits, MovingThePartCarriesThePlaneAndDropsTheCast) {
    Project project = withState(opened(10), {{Vector3d::UnitZ(), 15}, {}}, true);
    CastResult cast;
    cast.mesh = project.part;
    cast.state = *project.state;
    project = withCast(project, cast);
    ASSERT_TRUE(castIsCurrent(project));
    const Eigen::Isometry3d turn(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
    const Project turned = withPlacement(project, moved(project.placement, turn));
    EXPECT_FALSE(turned.cast);
    // The plane still halves the box: its middle lies on it.
    EXPECT_NEAR(turned.state->plane.distance(boundingBox(*turned.part).center()), 0, 1e-9);
    EXPECT_NEAR(turned.state->plane.normal.dot(-Vector3d::UnitY()), 1, 1e-12);
    EXPECT_NEAR(turned.state->directions.d1.dot(turned.state->plane.normal), 1, 1e-12);
}

TEST(ProjectEdits, LayFlatPutsTheFaceOnTheGround) {
    const Project project = opened(1);
    const Project flat =
        withPlacement(project, moved(project.placement, layFlat(*project.part, Vector3d::UnitX())));
    const Eigen::AlignedBox3d box = boundingBox(*flat.part);
    EXPECT_NEAR(box.min().z(), 0, 1e-12);
    EXPECT_NEAR(box.sizes().z(), 1, 1e-12);
}

TEST(ProjectEdits, ACastIsOutOfDateOnceThePlaneMoves) {
    Project project = withState(opened(1), {}, true);
    CastResult cast;
    cast.mesh = project.part;
    cast.state = *project.state;
    project = withCast(project, cast);
    MoldState other = *project.state;
    other.plane.offset += 1;
    EXPECT_FALSE(castIsCurrent(withState(project, other, true)));
    DesignSettings stricter = project.design;
    stricter.draftDegrees = 3;
    EXPECT_FALSE(castIsCurrent(withDesign(project, stricter)));
}
