// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/labelled_shapes.h"

#include "castability/parting_curves.h"
#include "mesh/check.h"
#include "support/shapes.h"
#include "support/solids.h"

namespace moldwright::test {

SideLabels labelsByHeight(const IndexedMesh& mesh) {
    SideLabels labels;
    for (int f = 0; f < mesh.faceCount(); ++f)
        labels.push_back(mesh.corner(f, 0).z() + mesh.corner(f, 1).z() + mesh.corner(f, 2).z() > 0 ? 1 : 2);
    return labels;
}

LabelledSurface labelledBall(int rounds) {
    LabelledSurface surface{};
    surface.mesh = sphere(Eigen::Vector3d::Zero(), 0.5, rounds);
    surface.labels = labelsByHeight(surface.mesh);
    for (int v = 0; v < surface.mesh.vertexCount(); ++v)
        surface.sourceVertex.push_back(v);
    return surface;
}

LabelledBody labelledBox() {
    const Solid solid = solidBox({-0.4, -0.3, -0.25}, {0.4, 0.3, 0.25}, {4, 3, 4});
    LabelledBody body;
    body.shape = {solid.tets.V, solid.tets.T, solid.F, {}, 0.5, 5};
    body.labels = labelsByHeight({solid.tets.V, solid.F});
    body.held.assign(static_cast<std::size_t>(solid.tets.V.rows()), 0);
    for (Eigen::Index f = 0; f < solid.F.rows(); ++f)
        for (int k = 0; k < 3; ++k)
            body.held[static_cast<std::size_t>(solid.F(f, k))] = solid.tets.V(solid.F(f, k), 2) == 0;
    return body;
}

bool soundlyParted(const LabelledSurface& surface) {
    const MeshDiagnosis diagnosis = diagnose(surface.mesh);
    if (!diagnosis.closed || !diagnosis.manifold || !diagnosis.oriented)
        return false;
    for (int f = 0; f < surface.mesh.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (surface.mesh.corner(f, k).z() * (surface.labels[static_cast<std::size_t>(f)] == 1 ? 1 : -1) <
                0)
                return false;
    const auto curves = partingCurves(surface.mesh, surface.labels);
    if (!curves || curves->empty())
        return false;
    const CurveNesting nesting = nestingAlong(surface.mesh.V, *curves, Eigen::Vector3d::UnitZ());
    return nesting.simple && nesting.alternating;
}

LabelledSurface finInThePlane() {
    constexpr int corners = 12;
    constexpr int top = corners;
    constexpr int bottom = corners + 1;
    constexpr int tip = corners + 2;
    LabelledSurface surface;
    surface.mesh.V.resize(corners + 3, 3);
    for (int i = 0; i < corners; ++i)
        surface.mesh.V.row(i) << std::cos(2 * std::numbers::pi * i / corners),
            std::sin(2 * std::numbers::pi * i / corners), 0;
    surface.mesh.V.row(top) << 0, 0, 1;
    surface.mesh.V.row(bottom) << 0, 0, -1;
    surface.mesh.V.row(tip) = 0.55 * (surface.mesh.V.row(0) + surface.mesh.V.row(1));
    std::vector<Eigen::Vector3i> faces{{0, tip, 2}, {tip, 1, 2}, {0, 2, top}};
    for (int i = 2; i < corners; ++i)
        faces.emplace_back(i, (i + 1) % corners, top);
    const std::size_t above = faces.size();
    faces.emplace_back(1, tip, 0);
    for (int i = 0; i < corners; ++i)
        faces.emplace_back((i + 1) % corners, i, bottom);
    surface.mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        surface.mesh.F.row(static_cast<Eigen::Index>(f)) = faces[f].transpose();
        surface.labels.push_back(f < above ? 1 : 2);
    }
    surface.sourceVertex.resize(corners + 3);
    std::iota(surface.sourceVertex.begin(), surface.sourceVertex.end(), 0);
    return surface;
}

} // namespace moldwright::test
