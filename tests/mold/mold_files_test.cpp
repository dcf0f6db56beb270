// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/mold_files.h"

#include "mold/drawing.h"

#include "support/casts.h"
#include "support/folders.h"
#include "support/molds.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zip.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

using namespace moldwright;
using namespace moldwright::test;

namespace {

Mold plainMold() {
    const KnownCast cast = moved(frusta(20, 10, 5, 3, 0.1), {1, 2, 3}, 0.5, {1, 2, 3});
    return moldOf(cast, {}).value();
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The model part of a 3MF file.
std::string modelOf(const std::filesystem::path& file) {
    zip_t* archive = zip_open(file.c_str(), ZIP_RDONLY, nullptr);
    if (!archive)
        return {};
    std::string text;
    if (zip_file_t* part = zip_fopen(archive, "3D/3dmodel.model", 0)) {
        char buffer[4096];
        for (zip_int64_t n = 0; (n = zip_fread(part, buffer, sizeof buffer)) > 0;)
            text.append(buffer, static_cast<std::size_t>(n));
        zip_fclose(part);
    }
    zip_discard(archive);
    return text;
}

std::size_t occurrences(const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

} // namespace

TEST(MoldFiles, StlHoldsThePointsThatWereProved) {
    const Mold mold = plainMold();
    const ScratchFolder folder;
    ASSERT_TRUE(writeMold(mold, "box", folder.path() / "out").has_value());
    const std::string bytes = bytesOf(folder.path() / "out" / "mold-half-1.stl");
    std::uint32_t faces = 0;
    ASSERT_GE(bytes.size(), 84U);
    std::memcpy(&faces, bytes.data() + 80, 4);
    ASSERT_EQ(static_cast<int>(faces), mold.half1.mesh->faceCount());
    for (int f = 0; f < mold.half1.mesh->faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            float xyz[3];
            std::memcpy(xyz,
                        bytes.data() + 84 + 50 * static_cast<std::size_t>(f) + 12 +
                            12 * static_cast<std::size_t>(k),
                        12);
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_EQ(static_cast<double>(xyz[axis]), mold.half1.mesh->corner(f, k)[axis]);
        }
}

TEST(MoldFiles, JsonCarriesTheContract) {
    const Mold mold = plainMold();
    const auto json = nlohmann::json::parse(moldJson(mold));
    EXPECT_EQ(json["verified"], true);
    EXPECT_EQ(json["part_to_mold"].size(), 16U);
    EXPECT_EQ(json["part_to_mold"][3], mold.partToMold.matrix()(0, 3));
    EXPECT_EQ(json["part_to_mold"][15], 1);
    for (const char* half : {"half1", "half2"})
        for (const char* key : {"volume", "size", "faces"})
            EXPECT_TRUE(json[half].contains(key)) << half << key;
    EXPECT_EQ(json["half1"]["volume"], mold.half1.volume);
    EXPECT_EQ(json["half2"]["faces"], mold.half2.mesh->faceCount());
    for (const char* key : {"cavity_volume", "channel_volume", "parting_area", "clamp_force", "min_wall"})
        EXPECT_TRUE(json[key].is_number()) << key;
    EXPECT_EQ(json["d2"][2], mold.directions.d2.z());
    EXPECT_EQ(json["features"].size(), 2U);
}

TEST(MoldFiles, ThreeMfHoldsThreeNamedSolidsInMillimetres) {
    const Mold mold = plainMold();
    const ScratchFolder folder;
    ASSERT_TRUE(writeMold(mold, "box", folder.path()).has_value());
    const std::string model = modelOf(folder.path() / "mold.3mf");
    EXPECT_NE(model.find("unit=\"millimeter\""), std::string::npos);
    EXPECT_EQ(occurrences(model, "<object "), 3U);
    EXPECT_EQ(occurrences(model, "<item "), 3U);
    EXPECT_EQ(occurrences(model, "<triangle "),
              static_cast<std::size_t>(mold.half1.mesh->faceCount() + mold.half2.mesh->faceCount() +
                                       mold.cast->faceCount()));
    for (const char* name : {"Mold half 1", "Mold half 2", "Cast"})
        EXPECT_EQ(occurrences(model, "name=\"" + std::string(name) + "\""), 1U) << name;
}

TEST(MoldFiles, OfOneMoldAreTheSameBytesEachTime) {
    const Mold mold = plainMold();
    const ScratchFolder folder;
    ASSERT_TRUE(writeMold(mold, "box", folder.path() / "a"));
    ASSERT_TRUE(writeMold(mold, "box", folder.path() / "b"));
    for (const char* name : {"mold.3mf", "mold.json", "mold-half-1.stl"})
        EXPECT_EQ(bytesOf(folder.path() / "a" / name), bytesOf(folder.path() / "b" / name)) << name;
    const std::string model = modelOf(folder.path() / "a" / "mold.3mf");
    const std::regex id("UUID=\"([0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-9[0-9a-f]{3}-[0-9a-f]{12})\"");
    std::set<std::string> ids;
    for (std::sregex_iterator it(model.begin(), model.end(), id), end; it != end; ++it)
        ids.insert((*it)[1]);
    EXPECT_EQ(ids.size(), 7U) << "three solids, their places and the plate each have their own";
}

TEST(MoldFiles, DrawingsShowThePartingPlaneInMillimetres) {
    const Mold mold = plainMold();
    const Drawing plan = planDrawing(mold);
    ASSERT_EQ(plan.layers.size(), 3U);
    EXPECT_EQ(plan.layers[0].curves.size(), 1U);
    EXPECT_EQ(plan.layers[0].curves[0].size(), 4U) << "the part's rectangle";
    for (const std::size_t half : {1U, 2U})
        EXPECT_EQ(plan.layers[half].curves.size(), 2U) << "the block with a hole";
    EXPECT_EQ(sectionDrawing(mold, 0).layers[2].curves.size(), 1U);
    EXPECT_NE(svgOf(plan).find("mm\""), std::string::npos);
    const std::string dxf = dxfOf(plan);
    EXPECT_EQ(occurrences(dxf, "\nPOLYLINE\n"), 5U);
    EXPECT_NE(dxf.find("$INSUNITS\n70\n4"), std::string::npos);
    const ScratchFolder folder;
    ASSERT_TRUE(writeMold(mold, "box", folder.path(), {true, true, true, true}));
    for (const char* name : {"mold-half-2.obj", "mold-cast.ply", "mold-plan.svg", "mold-section-y.dxf"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
}

TEST(MoldFiles, AFolderThatCannotBeMadeIsNamed) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "file") << "not a folder";
    const Result<void> done = writeMold(plainMold(), "box", folder.path() / "file" / "out");
    ASSERT_FALSE(done.has_value());
    EXPECT_EQ(done.error().code, ErrorCode::WriteFailed);
    EXPECT_NE(done.error().english().find("file/out"), std::string::npos);
}

TEST(MoldFiles, ACancelLeavesNoPieceOfAFile) {
    const Mold mold = plainMold();
    const ScratchFolder folder;
    const Task task;
    task.cancel();
    const Result<void> written = writeMold(mold, "part", folder.path(), {}, task);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Cancelled);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}
