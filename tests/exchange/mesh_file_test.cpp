// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_file.h"

#include "exchange/mesh_readers.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace moldwright;

namespace {

IndexedMesh writtenAndRead(const IndexedMesh& mesh, const std::string& name, MeshFormat format) {
    const test::ScratchFolder folder;
    const auto written = writeMesh(folder.path() / name, mesh, format);
    EXPECT_TRUE(written) << written.error().english();
    const auto read = readMesh(folder.path() / name);
    EXPECT_TRUE(read) << read.error().english();
    return read ? read->mesh : IndexedMesh{};
}

/// An irregular shape whose coordinates no short decimal spells.
IndexedMesh oddShape() {
    return test::rotated(test::sphere({1.0 / 3, -2e-7, 1e5}, 7, 2), Eigen::Vector3d(1, 2, 3).normalized(),
                         0.7);
}

} // namespace

class LosslessFormat : public testing::TestWithParam<std::pair<const char*, MeshFormat>> {};

TEST_P(LosslessFormat, ReadsBackToTheBit) {
    const IndexedMesh mesh = oddShape();
    const IndexedMesh back = writtenAndRead(mesh, GetParam().first, GetParam().second);
    EXPECT_EQ(back.V, mesh.V);
    EXPECT_EQ(back.F, mesh.F);
}

INSTANTIATE_TEST_SUITE_P(MeshFile, LosslessFormat,
                         testing::Values(std::pair{"a.ply", MeshFormat::Ply},
                                         std::pair{"a.obj", MeshFormat::Obj},
                                         std::pair{"a.off", MeshFormat::Off},
                                         std::pair{"деталь 模型 (1).ply", MeshFormat::Ply}));

TEST(MeshFile, StlReadsBackAsItsRoundedCorners) {
    const IndexedMesh mesh = roundToFloat(test::sphere({1.0 / 3, 0.1, 0.7}, 7, 2));
    for (const MeshFormat format : {MeshFormat::StlBinary, MeshFormat::StlAscii}) {
        const IndexedMesh back = writtenAndRead(mesh, "a.stl", format);
        ASSERT_EQ(back.vertexCount(), mesh.vertexCount());
        ASSERT_EQ(back.faceCount(), mesh.faceCount());
        for (int f = 0; f < mesh.faceCount(); ++f)
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(back.corner(f, k), mesh.corner(f, k));
    }
}

TEST(MeshFile, AMissingFileIsNamed) {
    const auto read = readMesh("/nowhere/part.stl");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::BadInput);
    EXPECT_EQ(read.error().english(), "There is no file /nowhere/part.stl.");
}

TEST(MeshFile, AVertexOutsideAnyFacetIsRefused) {
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                              "endloop\nendfacet\n";
    const Result<ReadMesh> read =
        readMeshBytes("solid s\n" + facet + "vertex 5 5 5\n" + facet + "endsolid\n", "s.stl");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().english().find("line 9"), std::string::npos) << read.error().english();
}

TEST(MeshFile, SidesAreWrittenBesideTheFaces) {
    const test::ScratchFolder folder;
    const IndexedMesh mesh = oddShape();
    std::vector<std::uint8_t> sides(static_cast<std::size_t>(mesh.faceCount()), 2);
    sides.front() = 1;
    ASSERT_TRUE(writeSidedMesh(folder.path() / "a.ply", mesh, sides));
    const auto read = readMesh(folder.path() / "a.ply");
    ASSERT_TRUE(read) << read.error().english();
    EXPECT_EQ(read->mesh.V, mesh.V);
    EXPECT_EQ(read->mesh.F, mesh.F);
    std::ostringstream bytes;
    bytes << std::ifstream(folder.path() / "a.ply", std::ios::binary).rdbuf();
    const std::string faces = bytes.str().substr(bytes.str().size() - 14 * sides.size());
    for (std::size_t f = 0; f < sides.size(); ++f)
        EXPECT_EQ(faces[14 * f + 13], sides[f]);
}

TEST(MeshFile, ACancelledReadAnswersCancelled) {
    const test::ScratchFolder folder;
    ASSERT_TRUE(writeMesh(folder.path() / "a.ply", oddShape(), MeshFormat::Ply));
    const Task task;
    task.cancel();
    const auto read = readMesh(folder.path() / "a.ply", task);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::Cancelled);
}
