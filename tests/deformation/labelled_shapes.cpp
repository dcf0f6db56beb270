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

} // namespace moldwright::test
