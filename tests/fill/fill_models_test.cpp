// SPDX-License-Identifier: AGPL-3.0-or-later
// Real parts, at three planes through their centre each.
#include "castability/parting_line.h"
#include "castability/topology.h"
#include "exchange/mesh_file.h"
#include "fill/fill_plan.h"
#include "filled_checks.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/folders.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moldwright;

namespace {

/// The part with the plane square to an axis through its centre at z = 0, size about 1.
IndexedMesh placed(const IndexedMesh& part, int axis) {
    const auto box = boundingBox(part);
    IndexedMesh mesh = part;
    for (int k = 0; k < 3; ++k)
        mesh.V.col(k) = (part.V.col((axis + 1 + k) % 3).array() - box.center()[(axis + 1 + k) % 3]) /
                        box.diagonal().norm();
    return mesh;
}

constexpr int kAlone = 4; ///< the largest regions, each filled alone

PartedMesh partedWhereFree(const IndexedMesh& mesh) {
    PartedMesh parted;
    for (const double snap : {0.25, 0.02, 0.0}) {
        parted = insertPartingLine(mesh, snap);
        if (selfIntersections(parted.mesh).empty())
            break;
    }
    return parted;
}

} // namespace

TEST(FillModels, EveryModelBecomesSoundAtEveryAxisPlane) {
    if (!test::models())
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set";
    int checked = 0;
    int alone = 0;
    int refused = 0;
    for (const auto& entry : std::filesystem::directory_iterator(*test::models())) {
        const std::string ending = entry.path().extension();
        if (ending == ".md" || ending == ".json")
            continue;
        const auto read = readMesh(entry.path());
        ASSERT_TRUE(read) << entry.path();
        const auto part = prepare(read->mesh, entry.path().filename());
        ASSERT_TRUE(part) << entry.path();
        for (int axis = 0; axis < 3; ++axis) {
            SCOPED_TRACE(entry.path().filename().string() + ", axis " + std::to_string(axis));
            const auto plan = planFill(partedWhereFree(placed(part->mesh, axis)), {});
            ASSERT_TRUE(plan) << plan.error().english();
            test::expectSound(plan->filled, {});
            const auto least = fillChosen(*plan, plan->needed());
            ASSERT_TRUE(least) << least.error().english();
            EXPECT_TRUE(topologyAllowsCasting(least->surface.mesh, least->surface.labels));
            EXPECT_LE(least->volume, plan->filled.volume + 1e-4 * volume(plan->part.mesh));
            const FillPlan parts = divided(*plan, {});
            for (int r = 0; r < std::min(kAlone, static_cast<int>(parts.regions.size())); ++r) {
                ++alone;
                refused += !fillChosen(parts, {r});
            }
            const auto drafted = fillWithDraft(plan->part, {}, 1);
            ASSERT_TRUE(drafted) << drafted.error().english();
            test::expectSound(*drafted, {});
            EXPECT_NEAR(drafted->volume, plan->filled.volume, 1e-4 * volume(plan->part.mesh));
            EXPECT_LE(test::facesShort(*drafted, {}, 1), drafted->surface.mesh.faceCount() / 200 + 10);
            ++checked;
        }
    }
    EXPECT_GT(checked, 10);
    // Where a wall meets the part at a hair's angle the region beside it must be filled too.
    EXPECT_LE(refused, alone / 20) << "of " << alone;
}
