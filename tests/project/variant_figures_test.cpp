// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/variant_figures.h"

#include "mesh/measures.h"
#include "mold/mold.h"
#include "project/edits.h"
#include "project/some_project.h"
#include "project/variants.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;

namespace {

/// A project whose cast is the part as it lies, made larger by a factor about the origin.
Project enlarged(double factor) {
    Project project = someProject();
    CastResult cast = *project.cast;
    project = withPart(project, "x", "x.stl", cast.mesh, {});
    cast.before = cast.mesh->V;
    cast.mesh = std::make_shared<const IndexedMesh>(IndexedMesh{factor * cast.mesh->V, cast.mesh->F});
    cast.state.plane.offset *= factor;
    cast.steps = 12;
    project.cast = std::make_shared<const CastResult>(cast);
    return project;
}

} // namespace

TEST(VariantFigures, AreKnownOfACastThatIsThePartMadeLarger) {
    const Project project = enlarged(1.5);
    const VariantFigures figures = variantFigures(*project.part, project);
    EXPECT_NEAR(figures.strain.value(), std::sqrt(2.0) * 0.5, 1e-9);
    EXPECT_GT(figures.rmsDistance.value(), 0);
    EXPECT_DOUBLE_EQ(figures.largestDistance, 0.02 * diagonal(*project.part));
    EXPECT_DOUBLE_EQ(figures.filledVolume, 0.03 * volume(*project.part));
    EXPECT_EQ(figures.steps, 12);
}

TEST(VariantFigures, BlockIsThatOfTheMold) {
    Project project = someProject();
    project.mold.keys.count = 0; // keys stand out of the block
    const VariantFigures figures = variantFigures(*project.part, project);
    EXPECT_TRUE(figures.castable);
    EXPECT_GE(figures.worstDraftDegrees, 2.5);
    const CastResult& cast = *project.cast;
    const Mold mold = buildMold(trayOf(project, project.name), cast.draftDegrees, project.mold).value();
    const Eigen::Vector3d size = mold.half1.size + Eigen::Vector3d(0, 0, mold.half2.size.z());
    EXPECT_LT((figures.blockSize.value() - size).norm(), 1e-9);
}

TEST(VariantFigures, OfAShapeThatIsNotCastableHaveNoBlock) {
    Project project = someProject();
    CastResult cast = *project.cast;
    for (auto& label : cast.labels)
        label = 1;
    project.cast = std::make_shared<const CastResult>(cast);
    const VariantFigures figures = variantFigures(*project.part, project);
    EXPECT_FALSE(figures.castable);
    EXPECT_FALSE(figures.blockSize.has_value());
}

TEST(VariantFigures, OfFilesOfOldLackWhatTheyDoNotTell) {
    Project project = someProject();
    CastResult cast = *project.cast;
    cast.before = Points();
    project.cast = std::make_shared<const CastResult>(cast);
    const VariantFigures figures = variantFigures(*project.part, project);
    EXPECT_FALSE(figures.strain || figures.rmsDistance);
    EXPECT_TRUE(figures.castable);
}
