// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/proxy.h"

#include "castability/parting_curves.h"
#include "castability/topology.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <set>

using namespace moldwright;

namespace {

/// A ball of 32,768 faces with a dent all round above its middle: bending has to open it.
IndexedMesh dentedBall() {
    IndexedMesh mesh = test::sphere({0, 0, 0}, 10, 6);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double z = mesh.V(v, 2);
        mesh.V.row(v).head<2>() *= 1 - 0.15 * std::exp(-(z - 2) * (z - 2));
    }
    return mesh;
}

const PartedPart& part() {
    static const PartedPart parted = *partSurface(dentedBall(), {}, {});
    return parted;
}

std::set<std::array<double, 2>> lineOf(const PartedMesh& surface) {
    std::set<std::array<double, 2>> points;
    for (int v = 0; v < surface.mesh.vertexCount(); ++v)
        if (surface.mesh.V(v, 2) == 0)
            points.insert({surface.mesh.V(v, 0), surface.mesh.V(v, 1)});
    return points;
}

} // namespace

TEST(Proxy, IsCoarseAndHasThePartingLineOfThePart) {
    const std::optional<Proxy> proxy = proxyOf(part(), ProxyDetail::Quick, {}, {});
    ASSERT_TRUE(proxy);
    const PartedMesh& surface = proxy->solid.surface;
    EXPECT_LT(surface.mesh.faceCount(), part().surface.mesh.faceCount() / 2);
    EXPECT_TRUE(diagnose(surface.mesh).usable());
    EXPECT_TRUE(topologyAllowsCasting(surface.mesh, surface.labels));
    EXPECT_EQ(lineOf(surface), lineOf(part().surface));
    for (int f = 0; f < surface.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            EXPECT_GE(surface.mesh.corner(f, k).z() *
                          (surface.labels[static_cast<std::size_t>(f)] == 1 ? 1 : -1),
                      0);
    EXPECT_EQ(proxy->solid.tets.V.topRows(surface.mesh.vertexCount()), surface.mesh.V);
}

TEST(Proxy, KeepsImportantFacesAsTheyAre) {
    std::vector<double> weights(static_cast<std::size_t>(dentedBall().faceCount()), 1);
    for (std::size_t f = 100; f < 140; ++f)
        weights[f] = 8;
    const std::optional<Proxy> proxy = proxyOf(part(), ProxyDetail::Quick, weights, {});
    ASSERT_TRUE(proxy);
    const PartedMesh& fine = part().surface;
    int important = 0;
    for (int f = 0; f < fine.mesh.faceCount(); ++f) {
        if (const int source = fine.sourceFace[static_cast<std::size_t>(f)]; source < 100 || source >= 140)
            continue;
        ++important;
        for (int k = 0; k < 3; ++k) {
            const int now = proxy->pointNow[static_cast<std::size_t>(fine.mesh.F(f, k))];
            EXPECT_EQ(proxy->solid.surface.mesh.point(now), fine.mesh.corner(f, k));
        }
    }
    EXPECT_GE(important, 40);
}

TEST(Proxy, IsNotMadeOfAPartThatIsCoarseItself) {
    EXPECT_FALSE(proxyOf(*partSurface(test::sphere({0, 0, 0}, 10, 3), {}, {}), ProxyDetail::Quick, {}, {}));
}

TEST(Proxy, BringsThePartNearItsDraftOnTheRightSides) {
    const std::optional<Proxy> proxy = proxyOf(part(), ProxyDetail::Quick, {}, {});
    ASSERT_TRUE(proxy);
    const ShapeGoal goal{1, {}, {}};
    int frames = 0;
    const BentShape bent =
        bendByProxy(part(), *proxy, goal, {}, [&](const char* stage, const LabelledSurface& surface) {
            EXPECT_STREQ(stage, "deformation");
            EXPECT_EQ(surface.mesh.faceCount(), part().surface.mesh.faceCount());
            ++frames;
        });
    EXPECT_GT(frames, 3);
    EXPECT_EQ(bent.surface.labels, part().surface.labels);
    for (int v = 0; v < bent.surface.mesh.vertexCount(); ++v) {
        const double before = part().surface.mesh.V(v, 2);
        const double now = bent.surface.mesh.V(v, 2);
        EXPECT_EQ(before == 0, now == 0);
        EXPECT_GE(before * now, 0);
    }
    const auto curves = partingCurves(bent.surface.mesh, bent.surface.labels);
    ASSERT_TRUE(curves);
    EXPECT_TRUE(nestingAlong(bent.surface.mesh.V, *curves, Eigen::Vector3d::UnitZ()).simple);
    BentShape finished = bent;
    EXPECT_TRUE(finish(finished, part(), goal, 1e-7, {}, {}));
    EXPECT_GT(finished.surface.mesh.faceCount(), part().surface.mesh.faceCount() * 95 / 100)
        << "detail is kept";
}
