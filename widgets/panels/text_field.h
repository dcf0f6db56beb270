// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace moldwright {

/// A field for a short text that leaves Undo and Redo to the program where it has nothing typed to take back.
class TextField : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

protected:
    bool event(QEvent* event) override;
};

} // namespace moldwright
