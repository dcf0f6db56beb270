// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDialog>

#include <Eigen/Core>

#include <optional>

class QComboBox;

namespace moldwright {

class QuantitySpinBox;

/// Asks for an axis through the part's middle and an angle; what is set is told while it changes, so that it
/// can be seen.
class TurnDialog : public QDialog {
    Q_OBJECT
public:
    /// `planeNormal` is offered as an axis when there is a plane.
    explicit TurnDialog(const std::optional<Eigen::Vector3d>& planeNormal, QWidget* parent = nullptr);

    [[nodiscard]] Eigen::Vector3d axis() const;
    [[nodiscard]] double degrees() const;

Q_SIGNALS:
    void previewed();

private:
    Eigen::Vector3d m_planeNormal;
    QComboBox* m_axis;
    QuantitySpinBox* m_angle;
};

} // namespace moldwright
