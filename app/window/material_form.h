// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "materials/material.h"

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPlainTextEdit;

namespace moldwright {

class QuantitySpinBox;

/// All that a table knows of a material, to be read and changed. Words of the program's own table are shown
/// in the user's language and stay as they are until they are changed.
class MaterialForm : public QWidget {
    Q_OBJECT
public:
    explicit MaterialForm(QWidget* parent = nullptr);

    /// Shows a material; tells nobody.
    void setMaterial(const Material& material);

    /// The one shown, with what was typed since.
    [[nodiscard]] Material material() const;

Q_SIGNALS:
    void edited();

private:
    /// The fields of a value: number, range, source, status.
    struct ValueFields {
        QuantitySpinBox* number = nullptr;
        QLineEdit* range = nullptr;
        QLineEdit* source = nullptr;
        QComboBox* status = nullptr;
    };

    void addWords(QFormLayout* form);
    void addValues(QFormLayout* form);
    void addSteps(QFormLayout* form);
    QLineEdit* makeLine(const QString& name, const QString& id);
    ValueFields makeValue(const QString& label, const QString& unit, double least, double most, int decimals,
                          const QString& id, QFormLayout* form);
    void tellEdited();
    static void show(const ValueFields& fields, const MaterialValue& value);
    static MaterialValue read(const ValueFields& fields, MaterialValue value);

    Material m_shown;
    bool m_filling = false;
    QLineEdit* m_name = nullptr;
    QLineEdit* m_process = nullptr;
    QComboBox* m_formula = nullptr;
    ValueFields m_shrink, m_draft, m_density, m_vents;
    QPlainTextEdit* m_notes = nullptr;
    std::array<QPlainTextEdit*, 4> m_steps{}; ///< sealing, release, filling, setting
    QLineEdit* m_stepsSource = nullptr;
};

} // namespace moldwright
