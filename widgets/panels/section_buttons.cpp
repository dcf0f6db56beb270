// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/section_buttons.h"

#include "panels/plain_text.h"
#include "theme/icons.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPushButton>

#include <algorithm>

namespace moldwright {

namespace {

constexpr int buttonGap = 6;

/// Fills the button with the accent colour, or not.
void setFilled(QPushButton* button, bool filled) {
    if (button->property("primary").toBool() == filled)
        return;
    button->setProperty("primary", filled);
    button->updateGeometry(); // a filled button's words are bold
    button->update();
}

/// Whether the button of an action is filled: of tools the one in use, else what is to be done next.
bool isFilled(const QAction* action, const PropertySection& section) {
    if (std::ranges::any_of(section.buttons, &QAction::isChecked))
        return action->isChecked();
    return section.primary && action == section.buttons.front();
}

/// A push button that shows an action of a section: text, icon, tool tip, enabled, as the action says.
QPushButton* actionButton(QAction* action, const PropertySection& section, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setProperty("primary", false);
    button->setObjectName(QStringLiteral("button-") + action->objectName());
    button->setMinimumHeight(28);
    const auto follow = [button, action, section] {
        const bool filled = isFilled(action, section);
        setFilled(button, filled);
        button->setText(plainText(action->text()));
        button->setIcon(filled && action->isEnabled()
                            ? tintedIcon(action->property("iconName").toString(), Qt::white)
                            : action->icon());
        button->setEnabled(action->isEnabled());
        button->setVisible(action->isVisible());
        button->setToolTip(action->toolTip());
    };
    follow();
    for (const QAction* any : section.buttons)
        QObject::connect(any, &QAction::changed, button, follow);
    QObject::connect(button, &QPushButton::clicked, action, [action] { action->trigger(); });
    return button;
}

} // namespace

void addSectionButtons(const PropertySection& section, int width, QWidget* parent, QVBoxLayout* column) {
    QHBoxLayout* line = nullptr;
    int room = 0;
    for (std::size_t i = 0; i < section.buttons.size(); ++i) {
        const bool first = i == 0 && section.primary;
        QPushButton* button = actionButton(section.buttons[i], section, parent);
        const bool alone = first && section.buttons.size() % 2 == 1;
        const int wanted = button->sizeHint().width();
        if (!line || line->count() == 2 || alone || wanted > room) {
            line = new QHBoxLayout;
            line->setSpacing(buttonGap);
            column->addLayout(line);
            room = width;
        }
        line->addWidget(button, 1);
        room -= wanted + buttonGap;
        if (alone)
            line = nullptr;
    }
}

} // namespace moldwright
