// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

namespace moldwright {

/// What is chosen in tree and views is a text: the id of a row, or those of several pins, several regions or
/// several features of the mold, parted by spaces, the one chosen last at the end.

/// How a click takes a row into what is chosen.
enum class Choosing {
    Only,    ///< it and nothing else
    Toggle,  ///< Ctrl
    Add,     ///< Shift
    Subtract ///< Alt
};
[[nodiscard]] Choosing choosingBy(Qt::KeyboardModifiers keys);

/// The rows chosen, one by one; never none.
[[nodiscard]] QStringList chosenIds(const QString& chosen);

/// Whether more than one is.
[[nodiscard]] bool severalChosen(const QString& chosen);

/// What is chosen after these rows were clicked or boxed. Rows of another kind than those chosen replace
/// them, as do rows of which only one can be chosen; the last one chosen stays.
[[nodiscard]] QString chosenWith(const QString& chosen, const QStringList& ids, Choosing how);

/// The rows of `ids` that can be chosen together with the last of them, that one at the end.
[[nodiscard]] QString chosenTogether(const QStringList& ids);

} // namespace moldwright
