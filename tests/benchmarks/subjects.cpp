// SPDX-License-Identifier: AGPL-3.0-or-later
#include "benchmarks/subjects.h"

#include "castability/plane_search.h"
#include "exchange/mesh_file.h"
#include "exchange/tetrahedralize.h"
#include "mesh/check.h"
#include "mesh/decimate.h"
#include "mesh/measures.h"
#include "mesh/subdivide.h"
#include "support/folders.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

namespace moldwright::bench {

namespace {

constexpr double kSize = 80; ///< longest side, mm

struct Row {
    const char* name;
    const char* sample;
    int vertices;
};
constexpr std::array<Row, 4> kRows = {Row{"beam", "bent_beam.ply", 464}, Row{"fish", "fish.ply", 4290},
                                      Row{"hand", "hand.ply", 7234}, Row{"rabbit", "rabbit.ply", 14290}};

template <class T>
T valueOf(Result<T> result) {
    if (!result)
        throw std::runtime_error(result.error().english());
    return std::move(*result);
}

/// A closed surface of genus 0 has two faces fewer than twice its vertices, twice.
IndexedMesh withVertices(IndexedMesh mesh, int vertices) {
    if (mesh.vertexCount() < vertices)
        mesh = subdivide(mesh, 1);
    return decimate(mesh, 2 * vertices - 4);
}

SharedMesh partOf(const Row& row) {
    IndexedMesh mesh = withVertices(valueOf(readMesh(test::samples() / row.sample)).mesh, row.vertices);
    mesh.V *= kSize / boundingBox(mesh).sizes().maxCoeff();
    return std::make_shared<const IndexedMesh>(valueOf(prepare(mesh, row.name)).mesh);
}

Subject make(const Row& row) {
    const SharedMesh part = partOf(row);
    PlaneSearch search;
    search.count = 1;
    const MoldState state = findPlanes(*part, search).at(0).state;
    const WorkingFrame frame(*part, state);
    const IndexedMesh surface = frame.toWork(*part);
    const TetMesh tets = valueOf(tetrahedralize(surface));
    BodyShape body;
    body.V = tets.V;
    body.T = tets.T;
    body.F = surface.F;
    return {row.name, part, state, frame, body};
}

} // namespace

void eachSubject(benchmark::internal::Benchmark* benchmark) {
    benchmark->DenseRange(0, kRows.size() - 1)
        ->ArgName("row")
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

const Subject& subjectOf(benchmark::State& state) {
    static std::array<std::optional<Subject>, kRows.size()> made;
    const auto row = static_cast<std::size_t>(state.range(0));
    if (!made[row])
        made[row] = make(kRows[row]);
    const Subject& subject = *made[row];
    state.SetLabel(subject.name);
    state.counters["vertices"] = subject.part->vertexCount();
    state.counters["tets"] = static_cast<double>(subject.body.T.rows());
    return subject;
}

DesignResult designOf(const Subject& subject) {
    DesignRequest request;
    request.part = subject.part;
    return valueOf(design(request));
}

SideLabels sidesOf(const BodyShape& body) {
    SideLabels sides;
    for (Eigen::Index f = 0; f < body.F.rows(); ++f) {
        const Eigen::Vector3d z(body.V(body.F(f, 0), 2), body.V(body.F(f, 1), 2), body.V(body.F(f, 2), 2));
        sides.push_back(z.minCoeff() >= 0 ? 1 : z.maxCoeff() <= 0 ? 2 : 0);
    }
    return sides;
}

} // namespace moldwright::bench
