// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/arrow_layer.h"

#include <Eigen/Geometry>

#include <vtkMatrix4x4.h>
#include <vtkProperty.h>

namespace moldwright::scene {

ArrowLayer::ArrowLayer() {
    m_shape->SetTipResolution(24);
    m_shape->SetShaftResolution(16);
    m_shape->SetTipLength(0.42);
    m_shape->SetTipRadius(0.13);
    m_shape->SetShaftRadius(0.05);
    m_mapper->SetInputConnection(m_shape->GetOutputPort());
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->SetAmbient(0.25);
    m_actor->GetProperty()->SetDiffuse(0.8);
    m_actor->GetProperty()->SetSpecular(0.15);
    m_actor->PickableOff();
}

void ArrowLayer::set(const Eigen::Vector3d& tail, const Eigen::Vector3d& direction, double length) {
    const Eigen::Matrix3d turn =
        length * Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), direction).toRotationMatrix();
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix->SetElement(row, column, turn(row, column));
        matrix->SetElement(row, 3, tail[row]);
    }
    m_actor->SetUserMatrix(matrix);
}

void ArrowLayer::setColour(Rgb colour) {
    m_actor->GetProperty()->SetColor(colour.unit().data());
}

} // namespace moldwright::scene
