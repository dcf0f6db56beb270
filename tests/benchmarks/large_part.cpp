// SPDX-License-Identifier: AGPL-3.0-or-later
// A part of any number of faces with fine detail, from a coarse one: for measuring how time grows.
#include "exchange/mesh_file.h"
#include "mesh/check.h"
#include "mesh/decimate.h"
#include "mesh/measures.h"
#include "mesh/subdivide.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace moldwright;

namespace {

constexpr int kWaves = 40;
constexpr double kWaveLength = 0.03; ///< of the diagonal; half to one and a half of it occur
constexpr double kHeight = 0.0007;   ///< of the diagonal, rms

struct Wave {
    Eigen::Vector3d number;
    double phase;
};

std::vector<Wave> waves(double diagonal, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Wave> found;
    for (int i = 0; i < kWaves; ++i) {
        const Eigen::Vector3d way =
            Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
        const double length = kWaveLength * diagonal * (0.5 + unit(random));
        found.push_back({2 * std::numbers::pi / length * way, 2 * std::numbers::pi * unit(random)});
    }
    return found;
}

/// Moves every point along its normal by a sum of waves, `height` of the diagonal high (rms).
IndexedMesh roughened(IndexedMesh mesh, double height, unsigned seed) {
    const double size = diagonal(mesh);
    Points normals = Points::Zero(mesh.V.rows(), 3);
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            normals.row(mesh.F(f, k)) += doubleAreaVector(mesh, f).transpose();
    const std::vector<Wave> all = waves(size, seed);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        double sum = 0;
        for (const Wave& wave : all)
            sum += std::sin(wave.number.dot(mesh.point(v)) + wave.phase);
        mesh.V.row(v) += height * size * sum / std::sqrt(kWaves / 2.0) * normals.row(v).normalized();
    }
    return mesh;
}

/// As rough as it can be without crossing itself; no rougher than usual.
IndexedMesh roughened(const IndexedMesh& mesh, unsigned seed) {
    for (double height = kHeight; height > kHeight / 100; height /= 2)
        if (IndexedMesh rough = roughened(mesh, height, seed); selfIntersections(rough).empty())
            return rough;
    return mesh;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fputs("usage: moldwright-large-part IN OUT.ply FACES [SEED]\n", stderr);
        return 2;
    }
    Result<ReadMesh> file = readMesh(argv[1]);
    if (!file) {
        std::fprintf(stderr, "%s\n", file.error().english().c_str());
        return 3;
    }
    IndexedMesh mesh = std::move(file->mesh);
    const int faces = std::stoi(argv[3]);
    while (mesh.faceCount() < faces)
        mesh = subdivide(mesh, 1);
    mesh = decimate(mesh, faces);
    mesh = roughened(mesh, argc > 4 ? static_cast<unsigned>(std::stoul(argv[4])) : 1);
    if (!writeMesh(argv[2], mesh, MeshFormat::Ply)) {
        std::fprintf(stderr, "%s cannot be written\n", argv[2]);
        return 1;
    }
    std::printf("%d faces\n", mesh.faceCount());
    return 0;
}
