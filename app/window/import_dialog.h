// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "window/workbench.h"

#include <QDialog>

class QComboBox;
class QLabel;

namespace moldwright {

class QuantitySpinBox;

/// What a file's numbers most likely mean.
struct SizeGuess {
    Unit unit = Unit::Millimetre;
    double scale = 1; ///< file's numbers to mm
};

/// The likeliest reading of a mesh whose longest side measures `longest` in the file's numbers: millimetres
/// when that gives a part one would cast, else a part 80 mm long.
[[nodiscard]] SizeGuess guessSize(double longest);

/// Asks once for unit and size of an imported mesh, with the likeliest chosen.
class ImportDialog : public QDialog {
    Q_OBJECT
public:
    ImportDialog(const OpenedMesh& opened, QWidget* parent = nullptr);

    [[nodiscard]] Unit unit() const;
    [[nodiscard]] double scale() const;

private:
    void unitChosen(int index);

    double m_longest;
    Eigen::Vector3d m_size;
    QComboBox* m_unit;
    QuantitySpinBox* m_length;
    QLabel* m_result;
};

} // namespace moldwright
