// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/finish_region.h"

#include "deformation/labelled_shapes.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

std::vector<char> oneFace(const LabelledSurface& surface) {
    std::vector<char> faces(surface.labels.size(), 0);
    faces[5] = 1;
    return faces;
}

} // namespace

TEST(FinishRegion, HoldsTheWholeSurfaceWhenAskedFor) {
    const LabelledSurface ball = test::labelledBall(3);
    const FinishRegion region = wholeRegion(ball, {});
    EXPECT_EQ(region.faces.size(), ball.labels.size());
    EXPECT_EQ(region.body.labels, ball.labels);
    EXPECT_EQ(std::count(region.body.fixed.begin(), region.body.fixed.end(), 1), 0);
    for (int f = 0; f < ball.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(region.points[static_cast<std::size_t>(region.body.shape.F(f, k))], ball.mesh.F(f, k));
}

TEST(FinishRegion, GrowsRingByRingAndFixesItsRim) {
    const LabelledSurface ball = test::labelledBall(4);
    const FinishRegion near = regionAround(ball, oneFace(ball), 1, {});
    const FinishRegion far = regionAround(ball, oneFace(ball), 4, {});
    EXPECT_NEAR(static_cast<double>(near.faces.size()), 13, 2) << "a face and those that touch it";
    EXPECT_GT(far.faces.size(), 4 * near.faces.size());
    std::vector<char> inside(ball.labels.size(), 0);
    for (const int f : far.faces)
        inside[static_cast<std::size_t>(f)] = 1;
    for (std::size_t i = 0; i < far.points.size(); ++i) {
        bool touchesBeyond = false;
        for (int f = 0; f < ball.mesh.faceCount(); ++f)
            for (int k = 0; k < 3; ++k)
                touchesBeyond = touchesBeyond ||
                                (ball.mesh.F(f, k) == far.points[i] && !inside[static_cast<std::size_t>(f)]);
        EXPECT_EQ(far.body.fixed[i] != 0, touchesBeyond);
        EXPECT_EQ(far.body.shape.V.row(static_cast<Eigen::Index>(i)), ball.mesh.V.row(far.points[i]));
    }
}

TEST(FinishRegion, AFaceIsAsImportantAsTheLeastOfItsCorners) {
    LabelledSurface ball = test::labelledBall(3);
    // A clean-up has taken points out since importance was given.
    for (int& source : ball.sourceVertex)
        source += 5;
    std::vector<double> importance(ball.sourceVertex.size() + 5, 1);
    for (int v = 0; v < ball.mesh.vertexCount(); ++v)
        if (ball.mesh.V(v, 0) > 0)
            importance[static_cast<std::size_t>(v) + 5] = 16;
    const FinishRegion region = wholeRegion(ball, {}, importance);
    ASSERT_EQ(region.body.shape.faceWeights.size(), region.faces.size());
    for (int f = 0; f < ball.mesh.faceCount(); ++f) {
        const double least =
            std::min({ball.mesh.corner(f, 0).x(), ball.mesh.corner(f, 1).x(), ball.mesh.corner(f, 2).x()});
        EXPECT_EQ(region.body.shape.faceWeights[static_cast<std::size_t>(f)], least > 0 ? 16 : 1);
    }
    EXPECT_TRUE(wholeRegion(ball, {}).body.shape.faceWeights.empty());
}

TEST(FinishRegion, KnowsTheWholePartingLine) {
    const LabelledSurface ball = test::labelledBall(4);
    const FinishRegion region = regionAround(ball, oneFace(ball), 2, {});
    const FinishRegion whole = wholeRegion(ball, {});
    EXPECT_EQ(region.body.line.size(), whole.body.line.size());
    for (const auto& edge : region.body.line)
        for (const int v : edge) {
            EXPECT_EQ(region.body.shape.V(v, 2), 0);
            EXPECT_TRUE(region.body.held[static_cast<std::size_t>(v)]);
        }
}

TEST(FinishRegion, MovesNothingOfItsRim) {
    LabelledSurface ball = test::labelledBall(4);
    for (int v = 0; v < ball.mesh.vertexCount(); ++v) // undercut on both sides
        ball.mesh.V.row(v).head<2>() *= 1 + std::abs(ball.mesh.V(v, 2));
    const FinishRegion region = regionAround(ball, oneFace(ball), 5, {});
    StageWeights weights;
    weights.elastic = 1e-3;
    weights.tau = 0.1;
    LabelledProblem problem(region.body);
    const std::vector<double> areas(region.faces.size(), 1.0);
    const Positions X =
        problem.minimize(weights, areas, region.body.shape.V, [](const Positions&) { return true; });
    int moved = 0;
    for (std::size_t i = 0; i < region.points.size(); ++i) {
        const auto v = static_cast<Eigen::Index>(i);
        if (region.body.fixed[i])
            EXPECT_EQ(X.row(v), region.body.shape.V.row(v));
        else
            moved += X.row(v) != region.body.shape.V.row(v);
    }
    EXPECT_GT(moved, 10);
}
