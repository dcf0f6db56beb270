// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/design_request.h"

#include "project/edits.h"
#include "project/some_project.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

Project pinned() {
    Project project = test::someProject();
    project.planeChosenByHand = true;
    project.undercuts.clear();
    return withPins(project, {{{{1, 2, 3}}, "tail"}});
}

} // namespace

TEST(DesignRequest, TakesUpWhatARunTookUp) {
    const Project begun = pinned();
    Project changed = begun;
    changed.design.draftDegrees = 4;
    changed.design.smoothing = 0.4;
    changed.design.followDirections = true;
    changed = withPins(withPlane(changed, {Eigen::Vector3d::UnitX(), 2}, true), {});
    EXPECT_NE(liveSettings(begun), liveSettings(changed));
    const Project after = withLiveSettings(begun, liveSettings(changed));
    EXPECT_EQ(liveSettings(after), liveSettings(changed));
    EXPECT_FALSE(after.cast);
    EXPECT_TRUE(sameButLive(begun, changed));
    EXPECT_EQ(withLiveSettings(begun, liveSettings(begun)).pins, begun.pins) << "with their names";
}

TEST(DesignRequest, OtherThingsAreForTheNextRun) {
    const Project begun = pinned();
    Project other = begun;
    other.design.fill = other.design.fill == FillChoice::Auto ? FillChoice::None : FillChoice::Auto;
    EXPECT_FALSE(sameButLive(begun, other));
    EXPECT_EQ(liveSettings(begun), liveSettings(other));
}
