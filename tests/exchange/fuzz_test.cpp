// SPDX-License-Identifier: AGPL-3.0-or-later
// Damaged files of every format, in this process: each is either a sound mesh or a sentence, and soon.
#include "exchange/mesh_file.h"
#include "exchange/mesh_readers.h"
#include "exchange/polygon_soup.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <random>
#include <sstream>

using namespace moldwright;

namespace {

struct Format {
    const char* name;
    MeshFormat format;
};

std::string sampleBytes(const Format& format) {
    const test::ScratchFolder folder;
    const auto file = folder.path() / format.name;
    EXPECT_TRUE(writeMesh(file, test::sphere({0.1, 0.2, 0.3}, 1, 1), format.format));
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

void expectMeshOrSentence(const std::string& bytes, const char* name) {
    const auto read = readMeshBytes(bytes, name);
    if (!read) {
        ASSERT_EQ(read.error().code, ErrorCode::BadInput);
        ASSERT_NE(read.error().english().find(name), std::string::npos);
        return;
    }
    ASSERT_GT(read->mesh.faceCount(), 0);
    ASSERT_TRUE(read->mesh.V.allFinite());
    ASSERT_GE(read->mesh.F.minCoeff(), 0);
    ASSERT_LT(read->mesh.F.maxCoeff(), read->mesh.vertexCount());
}

class DamagedFile : public testing::TestWithParam<Format> {};

} // namespace

TEST_P(DamagedFile, CutOffAnywhere) {
    const std::string whole = sampleBytes(GetParam());
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 800)
        expectMeshOrSentence(whole.substr(0, size), GetParam().name);
}

TEST_P(DamagedFile, WithWrongBits) {
    const std::string whole = sampleBytes(GetParam());
    std::mt19937 random(11);
    for (int round = 0; round < 2000; ++round) {
        std::string damaged = whole;
        for (unsigned flips = 1 + random() % 8; flips > 0; --flips)
            damaged[random() % damaged.size()] ^= static_cast<char>(1U << random() % 8);
        expectMeshOrSentence(damaged, GetParam().name);
    }
}

TEST_P(DamagedFile, WithPiecesMovedAndRepeated) {
    const std::string whole = sampleBytes(GetParam());
    std::mt19937 random(13);
    for (int round = 0; round < 1000; ++round) {
        std::string damaged = whole;
        const std::size_t from = random() % whole.size();
        const std::string piece = whole.substr(from, 1 + random() % 200);
        damaged.replace(random() % damaged.size(), random() % 100, piece);
        expectMeshOrSentence(damaged, GetParam().name);
    }
}

INSTANTIATE_TEST_SUITE_P(Exchange, DamagedFile,
                         testing::Values(Format{"part.stl", MeshFormat::StlBinary},
                                         Format{"text.stl", MeshFormat::StlAscii},
                                         Format{"part.obj", MeshFormat::Obj},
                                         Format{"part.ply", MeshFormat::Ply},
                                         Format{"part.off", MeshFormat::Off}));

#ifdef __SANITIZE_ADDRESS__
constexpr int kPatience = 100; ///< seconds: sanitizers cost a factor
#else
constexpr int kPatience = 10;
#endif

TEST(HostileFile, HugeFacesTakeNoHugeTime) {
    // A megabyte of faces with as many corners as are allowed, along a comb that is all ears and hollows.
    std::string obj;
    for (int i = 0; i < mostCorners; ++i)
        obj += "v " + std::to_string(i) + ' ' + std::to_string(i % 2 == 0 ? 0 : i) + " 0\n";
    for (int face = 0; face < 80; ++face) {
        obj += 'f';
        for (int i = 1; i <= mostCorners; ++i)
            obj += ' ' + std::to_string(i);
        obj += '\n';
    }
    const auto start = std::chrono::steady_clock::now();
    expectMeshOrSentence(obj, "comb.obj");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(kPatience));
}
