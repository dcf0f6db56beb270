// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/mold_fields.h"

#include <type_traits>
#include <utility>

namespace moldwright {

/// Lengths from `least` to `most`, in steps of half a millimetre.
[[nodiscard]] inline NumberProperty millimetres(double least, double most, bool slider = false) {
    return {QStringLiteral("mm"), least, most, 0.5, 1, slider};
}

/// Degrees in steps of half a degree.
[[nodiscard]] inline NumberProperty degreesFrom(double least, double most) {
    return {QStringLiteral("°"), least, most, 0.5, 1, false};
}

/// A field for one number, found by `place` in settings to be read and in settings to be written.
template <class Place>
[[nodiscard]] MoldField numberField(const QString& id, const QString& label, const QString& help,
                                    NumberProperty kind, Place place) {
    return {{id, label, help, std::move(kind)},
            [place](const MoldSettings& mold) { return static_cast<double>(place(mold)); },
            [place](MoldSettings& mold, const QVariant& value) {
                auto& number = place(mold);
                number = static_cast<std::remove_reference_t<decltype(number)>>(value.toDouble());
            }};
}

/// The same for a number of things, 0 to `most`.
template <class Place>
[[nodiscard]] MoldField countField(const QString& id, const QString& label, const QString& help, int most,
                                   Place place) {
    return numberField(id, label, help, NumberProperty{{}, 0, static_cast<double>(most), 1, 0, false}, place);
}

/// A field for one of the values of an enumeration, or for yes and no; `choices` in their order.
template <class Place>
[[nodiscard]] MoldField choiceField(const QString& id, const QString& label, const QString& help,
                                    const QStringList& choices, Place place) {
    return {{id, label, help, ChoiceProperty{choices}},
            [place](const MoldSettings& mold) { return static_cast<double>(place(mold)); },
            [place](MoldSettings& mold, const QVariant& value) {
                auto& choice = place(mold);
                choice = static_cast<std::remove_reference_t<decltype(choice)>>(value.toInt());
            }};
}

} // namespace moldwright
