// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/surface_samples.h"

#include "mesh/measures.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace moldwright {

namespace {

constexpr int kMostPoints = 15000;
constexpr double kLeastDensity = 4000; ///< samples on the whole surface, evenly spread

/// Uniform in [0, 1), by plain arithmetic: the library's distributions differ from one to the next.
double uniform(std::mt19937& random) {
    return static_cast<double>(random()) / 4294967296.0;
}

/// Collects samples, each with a frame of its own face, in which it is moved.
class Samples {
public:
    Samples(const IndexedMesh& mesh, double jitter, unsigned seed)
        : m_mesh(mesh), m_jitter(jitter), m_random(seed) {}

    void add(const Eigen::Vector3d& p, int f) {
        const Eigen::Vector3d x = (m_mesh.corner(f, 1) - m_mesh.corner(f, 0)).normalized();
        const Eigen::Vector3d z = doubleAreaVector(m_mesh, f).normalized();
        const Eigen::Vector3d shift = offset() * x + offset() * z + offset() * z.cross(x);
        m_points.push_back(p + m_jitter * shift);
    }

    [[nodiscard]] double random() { return uniform(m_random); }

    [[nodiscard]] Points points() const {
        Points points(static_cast<Eigen::Index>(m_points.size()), 3);
        for (std::size_t i = 0; i < m_points.size(); ++i)
            points.row(static_cast<Eigen::Index>(i)) = m_points[i].transpose();
        return points;
    }

private:
    double offset() { return (2 * random() - 1) / std::numbers::sqrt3; }

    const IndexedMesh& m_mesh;
    double m_jitter;
    std::mt19937 m_random;
    std::vector<Eigen::Vector3d> m_points;
};

void addOwnPoints(const IndexedMesh& mesh, Samples& samples) {
    std::vector<char> done(static_cast<std::size_t>(mesh.vertexCount()), 0);
    const double share = static_cast<double>(kMostPoints) / mesh.vertexCount();
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (char& taken = done[static_cast<std::size_t>(mesh.F(f, k))]; !taken) {
                taken = 1;
                if (share >= 1 || samples.random() < share)
                    samples.add(mesh.corner(f, k), f);
            }
}

/// Points on edges longer than the distance of samples that lie as densely as wanted: sharp ones would be cut
/// off without.
void addOnEdges(const IndexedMesh& mesh, Samples& samples) {
    const double spacing = std::sqrt(surfaceArea(mesh) / kLeastDensity);
    for (int f = 0; f < mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            if (mesh.F(f, k) > mesh.F(f, next))
                continue; // the face across has it
            const Eigen::Vector3d a = mesh.corner(f, k);
            const Eigen::Vector3d b = mesh.corner(f, next);
            const int pieces = static_cast<int>((b - a).norm() / spacing);
            for (int i = 1; i < pieces; ++i)
                samples.add(a + static_cast<double>(i) / pieces * (b - a), f);
        }
}

/// Points in faces that have fewer corners to their name than their area asks for, spread by a sequence of
/// low discrepancy: 1/φ and 1/φ², φ the root of φ³ = φ + 1.
void addInFaces(const IndexedMesh& mesh, Samples& samples) {
    constexpr double phi = 1.32471795724474602596;
    const double density = kLeastDensity / surfaceArea(mesh);
    double owed = 0;
    int n = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const double wanted = density * doubleAreaVector(mesh, f).norm() / 2;
        owed += std::max(0.0, wanted - 0.5); // a point has six faces about it, a face three points
        for (; owed >= 1; --owed) {
            ++n;
            double s = std::fmod(n / phi, 1.0);
            double t = std::fmod(n / (phi * phi), 1.0);
            if (s + t > 1) {
                s = 1 - s;
                t = 1 - t;
            }
            samples.add((1 - s - t) * mesh.corner(f, 0) + s * mesh.corner(f, 1) + t * mesh.corner(f, 2), f);
        }
    }
}

} // namespace

Points surfaceSamples(const IndexedMesh& mesh, double jitter, unsigned seed) {
    Samples samples(mesh, jitter, seed);
    addOwnPoints(mesh, samples);
    addOnEdges(mesh, samples);
    addInFaces(mesh, samples);
    return samples.points();
}

} // namespace moldwright
