// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/dock_title.h"

#include "theme/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace moldwright {

namespace {

QToolButton* titleButton(const QString& iconName, const QString& words, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(themeIcon(iconName));
    button->setIconSize({14, 14});
    button->setAutoRaise(true);
    button->setFixedSize(22, 22);
    button->setToolTip(words);
    button->setAccessibleName(words);
    return button;
}

} // namespace

Dock::Dock(const QString& name, const QString& title, QWidget* content, QWidget* parent)
    : QDockWidget(title, parent) {
    setObjectName(name);
    auto* bar = new QWidget(this);
    m_title = bar;
    m_noTitle = new QWidget(this);
    m_noTitle->hide();
    bar->setFixedHeight(28);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(10, 0, 4, 0);
    row->setSpacing(2);
    auto* label = new QLabel(title, bar);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    row->addWidget(label, 1);
    QToolButton* floatButton = titleButton(QStringLiteral("float"), tr("Float or dock %1").arg(title), bar);
    connect(floatButton, &QToolButton::clicked, this, [this] { setFloating(!isFloating()); });
    row->addWidget(floatButton);
    QToolButton* closeButton = titleButton(QStringLiteral("close"), tr("Close %1").arg(title), bar);
    connect(closeButton, &QToolButton::clicked, this, [this] {
        close();
        Q_EMIT closed();
    });
    row->addWidget(closeButton);
    connect(this, &QDockWidget::windowTitleChanged, label, &QLabel::setText);
    setTitleBarWidget(bar);
    setWidget(content);
}

void Dock::setTitleShown(bool shown) {
    QWidget* wanted = shown ? m_title : m_noTitle;
    if (titleBarWidget() == wanted)
        return;
    titleBarWidget()->hide();
    setTitleBarWidget(wanted);
    wanted->show();
}

} // namespace moldwright
