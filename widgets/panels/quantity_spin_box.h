// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

#include <optional>

namespace moldwright {

/// The value of what was typed, in `unit`: sums and products ("3*4", "10 + 2.5"), fractions ("1/2"), and
/// another unit of length behind it ("1/2 in", "2 cm") converted to mm. None when it makes no sense.
[[nodiscard]] std::optional<double> quantityFromText(QString text, const QString& unit);

/// A number field with its unit inside, right-aligned, that takes small sums and other units. It shows a true
/// minus sign.
class QuantitySpinBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    QuantitySpinBox(const QString& unit, int decimals, QWidget* parent = nullptr);

    [[nodiscard]] QString textFromValue(double value) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;

    /// Several values are meant, which differ: it says so instead of one, until one is set.
    void setMixed(bool mixed);
    [[nodiscard]] bool mixed() const { return !specialValueText().isEmpty(); }

protected:
    [[nodiscard]] StepEnabled stepEnabled() const override;

private:
    QString m_unit;
};

} // namespace moldwright
