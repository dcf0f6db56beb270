// SPDX-License-Identifier: AGPL-3.0-or-later
// Real parts at three planes through their centre, with `--fill none`: what the program calls an obstruction
// is one by the labelled faces that it wrote, and what it does not call one is none.
#include "castability/mold_state.h"
#include "cli/run_program.h"
#include "exchange/mesh_file.h"
#include "mesh/measures.h"
#include "support/folders.h"
#include "support/labelled_pieces.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

using namespace moldwright;
using Json = nlohmann::ordered_json;
using test::PieceVerdict;

namespace {

struct SidedMesh {
    IndexedMesh mesh;
    std::vector<std::uint8_t> sides;
};

/// Reads what `design` writes as parted.ply, byte by byte.
SidedMesh readSided(const std::filesystem::path& file) {
    SidedMesh read;
    std::ifstream in(file, std::ios::binary);
    int vertices = 0;
    int faces = 0;
    for (std::string line; std::getline(in, line) && line != "end_header";) {
        std::istringstream words(line);
        std::string word;
        std::string element;
        words >> word >> element;
        if (word == "element")
            words >> (element == "vertex" ? vertices : faces);
    }
    read.mesh.V.resize(vertices, 3);
    in.read(reinterpret_cast<char*>(read.mesh.V.data()), read.mesh.V.size() * 8);
    read.mesh.F.resize(faces, 3);
    std::array<char, 14> row{};
    for (int f = 0; f < faces && in.read(row.data(), row.size()); ++f) {
        std::memcpy(read.mesh.F.row(f).data(), &row[1], 3 * sizeof(int));
        read.sides.push_back(static_cast<std::uint8_t>(row[13]));
    }
    EXPECT_TRUE(in.good());
    return read;
}

/// Kinds by side, as design.json has them.
using Kinds = std::multiset<std::pair<int, std::string>>;

Kinds judgedKinds(SidedMesh part, const PartingPlane& plane) {
    const Eigen::Isometry3d frame = planeFrame(plane);
    for (int v = 0; v < part.mesh.vertexCount(); ++v)
        part.mesh.V.row(v) = (frame * part.mesh.point(v)).transpose();
    Kinds kinds;
    for (const test::LabelledPiece& piece : test::labelledPieces(part.mesh, part.sides))
        switch (piece.verdict()) {
        case PieceVerdict::Closed:
            kinds.emplace(piece.side, "closed_piece");
            break;
        case PieceVerdict::Handle:
        case PieceVerdict::Arch:
            kinds.emplace(piece.side, "handle");
            break;
        case PieceVerdict::Pocket:
            kinds.emplace(piece.side, "pocket");
            break;
        case PieceVerdict::Free:
            break;
        }
    return kinds;
}

Json jsonIn(const std::filesystem::path& file) {
    std::ifstream in(file);
    return Json::parse(in);
}

class ObstructionModel : public testing::TestWithParam<std::tuple<const char*, int>> {};

} // namespace

TEST_P(ObstructionModel, IsAnswered4OnlyWhereItsLabelledFacesForbidCasting) {
    const auto folder = test::models();
    if (!folder)
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set";
    const auto [name, axis] = GetParam();
    const auto model = readMesh(*folder / name);
    ASSERT_TRUE(model) << model.error().english();
    PartingPlane plane{Eigen::Vector3d::Unit(axis), 0};
    plane.offset = boundingBox(model->mesh).center()[axis];
    const test::ScratchFolder out;
    std::vector<std::string> arguments{"design", *folder / name, "--out", out.path() / "d", "--fill",
                                       "none",   "--time-limit", "1.5",   "--plane"};
    for (const double x : {plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset})
        arguments.push_back(Json(x).dump());
    const test::Run run = test::runProgram(arguments);
    const Json json = jsonIn(out.path() / "d" / "design.json");
    if (run.exitCode != 4) {
        // Castable, not castable, or stopped on the way: nothing was in it.
        EXPECT_TRUE(run.exitCode == 0 || run.exitCode == 1 || run.exitCode == 5) << run.exitCode << run.err;
        EXPECT_TRUE(json["obstructions"].empty());
        EXPECT_FALSE(std::filesystem::exists(out.path() / "d" / "parted.ply"));
        return;
    }
    Kinds told;
    for (const Json& obstruction : json["obstructions"])
        told.emplace(obstruction["side"].get<int>(), obstruction["kind"].get<std::string>());
    EXPECT_FALSE(told.empty());
    const SidedMesh parted = readSided(out.path() / "d" / "parted.ply");
    EXPECT_EQ(told, judgedKinds(parted, plane));
    // The labels are the truth about where faces lie.
    const double rounding = 1e-9 * diagonal(parted.mesh);
    for (int f = 0; f < parted.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            EXPECT_GE(plane.distance(parted.mesh.corner(f, k)) *
                          (parted.sides[static_cast<std::size_t>(f)] == 1 ? 1 : -1),
                      -rounding);
}

INSTANTIATE_TEST_SUITE_P(AxisPlanes, ObstructionModel,
                         testing::Combine(testing::Values("armadillo_5k.ply", "beam.stl", "bunny.stl",
                                                          "cow.ply", "dragon.obj", "fandisk.off",
                                                          "goathead.stl", "lcd_knob.stl", "spot.obj",
                                                          "xy_joint_upper.stl"),
                                          testing::Values(0, 1, 2)),
                         [](const auto& values) {
                             std::string name = std::get<0>(values.param);
                             name.resize(name.find('.'));
                             return name + "_" + "xyz"[std::get<1>(values.param)];
                         });
