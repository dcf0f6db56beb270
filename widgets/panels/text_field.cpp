// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/text_field.h"

#include <QKeyEvent>

namespace moldwright {

bool TextField::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* keys = static_cast<QKeyEvent*>(event);
        const bool nothing = (keys->matches(QKeySequence::Undo) && !isUndoAvailable()) ||
                             (keys->matches(QKeySequence::Redo) && !isRedoAvailable());
        if (nothing) {
            event->ignore();
            return true;
        }
    }
    return QLineEdit::event(event);
}

} // namespace moldwright
