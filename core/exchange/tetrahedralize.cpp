// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/tetrahedralize.h"

#include "exchange/wire.h"
#include "exchange/worker_client.h"
#include "mesh/insert_point.h"
#include "mesh/measures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

std::unexpected<Error> wrongAnswer(std::string text, std::vector<std::string> arguments = {}) {
    return failure(ErrorCode::Worker, std::move(text), std::move(arguments));
}

/// Six times the signed volume of tet t.
double sixfoldVolume(const TetMesh& tets, int t) {
    const Eigen::RowVector3d a = tets.V.row(tets.T(t, 0));
    const Eigen::RowVector3d b = tets.V.row(tets.T(t, 1)) - a;
    const Eigen::RowVector3d c = tets.V.row(tets.T(t, 2)) - a;
    const Eigen::RowVector3d d = tets.V.row(tets.T(t, 3)) - a;
    return b.dot(c.cross(d));
}

bool indicesFit(const TetMesh& tets) {
    return tets.T.size() == 0 || (tets.T.minCoeff() >= 0 && tets.T.maxCoeff() < tets.V.rows());
}

bool surfacePointsComeFirst(const TetMesh& tets, const IndexedMesh& surface) {
    return tets.V.rows() >= surface.V.rows() && tets.V.topRows(surface.V.rows()) == surface.V;
}

/// TetGen leaves points that its refinement no longer uses: of those beyond the surface's, the used stay.
void dropUnusedInnerPoints(TetMesh& tets, int surfacePoints) {
    std::vector<char> used(static_cast<std::size_t>(tets.V.rows()), 0);
    for (const int v : tets.T.reshaped())
        used[static_cast<std::size_t>(v)] = 1;
    std::vector<int> newIndex(used.size());
    int kept = 0;
    for (int v = 0; v < tets.V.rows(); ++v)
        if (v < surfacePoints || used[static_cast<std::size_t>(v)]) {
            tets.V.row(kept) = tets.V.row(v);
            newIndex[static_cast<std::size_t>(v)] = kept++;
        }
    tets.V.conservativeResize(kept, Eigen::NoChange);
    tets.T = tets.T.unaryExpr([&](int v) { return newIndex[static_cast<std::size_t>(v)]; }).eval();
}

struct TriangleHash {
    std::size_t operator()(const std::array<int, 3>& t) const {
        std::size_t h = 0;
        for (const int v : t)
            h = h * 0x9E3779B97F4A7C15ULL + static_cast<std::size_t>(v) + (h >> 29);
        return h;
    }
};

/// Surface faces that are a face of exactly one tet, and that tet lies inside; less those with one outside.
int facesKept(const TetMesh& tets, const IndexedMesh& surface) {
    constexpr int outward[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const auto fromSmallest = [](std::array<int, 3> t) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    std::unordered_map<std::array<int, 3>, int, TriangleHash> tetsAt;
    for (int f = 0; f < surface.faceCount(); ++f)
        tetsAt[fromSmallest({surface.F(f, 0), surface.F(f, 1), surface.F(f, 2)})] = 0;
    int inwardSides = 0;
    for (int t = 0; t < tets.T.rows(); ++t)
        for (const auto& side : outward) {
            const int a = tets.T(t, side[0]);
            const int b = tets.T(t, side[1]);
            const int c = tets.T(t, side[2]);
            if (const auto face = tetsAt.find(fromSmallest({a, b, c})); face != tetsAt.end())
                ++face->second;
            inwardSides += static_cast<int>(tetsAt.contains(fromSmallest({a, c, b})));
        }
    const auto kept =
        std::count_if(tetsAt.begin(), tetsAt.end(), [](const auto& f) { return f.second == 1; });
    return static_cast<int>(kept) - inwardSides;
}

/// Turns every tet to positive volume; false when one has none.
bool orient(TetMesh& tets) {
    for (int t = 0; t < tets.T.rows(); ++t) {
        if (sixfoldVolume(tets, t) < 0)
            std::swap(tets.T(t, 2), tets.T(t, 3));
        if (!(sixfoldVolume(tets, t) > 0))
            return false;
    }
    return true;
}

double totalVolume(const TetMesh& tets) {
    double sum = 0;
    for (int t = 0; t < tets.T.rows(); ++t)
        sum += sixfoldVolume(tets, t);
    return sum / 6;
}

Result<TetMesh> checked(TetMesh tets, const IndexedMesh& surface, const Points& inside) {
    if (tets.T.rows() == 0)
        return wrongAnswer(MW_TEXT("exchange", "TetGen found no inside to fill."));
    if (!tets.V.allFinite() || !indicesFit(tets) || !surfacePointsComeFirst(tets, surface))
        return wrongAnswer(MW_TEXT("exchange", "TetGen's answer does not keep the points of the surface."));
    dropUnusedInnerPoints(tets, surface.vertexCount());
    const std::vector<int> inner = innerPoints(tets, surface.vertexCount(), inside);
    if (std::find(inner.begin(), inner.end(), -1) != inner.end())
        return wrongAnswer(MW_TEXT("exchange", "TetGen left out a point inside the surface."));
    if (!orient(tets))
        return wrongAnswer(MW_TEXT("exchange", "TetGen's answer holds a flat tetrahedron."));
    const double goal = volume(surface);
    if (!(std::abs(totalVolume(tets) - goal) <= 1e-6 * std::abs(goal)))
        return wrongAnswer(MW_TEXT("exchange", "TetGen's answer fills {0} of the surface's volume of {1}."),
                           {readable(totalVolume(tets), 8), readable(goal, 8)});
    if (const int lost = surface.faceCount() - facesKept(tets, surface); lost != 0)
        return wrongAnswer(MW_TEXT("exchange", "TetGen split {0} of the {1} faces of the surface."),
                           {std::to_string(lost), std::to_string(surface.faceCount())});
    return tets;
}

Result<TetMesh> askTetGen(const IndexedMesh& surface, const Task& task, const std::string& switches,
                          const Points& inside) {
    WireWriter request;
    request.text(inside.rows() > 0 ? switches + "i" : switches);
    request.matrix(surface.V);
    request.matrix(surface.F);
    request.matrix(inside);
    // Twice what a long thin part with steep grading was seen to need; only a runaway reaches it.
    const WorkerLimits limits = {.megabytes = 1024 + surface.faceCount() / 32,
                                 .seconds = 60 + surface.faceCount() / 500};
    const Result<std::string> answer = askWorker(WorkerJob::Tetrahedralize, request.bytes(), limits, task);
    if (!answer)
        return std::unexpected(answer.error());
    WireReader reader(*answer);
    TetMesh tets;
    tets.V = reader.matrix<Points>();
    tets.T = reader.matrix<Tetrahedra>();
    if (!reader.whole())
        return wrongAnswer(MW_TEXT("exchange", "The worker program's answer is incomplete."));
    return checked(std::move(tets), surface, inside);
}

} // namespace

std::vector<int> innerPoints(const TetMesh& tets, int surfacePoints, const Points& inside) {
    std::vector<int> found(static_cast<std::size_t>(inside.rows()), -1);
    for (Eigen::Index i = 0; i < inside.rows(); ++i)
        for (Eigen::Index v = surfacePoints; v < tets.V.rows(); ++v)
            if (tets.V.row(v) == inside.row(i))
                found[static_cast<std::size_t>(i)] = static_cast<int>(v);
    return found;
}

Result<TetMesh> tetrahedralize(const IndexedMesh& surface, const Task& task, const std::string& switches,
                               const Points& inside) {
    Result<TetMesh> tets = askTetGen(surface, task, switches, inside);
    if (tets || inside.rows() == 0 || tets.error().code != ErrorCode::Worker || task.stopped())
        return tets;
    // TetGen crashes on some points inside of surfaces that it fills well without.
    Result<TetMesh> without = askTetGen(surface, task, switches, Points(0, 3));
    if (!without)
        return tets;
    for (const auto& point : inside.rowwise())
        if (!insertPoint(*without, point.transpose()))
            return tets;
    return checked(std::move(*without), surface, inside);
}

} // namespace moldwright
