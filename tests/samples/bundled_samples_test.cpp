// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_file.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "samples.h"

#include "support/folders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <set>

using namespace moldwright;
namespace fs = std::filesystem;

namespace {

nlohmann::json catalogue() {
    std::ifstream in(test::samples() / "samples.json");
    return nlohmann::json::parse(in).at("samples");
}

IndexedMesh bundled(const std::string& file) {
    const auto read = readMesh(test::samples() / file);
    EXPECT_TRUE(read) << (read ? "" : read.error().english());
    return read ? read->mesh : IndexedMesh();
}

/// The smallest angle of each face, degrees, ascending.
std::vector<double> smallestAngles(const IndexedMesh& mesh) {
    std::vector<double> angles;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        double smallest = std::numbers::pi;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d u = mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k);
            const Eigen::Vector3d v = mesh.corner(f, (k + 2) % 3) - mesh.corner(f, k);
            smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
        }
        angles.push_back(smallest * 180 / std::numbers::pi);
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

} // namespace

TEST(BundledSamples, CatalogueAndFolderAgree) {
    std::set<std::string> listed;
    for (const auto& entry : catalogue()) {
        listed.insert(entry.at("file").get<std::string>());
        EXPECT_FALSE(entry.at("title").get<std::string>().empty());
        EXPECT_FALSE(entry.at("description").get<std::string>().empty());
    }
    std::set<std::string> present;
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(test::samples()))
        if (entry.path().extension() == ".ply") {
            present.insert(entry.path().filename().string());
            bytes += entry.file_size();
        }
    EXPECT_EQ(listed, present);
    EXPECT_EQ(listed.size(), samples::allSamples().size());
    EXPECT_LT(bytes, 3'000'000U);
}

TEST(BundledSamples, EachIsOneSolidWithoutHandles) {
    for (const auto& entry : catalogue()) {
        SCOPED_TRACE(entry.at("file"));
        const MeshDiagnosis diagnosis = diagnose(bundled(entry.at("file")));
        EXPECT_TRUE(diagnosis.usable());
        EXPECT_EQ(diagnosis.components, 1);
        EXPECT_EQ(diagnosis.genus, 0);
        EXPECT_TRUE(diagnosis.selfIntersections.empty());
    }
}

TEST(BundledSamples, SizesAreAsTheCatalogueSays) {
    for (const auto& entry : catalogue()) {
        SCOPED_TRACE(entry.at("file"));
        const IndexedMesh mesh = bundled(entry.at("file"));
        const Eigen::Vector3d size = boundingBox(mesh).sizes();
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(size[k], entry.at("size_mm").at(k).get<double>(), 0.051);
        EXPECT_GE(size.maxCoeff(), 30);
        EXPECT_LE(size.maxCoeff(), 110);
        EXPECT_EQ(mesh.faceCount(), entry.at("faces").get<int>());
        EXPECT_GE(mesh.faceCount(), 5'000);
        EXPECT_LE(mesh.faceCount(), 16'000);
    }
}

TEST(BundledSamples, FacesAreWellShaped) {
    for (const auto& entry : catalogue()) {
        SCOPED_TRACE(entry.at("file"));
        const std::vector<double> angles = smallestAngles(bundled(entry.at("file")));
        ASSERT_FALSE(angles.empty());
        EXPECT_GT(angles.front(), 10);
        EXPECT_GT(angles[angles.size() / 1000], 25);
        EXPECT_GT(angles[angles.size() / 2], 45);
    }
}

TEST(BundledSamples, PralineIsFlatBackedAndCastableAsItIs) {
    const IndexedMesh praline = bundled("praline.ply");
    const double threeDegrees = std::sin(3 * std::numbers::pi / 180);
    double back = 0;
    for (int f = 0; f < praline.faceCount(); ++f) {
        const Eigen::Vector3d area = doubleAreaVector(praline, f) / 2;
        const bool onBack =
            praline.corner(f, 0).z() == 0 && praline.corner(f, 1).z() == 0 && praline.corner(f, 2).z() == 0;
        if (onBack)
            back -= area.z();
        else
            EXPECT_GT(area.z(), threeDegrees * area.norm()) << "face " << f;
    }
    EXPECT_EQ(boundingBox(praline).min().z(), 0);
    EXPECT_GT(back, 700);
}

TEST(BundledSamples, GeneratorMakesThePralineAnew) {
    const IndexedMesh made = samples::makeMesh(samples::praline());
    const IndexedMesh praline = bundled("praline.ply");
    ASSERT_EQ(made.vertexCount(), praline.vertexCount());
    ASSERT_EQ(made.faceCount(), praline.faceCount());
    EXPECT_EQ(made.V, praline.V);
    EXPECT_EQ(made.F, praline.F);
}
