// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/half_layer.h"

#include "mesh/measures.h"
#include "scene/camera.h"

#include <vtkMatrix4x4.h>

namespace moldwright::scene {

void HalfLayer::set(const SharedMesh& half, const Eigen::Isometry3d& moldToPart,
                    const Eigen::Vector3d& direction, Rgb colour) {
    m_moldToPart = moldToPart;
    m_direction = direction;
    m_layer.setMesh(half, colour);
    open(m_way);
}

void HalfLayer::open(double way) {
    m_way = way;
    Eigen::Isometry3d placed = m_moldToPart;
    placed.pretranslate(way * m_direction);
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix->SetElement(row, column, placed.matrix()(row, column));
    m_layer.actor()->SetUserMatrix(matrix);
}

std::vector<Eigen::Vector3d> HalfLayer::corners() const {
    if (!shown())
        return {};
    std::vector<Eigen::Vector3d> corners = cornersOf(boundingBox(*m_layer.mesh()));
    for (Eigen::Vector3d& corner : corners)
        corner = m_moldToPart * corner + m_way * m_direction;
    return corners;
}

} // namespace moldwright::scene
