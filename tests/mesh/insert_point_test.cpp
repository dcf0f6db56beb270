// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/insert_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <map>
#include <random>
#include <vector>

using namespace moldwright;

namespace {

/// The unit cube in n×n×n cells of six tetrahedra each about the cell's diagonal.
TetMesh cube(int n) {
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    TetMesh tets;
    const auto at = [&](const std::array<int, 3>& c) { return (c[0] * (n + 1) + c[1]) * (n + 1) + c[2]; };
    tets.V.resize((n + 1) * (n + 1) * (n + 1), 3);
    std::vector<std::array<int, 4>> rows;
    for (int x = 0; x <= n; ++x)
        for (int y = 0; y <= n; ++y)
            for (int z = 0; z <= n; ++z) {
                tets.V.row(at({x, y, z})) = Eigen::RowVector3d(x, y, z) / n;
                for (int o = 0; o < 6 && x < n && y < n && z < n; ++o) {
                    std::array<int, 3> corner = {x, y, z};
                    std::array<int, 4> row{at(corner)};
                    for (std::size_t k = 0; k < 3; ++k) {
                        ++corner[static_cast<std::size_t>(orders[o][k])];
                        row[k + 1] = at(corner);
                    }
                    if (o >= 3)
                        std::swap(row[2], row[3]);
                    rows.push_back(row);
                }
            }
    tets.T.resize(static_cast<Eigen::Index>(rows.size()), 4);
    for (std::size_t t = 0; t < rows.size(); ++t)
        for (int k = 0; k < 4; ++k)
            tets.T(static_cast<Eigen::Index>(t), k) = rows[t][static_cast<std::size_t>(k)];
    return tets;
}

double volumeOf(const TetMesh& tets, int t) {
    const Eigen::RowVector3d a = tets.V.row(tets.T(t, 0));
    const Eigen::RowVector3d b = tets.V.row(tets.T(t, 1)) - a;
    const Eigen::RowVector3d c = tets.V.row(tets.T(t, 2)) - a;
    const Eigen::RowVector3d d = tets.V.row(tets.T(t, 3)) - a;
    return b.dot(c.cross(d)) / 6;
}

/// Faces that one tetrahedron alone has.
int boundaryFaces(const TetMesh& tets) {
    std::map<std::array<int, 3>, int> count;
    for (int t = 0; t < tets.T.rows(); ++t)
        for (int k = 0; k < 4; ++k) {
            std::array<int, 3> face{};
            for (std::size_t i = 0; i < 3; ++i)
                face[i] = tets.T(t, (k + 1 + static_cast<int>(i)) % 4);
            std::sort(face.begin(), face.end());
            ++count[face];
        }
    int alone = 0;
    for (const auto& [face, times] : count) {
        EXPECT_LE(times, 2);
        alone += times == 1;
    }
    return alone;
}

void expectSound(const TetMesh& tets, int n) {
    double sum = 0;
    for (int t = 0; t < tets.T.rows(); ++t) {
        EXPECT_GT(volumeOf(tets, t), 0) << t;
        sum += volumeOf(tets, t);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(boundaryFaces(tets), 12 * n * n);
}

} // namespace

TEST(InsertPoint, TheCubeOfTheTestIsSound) {
    expectSound(cube(3), 3);
}

TEST(InsertPoint, AnyPointInsideBecomesOneOfTheMesh) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(0.02, 0.98);
    TetMesh tets = cube(3);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d point(coordinate(random), coordinate(random), coordinate(random));
        const auto before = tets.V.rows();
        ASSERT_TRUE(insertPoint(tets, point)) << point.transpose();
        ASSERT_EQ(tets.V.rows(), before + 1);
        EXPECT_EQ(tets.V.row(before), point.transpose());
        EXPECT_TRUE((tets.T.array() == static_cast<int>(before)).any());
    }
    expectSound(tets, 3);
}

TEST(InsertPoint, OnAFaceOrAnEdgeTheNeighboursGiveWayToo) {
    for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.5, 0.5, 0.4), Eigen::Vector3d(0.5, 0.5, 0.5),
                                         Eigen::Vector3d(1 / 3.0 + 1e-9, 0.5, 0.45)}) {
        TetMesh tets = cube(3);
        ASSERT_TRUE(insertPoint(tets, point)) << point.transpose();
        expectSound(tets, 3);
        for (int t = 0; t < tets.T.rows(); ++t)
            EXPECT_GT(volumeOf(tets, t), 1e-6);
    }
}

TEST(InsertPoint, OutsideNothingIsChanged) {
    TetMesh tets = cube(2);
    EXPECT_FALSE(insertPoint(tets, {1.5, 0.5, 0.5}));
    EXPECT_FALSE(insertPoint(tets, {1 - 1e-12, 0.5, 0.5})) << "all but on the surface";
    EXPECT_EQ(tets.V.rows(), 27);
    expectSound(tets, 2);
}
