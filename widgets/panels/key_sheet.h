// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/navigation.h"

#include <QDialog>

#include <vector>

class QAction;

namespace moldwright {

/// All keys on one sheet, made from the commands themselves, with the mouse of the navigation in use.
class KeySheet : public QDialog {
    Q_OBJECT
public:
    KeySheet(const std::vector<QAction*>& commands, const scene::NavigationScheme& navigation,
             QWidget* parent = nullptr);
};

/// A drag of the mouse in words, as "Shift + middle button".
[[nodiscard]] QString wordsFor(const scene::Held& held);

} // namespace moldwright
