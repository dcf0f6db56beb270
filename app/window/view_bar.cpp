// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/view_bar.h"

#include "panels/plain_text.h"
#include "window/action_table.h"

#include <QComboBox>
#include <QLabel>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

QLabel* barLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setContentsMargins(6, 0, 4, 0);
    return label;
}

} // namespace

ViewBar::ViewBar(const Actions& actions, QWidget* parent) : QToolBar(parent) {
    setFixedHeight(36);
    setMovable(false);
    setIconSize({20, 20});
    setAccessibleName(tr("Tools of the view"));
    addTool(actions[u"lay-flat"_s]);
    addSeparator();
    addWidget(barLabel(tr("Show"), this));
    m_mode = new QComboBox(this);
    m_mode->addItems(displayModeNames());
    m_mode->setFixedHeight(24);
    m_mode->setMinimumWidth(140);
    m_mode->setAccessibleName(tr("What the faces show"));
    m_mode->setObjectName(u"display-mode"_s);
    connect(m_mode, &QComboBox::activated, this,
            [this](int index) { Q_EMIT modeChosen(static_cast<DisplayMode>(index)); });
    addWidget(m_mode);
    addSeparator();
    for (const QString& id : {u"show-plane"_s, u"show-directions"_s, u"show-edges"_s, u"see-through"_s,
                              u"measure"_s, u"section"_s})
        addTool(actions[id]);
    auto* space = new QWidget(this);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(space);
    for (const QString& id : {u"one-view"_s, u"two-views"_s, u"four-views"_s, u"link-views"_s})
        addTool(actions[id]);
    addSeparator();
    for (const QString& id : {u"fit"_s, u"perspective"_s, u"screenshot"_s})
        addTool(actions[id]);
}

void ViewBar::addTool(QAction* action) {
    addAction(action);
    QWidget* button = widgetForAction(action);
    button->setFixedSize(28, 28);
    button->setAccessibleName(plainText(action->text()));
}

void ViewBar::setMode(DisplayMode mode) {
    m_mode->setCurrentIndex(static_cast<int>(mode));
}

void ViewBar::setModesEnabled(bool enabled) {
    m_mode->setEnabled(enabled);
}

} // namespace moldwright
