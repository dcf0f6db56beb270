// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/quantity_spin_box.h"

#include <QRegularExpression>
#include <QSignalBlocker>

#include <array>

namespace moldwright {

namespace {

constexpr QChar minusSign(0x2212);

struct LengthUnit {
    const char* name;
    double millimetres;
};
constexpr std::array lengthUnits = {LengthUnit{"mm", 1}, LengthUnit{"cm", 10}, LengthUnit{"in", 25.4},
                                    LengthUnit{"m", 1000}};

/// Reads sums and products from left to right; '×' and ',' are understood.
class Sum {
public:
    explicit Sum(QString text) : m_text(std::move(text)) {}

    std::optional<double> value() {
        const std::optional<double> all = sum();
        return m_at == m_text.size() ? all : std::nullopt;
    }

private:
    std::optional<double> sum() {
        std::optional<double> left = product();
        while (left && m_at < m_text.size() && (peek() == u'+' || peek() == u'-')) {
            const bool minus = m_text[m_at++] == u'-';
            const std::optional<double> right = product();
            left = right ? std::optional(*left + (minus ? -*right : *right)) : std::nullopt;
        }
        return left;
    }

    std::optional<double> product() {
        std::optional<double> left = number();
        while (left && m_at < m_text.size() && (peek() == u'*' || peek() == u'/')) {
            const bool over = m_text[m_at++] == u'/';
            const std::optional<double> right = number();
            left = right && (!over || *right != 0) ? std::optional(over ? *left / *right : *left * *right)
                                                   : std::nullopt;
        }
        return left;
    }

    std::optional<double> number() {
        static const QRegularExpression pattern(QStringLiteral("[+-]?[0-9]*\\.?[0-9]+|[+-]?[0-9]+\\.?"));
        const auto match = pattern.match(m_text, m_at, QRegularExpression::NormalMatch,
                                         QRegularExpression::AnchorAtOffsetMatchOption);
        if (!match.hasMatch())
            return std::nullopt;
        m_at = match.capturedEnd();
        return match.captured().toDouble();
    }

    [[nodiscard]] QChar peek() const { return m_text[m_at]; }

    QString m_text;
    qsizetype m_at = 0;
};

} // namespace

std::optional<double> quantityFromText(QString text, const QString& unit) {
    text.replace(minusSign, u'-').replace(u'×', u'*').replace(u',', u'.');
    text.remove(QRegularExpression(QStringLiteral("\\s")));
    double factor = 1;
    // A field's own unit may stand behind a typed one: "2 in mm" is two inches.
    if (!unit.isEmpty() && text.endsWith(unit))
        text.chop(unit.size());
    if (unit == QStringLiteral("mm"))
        for (const LengthUnit& length : lengthUnits)
            if (const QString name = QString::fromLatin1(length.name); text.endsWith(name)) {
                text.chop(name.size());
                factor = length.millimetres;
                break;
            }
    const std::optional<double> value = Sum(text).value();
    return value ? std::optional(*value * factor) : std::nullopt;
}

QuantitySpinBox::QuantitySpinBox(const QString& unit, int decimals, QWidget* parent)
    : QDoubleSpinBox(parent), m_unit(unit) {
    setDecimals(decimals);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setKeyboardTracking(false);
    setFixedHeight(24);
    if (!unit.isEmpty())
        setSuffix((unit == QStringLiteral("°") ? QString() : QStringLiteral(" ")) + unit);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] { setSpecialValueText({}); });
}

void QuantitySpinBox::setMixed(bool mixed) {
    // The least value gives way to the word: nobody types that one.
    const QSignalBlocker quiet(this);
    setSpecialValueText(mixed ? tr("mixed") : QString());
    if (mixed)
        setValue(minimum());
}

QAbstractSpinBox::StepEnabled QuantitySpinBox::stepEnabled() const {
    return mixed() ? StepEnabled(StepNone) : QDoubleSpinBox::stepEnabled();
}

QString QuantitySpinBox::textFromValue(double value) const {
    QString text = QString::number(value, 'f', decimals());
    return text.replace(u'-', minusSign);
}

double QuantitySpinBox::valueFromText(const QString& text) const {
    return quantityFromText(text, m_unit).value_or(value());
}

QValidator::State QuantitySpinBox::validate(QString& text, int&) const {
    const std::optional<double> typed = quantityFromText(text, m_unit);
    return typed && *typed >= minimum() && *typed <= maximum() ? QValidator::Acceptable
                                                               : QValidator::Intermediate;
}

} // namespace moldwright
