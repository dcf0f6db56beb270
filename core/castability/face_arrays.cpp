// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiled with -O3, so that the loops over lanes become vector code.
#include "castability/face_arrays.h"

#include "base/parallel.h"
#include "base/vector_code.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr int L = FaceArrays::kLanes;
constexpr std::size_t kGrain = 256; ///< batches

/// Normals and areas from the corners; both 0 for a face without area.
[[gnu::always_inline]] inline void measure(FaceArrays::Batch& batch) {
    const auto& c = batch.corner;
    for (int l = 0; l < L; ++l) {
        const double ux = c[3][l] - c[0][l], uy = c[4][l] - c[1][l], uz = c[5][l] - c[2][l];
        const double vx = c[6][l] - c[0][l], vy = c[7][l] - c[1][l], vz = c[8][l] - c[2][l];
        const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
        const double length = std::sqrt(x * x + y * y + z * z);
        const double inverse = length > 0 ? 1 / length : 0.0;
        batch.normal[0][l] = x * inverse;
        batch.normal[1][l] = y * inverse;
        batch.normal[2][l] = z * inverse;
        batch.area[l] = length / 2;
    }
}

} // namespace

std::size_t FaceArrays::batchCount(const IndexedMesh& mesh) {
    return static_cast<std::size_t>((mesh.faceCount() + L - 1) / L);
}

void FaceArrays::gather(const IndexedMesh& mesh, std::size_t first, std::span<Batch> batches) {
    const Eigen::Index faces = mesh.F.rows();
    for (std::size_t b = 0; b < batches.size(); ++b)
        for (int l = 0; l < L; ++l) {
            // An idle lane repeats a point: a face without area.
            const auto f = static_cast<Eigen::Index>(first + b) * L + l;
            const int* corners = mesh.F.data() + 3 * std::min(f, faces - 1);
            for (int k = 0; k < 3; ++k) {
                const double* x = mesh.V.data() + 3 * static_cast<Eigen::Index>(corners[f < faces ? k : 0]);
                for (int i = 0; i < 3; ++i)
                    batches[b].corner[3 * k + i][l] = x[i];
            }
        }
    inVectorCode([&] {
        for (Batch& batch : batches)
            measure(batch);
    });
}

FaceArrays::FaceArrays(const IndexedMesh& mesh) : m_batches(batchCount(mesh)) {
    parallelFor(m_batches.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        gather(mesh, begin, std::span(m_batches).subspan(begin, end - begin));
    });
}

double FaceArrays::area() const {
    double sum = 0;
    for (const Batch& batch : m_batches)
        for (const double a : batch.area)
            sum += a;
    return sum;
}

} // namespace moldwright
