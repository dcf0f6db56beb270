// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/parting_line.h"
#include "design/face_origins.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

/// A ball of the part's faces, split along z = 0, each point moved.
struct Bent {
    SharedMesh part = std::make_shared<const IndexedMesh>(test::sphere({0.1, 0.2, 0.03}, 10, 3));
    PartedMesh parted = insertPartingLine(*part, 0);
    SharedMesh shape;
    std::shared_ptr<const Points> before = std::make_shared<const Points>(parted.mesh.V);

    Bent() {
        IndexedMesh bent = parted.mesh;
        for (int v = 0; v < bent.vertexCount(); ++v)
            bent.V.row(v) << 2 * bent.V(v, 0), bent.V(v, 1) + 0.1 * bent.V(v, 0) * bent.V(v, 0),
                -bent.V(v, 2);
        shape = std::make_shared<const IndexedMesh>(bent);
    }
    [[nodiscard]] Eigen::Vector3d middle(const Points& V, int f) const {
        const Eigen::RowVector3i c = shape->F.row(f);
        return (V.row(c[0]) + V.row(c[1]) + V.row(c[2])).transpose() / 3;
    }
};

} // namespace

TEST(FaceOrigins, AreTheFacesThatPartingSplit) {
    const Bent bent;
    const FaceOrigins origins(bent.part, bent.shape, bent.before);
    ASSERT_GT(bent.shape->faceCount(), bent.part->faceCount());
    EXPECT_EQ(origins.faces(), bent.parted.sourceFace);
    for (int f = 0; f < bent.part->faceCount(); f += 37) {
        const int shown = origins.faceFrom(f);
        ASSERT_GE(shown, 0);
        EXPECT_EQ(origins.faces()[static_cast<std::size_t>(shown)], f);
    }
    const std::vector<int> all = origins.onPart({0, 1, 2, bent.shape->faceCount() - 1});
    EXPECT_TRUE(std::ranges::is_sorted(all));
    EXPECT_EQ(origins.faceFrom(bent.part->faceCount()), -1);
}

TEST(FaceOrigins, APlaceGoesBackToWhereItWas) {
    const Bent bent;
    const FaceOrigins origins(bent.part, bent.shape, bent.before);
    for (int f = 0; f < bent.shape->faceCount(); f += 53) {
        const auto place = origins.onPart(*bent.shape, {f, bent.middle(bent.shape->V, f)});
        ASSERT_TRUE(place);
        EXPECT_EQ(place->face, bent.parted.sourceFace[static_cast<std::size_t>(f)]);
        EXPECT_LT((place->point - bent.middle(*bent.before, f)).norm(), 1e-9);
    }
}

TEST(FaceOrigins, WhatFillingMadeIsFromNowhere) {
    Bent bent;
    Points before = *bent.before;
    const Eigen::RowVector3i c = bent.shape->F.row(5);
    for (int k = 0; k < 3; ++k)
        before.row(c[k]) *= 0.5; // inside the ball
    const FaceOrigins origins(bent.part, bent.shape, std::make_shared<const Points>(before));
    EXPECT_EQ(origins.faces()[5], -1);
    EXPECT_FALSE(origins.onPart(*bent.shape, {5, bent.middle(bent.shape->V, 5)}));
    EXPECT_TRUE(origins.onPart({5}).empty());
}

TEST(FaceOrigins, HoldForEveryFrameOfARun) {
    const Bent bent;
    const FaceOrigins origins(bent.part, bent.shape, bent.before);
    IndexedMesh later = *bent.shape;
    later.V *= 1.1;
    EXPECT_TRUE(origins.areOf(bent.part, later, *bent.before));
    EXPECT_FALSE(origins.areOf(bent.part, later, later.V)) << "its points were elsewhere";
    EXPECT_FALSE(origins.areOf(bent.shape, later, *bent.before)) << "another part";
    later.F.row(0).reverseInPlace();
    EXPECT_FALSE(origins.areOf(bent.part, later, *bent.before)) << "other faces";
}
